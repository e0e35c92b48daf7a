"""Named classes of English words, which rules compare with a sentence."""

from word_classes.shipped import UnknownWordClass, without_determiner, word_class, word_classes, word_list
from word_classes.word_file import WordClass, load_word_classes

__all__ = [
    "UnknownWordClass",
    "WordClass",
    "load_word_classes",
    "without_determiner",
    "word_class",
    "word_classes",
    "word_list",
]
