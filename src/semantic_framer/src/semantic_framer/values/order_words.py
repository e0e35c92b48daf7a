"""Words for the ends of a row of deeds or items: "first", "last"."""

from word_classes import word_class, word_list

FIRST = frozenset(word_list("ordinals")[:1])
LAST = word_class("last_ordinals")
