"""Offers the readings of a sentence to a person, and finds the one that the next utterance picks."""

from typing import Iterable, List, Optional, Sequence, Tuple

from roboframenet_ros.spoken_text import join_with_or
from semantic_framer.values.dialogue import is_yes
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from utterance_passes.engine.utterance_pass import Choice
from utterance_passes.phrases.clauses import Clause, find_clauses
from utterance_passes.phrases.measures import find_amounts
from utterance_passes.phrases.verb_matching import match_verbs
from utterance_passes.trees.tree import ABANDONED
from utterance_passes.trees.tree_edits import set_aside
from utterance_passes.trees.vocabulary import Vocabulary, is_verb
from word_classes import word_class, word_list

_CHOICE_NOUNS = word_class("noun_standins")
_ORDINALS = {
    "former": 0,
    **{word: place for place, word in enumerate(word_list("ordinals"))},
    **dict.fromkeys(word_list("last_ordinals"), -1),
}
#: Words that do not distinguish one choice from another.
_COMMON = word_class("articles") | (word_class("harmless") - frozenset(_ORDINALS))


def question_of_choices(choices: Sequence[Choice]) -> str:
    """Return the question that asks which of several readings was meant, or whether the only one was."""
    quoted = [f'"{choice.text}"' for choice in choices]
    return f"Do you mean {quoted[0]}?" if len(quoted) == 1 else f"Which do you mean: {join_with_or(quoted)}?"


def choices_left_open(
    sentence: Sentence, clauses: Sequence[Tuple[Clause, Reading]], vocabulary: Vocabulary
) -> Tuple[Choice, ...]:
    """Return what a person left open, as choices: clauses that "or" joins, or the ends of a range; none for nothing.

    Args:
        sentence: the sentence
        clauses: each with its best reading
        vocabulary: its verbs decide which word is the root
    """
    return _choices_of_clauses(sentence, [clause for clause, _ in clauses], vocabulary) or _choices_of_amounts(
        sentence, [reading for _, reading in clauses], vocabulary
    )


def _choices_of_clauses(sentence: Sentence, clauses: Sequence[Clause], vocabulary: Vocabulary) -> Tuple[Choice, ...]:
    """Return the clauses that "or" joins ("turn left or go back"), as choices; nothing if there is no such "or"."""
    verbs = {clause.verb for clause in clauses}
    if not any(word.said == "or" and word.deprel == "cc" and word.head in verbs for word in sentence.tree.words):
        return ()
    choices = []
    for clause in clauses:
        said = [index for index in sorted(clause.positions) if sentence.word(index).deprel not in ("punct", "cc")]
        others = frozenset(word.index for word in sentence.tree.words) - frozenset(said)
        tree = set_aside(sentence.tree, others, ABANDONED, lambda word: is_verb(vocabulary, word))
        choices.append(Choice(sentence.text(said), tree))
    return tuple(choices)


def _choices_of_amounts(sentence: Sentence, readings: Sequence[Reading], vocabulary: Vocabulary) -> Tuple[Choice, ...]:
    """Return the ends of a range ("ten to fifteen degrees") as choices; nothing unless there is exactly one range.

    Args:
        sentence: the sentence
        readings: the best one of each clause
        vocabulary: its verbs decide which word is the root
    """
    ranges = [amount for reading in readings for amount in reading.unread if amount.ends]
    if len(ranges) != 1:
        return ()
    choices = []
    for end in ranges[0].ends:
        dropped = frozenset(ranges[0].positions) - frozenset(end)
        tree = set_aside(sentence.tree, dropped, ABANDONED, lambda word: is_verb(vocabulary, word))
        words = [word.index for word in tree.words if word.upos != "PUNCT" or word.index in end]
        said = [index for index in words if index not in dropped | sentence.abandoned]
        amounts = [amount for amount in find_amounts(tree, said) if set(amount.positions) & set(end)]
        if any(amount.is_doubtful or bool(amount.unit) != bool(ranges[0].unit) for amount in amounts):
            # In "a metre or two" the second amount has no unit of its own.
            return ()
        choices.append(Choice(sentence.text(said), tree))
    return tuple(choices)


def chosen(sentence: Sentence, choices: Sequence[Choice], vocabulary: Vocabulary) -> Optional[Choice]:
    """Find the offered reading that an utterance picks.

    Args:
        sentence: the utterance: one of the readings, a part that only one of them has, "the second one", or "yes" if
            only one was offered
        choices: the readings
        vocabulary: an utterance with one of its verbs is a new command, unless it repeats a whole reading
    Returns:
        the reading; None if the utterance picks none, or more than one
    """
    if len(choices) == 1 and is_yes(sentence.tree.text):
        return choices[0]
    said = _words(word.form for word in sentence.tree.words if word.upos not in ("PUNCT", "INTJ"))
    ordinal = [word for word in said if word not in _CHOICE_NOUNS]
    if len(ordinal) == 1 and ordinal[0] in _ORDINALS and _ORDINALS[ordinal[0]] < len(choices) > 1:
        return choices[_ORDINALS[ordinal[0]]]
    whole = [choice for choice in choices if _words(choice.text.split()) == said]
    if any(match_verbs(sentence.tree, clause, vocabulary) for clause in find_clauses(sentence.tree, vocabulary)):
        return whole[0] if whole else None
    picked = whole or [choice for choice in choices if said and _is_part(said, _words(choice.text.split()))]
    if not said:
        # "You", of "Bob shall go or you shall go".
        bare = _in_lower_case(sentence.tree.text.split())
        picked = [choice for choice in choices if bare and _is_part(bare, _in_lower_case(choice.text.split()))]
    return picked[0] if len(picked) == 1 else None


def _words(forms: Iterable[str]) -> List[str]:
    return [form for form in _in_lower_case(forms) if form not in _COMMON]


def _in_lower_case(forms: Iterable[str]) -> List[str]:
    lower = (form.lower().strip(".,;:!?") for form in forms)
    return [form for form in lower if form]


def _is_part(said: Sequence[str], of: Sequence[str]) -> bool:
    return any(list(of[first : first + len(said)]) == list(said) for first in range(len(of)))
