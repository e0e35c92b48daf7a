"""How far a question goes: the words around it, and what is said beside it."""

from itertools import dropwhile, takewhile
from typing import List, Sequence

from semantic_framer.kinds.question_words import length_behind, length_in_front, phrases_of
from semantic_framer.values.sentence import Sentence
from utterance_passes.trees.tree import Word
from word_classes import word_class

_PADDING = word_class("lead_in") - word_class("ordinals") | word_class("exact_adverbs") | word_class("robot_names")
_COURTESIES = phrases_of("question_courtesies")
_ENDINGS = phrases_of("question_courtesies", place=-1)
_ASKING = word_class("question_words")
_DETERMINERS = word_class("determiners")
_CONJUNCTIONS = word_class("clause_borders")
_MODALS = word_class("modals")
_SUBJECTS = word_class("subject_pronouns")
_MARKS = frozenset("?!")


def words_of_question(sentence: Sentence) -> List[Word]:
    """Return the words of a sentence without the words around a question."""
    tree = sentence.tree
    hidden = tree.abandoned | tree.fillers
    words = [word for word in tree.words if word.index not in hidden and word.upos != "PUNCT"]
    while words:
        forms = [word.said for word in words]
        in_front = _length_in_front(forms)
        behind = 0 if in_front else _length_behind(forms)
        if not in_front and not behind:
            break
        words = words[in_front : len(words) - behind]
    return words


def _length_in_front(forms: Sequence[str]) -> int:
    """Return the number of words that stand in front of a question: 2 for "excuse me, where is the mug"."""
    return length_in_front(_COURTESIES, forms) or int(forms[0] in _PADDING)


def _length_behind(forms: Sequence[str]) -> int:
    """Return the number of words that stand behind a question: 2 for "is the lamp on right now"."""
    found = length_behind(_ENDINGS, forms)
    # "Are you a robot?" does not speak to a robot: nobody who is spoken to has an article.
    is_noun = len(forms) > 1 and forms[-2] in _DETERMINERS
    return found or int(forms[-1] in _PADDING and not is_noun)


def ends_inside(sentence: Sentence, words: Sequence[Word]) -> bool:
    """Whether a sentence ends between words: a pattern would read the next one as a part of the question."""
    return bool(words) and any(_is_end(sentence, index) for index in range(words[0].index + 1, words[-1].index))


def is_said_alone(sentence: Sentence) -> bool:
    """Whether nothing is said beside a question: "Where is the mug? Bring it to me." says more."""
    return not ends_inside(sentence, words_of_question(sentence))


def up_to_its_end(sentence: Sentence, positions: Sequence[int]) -> List[int]:
    """Return the first of some words in order, up to the end of the sentence in which they begin."""
    behind_marks = dropwhile(lambda index: sentence.word(index).upos == "PUNCT", positions)
    return list(takewhile(lambda index: not _is_end(sentence, index), behind_marks))


def _is_end(sentence: Sentence, index: int) -> bool:
    """Whether a word is the mark at the end of a sentence, and not that of "room no. 5"; or joins another question."""
    form, words = sentence.word(index).form, sentence.tree.words
    if form.lower() in _CONJUNCTIONS:
        behind = [word.said for word in words[index : index + 2]]
        # "How many cups are there *and how* many plates", "... *or should I* buy some".
        return bool(behind) and (behind[0] in _ASKING or (behind[0] in _MODALS and set(behind[1:]) <= _SUBJECTS))
    return form in _MARKS or (form == "." and (index == len(words) or words[index].form[:1].isupper()))
