"""Named classes of English words, which rules compare with a sentence."""

from word_classes.pattern_reader import fill_pattern, read_pattern
from word_classes.shipped import UnknownWordClass, without_determiner, word_class, word_classes, word_list
from word_classes.short_answers import agreement, in_words
from word_classes.turned_round import turned_round
from word_classes.word_file import WordClass, load_word_classes

__all__ = [
    "UnknownWordClass",
    "WordClass",
    "agreement",
    "fill_pattern",
    "in_words",
    "load_word_classes",
    "read_pattern",
    "turned_round",
    "without_determiner",
    "word_class",
    "word_classes",
    "word_list",
]
