"""FrameNet's semantic types of words: nouns from WordNet, and names that the robot knows."""

from semantic_types.likelihood import UNTYPED, Fit, Likelihoods
from semantic_types.name_file import Names, checked_names, load_name_file, spoken
from semantic_types.nouns import shipped_nouns
from semantic_types.word_types import WordTypes, shipped_types
from semantic_types.wordnet import NoWordNet

__all__ = [
    "UNTYPED",
    "Fit",
    "Likelihoods",
    "Names",
    "NoWordNet",
    "WordTypes",
    "checked_names",
    "load_name_file",
    "shipped_nouns",
    "shipped_types",
    "spoken",
]
