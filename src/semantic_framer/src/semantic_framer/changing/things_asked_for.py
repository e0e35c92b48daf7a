"""Reads commands that are said without their verb: a thing and "please" is to be brought, "two napkins, please"; a way
and its measure is to be gone, "forward two metres", "left 90 degrees"; a device is to be switched, "lights off"."""

from dataclasses import replace
from typing import FrozenSet, Optional, Sequence

from semantic_framer.clauses.fragments import fragment_of
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.fragment_kind import FragmentKind
from semantic_framer.values.outcome import Understood
from semantic_framer.values.sentence import Sentence
from semantic_types import Fit
from typed_arguments.positions import with_moved_positions
from utterance_passes.phrases.clauses import Clause
from utterance_passes.phrases.measures import find_amounts
from utterance_passes.trees.tree import NOUNS
from utterance_passes.trees.tree_edits import TreeEdit, behind_verb
from word_classes import word_class

#: What is done with a thing for which somebody asks.
_VERB = "bring"
#: What is done with a direction and a measure, by the quantity that is measured.
_VERBS_OF_WAYS = {"length": "move", "angle": "turn"}
#: What is done with a device of which only its state is said.
_SWITCHING = "turn"
_DEVICES = ("Device", "Music")
_ON_AND_OFF = frozenset(["on", "off"])
_PLEASE = frozenset(["please"])
_ONE = word_class("indefinite_articles")
#: A thing without an article: "lights, please" does not ask for lights to be brought.
_BARE = ("Food", "Fluid")
_COUNTED = ("Physical_object", "Substance")
#: Nobody brings these.
_FIXED = ("Vehicle", "Portal", "Building", "Sentient", "Location")


def asked_for(sentence: Sentence, clauses: Sequence[Clause], known: FramedLexicon) -> Optional[Sentence]:
    """Return the command that an utterance without a verb is short for; None if it is short for none.

    Args:
        sentence: the utterance
        clauses: its clauses
        known: lexical units and frames
    """
    fragment = fragment_of(sentence, clauses, known) if not clauses else None
    if fragment is None or fragment.kind is not FragmentKind.ELEMENTS or fragment.is_more:
        return None
    tree = sentence.tree
    kept = frozenset(index for index in fragment.positions if tree.word(index).said not in _PLEASE)
    is_polite = any(word.said in _PLEASE for word in tree.words)
    short_for = _way(sentence, kept, known) or _device(sentence, kept, known)
    return short_for or (_thing(sentence, kept, known) if is_polite else None)


def _way(sentence: Sentence, kept: FrozenSet[int], known: FramedLexicon) -> Optional[Sentence]:
    """Return the command to go a way: "*move* two metres forward"; None if more is said than a direction and a measure
    of it."""
    tree = sentence.tree
    amounts = find_amounts(tree, sorted(kept))
    verb = _VERBS_OF_WAYS.get(amounts[0].quantity, "") if len(amounts) == 1 and amounts[0].unit_position else ""
    others = sorted(kept - frozenset(amounts[0].positions)) if verb and not amounts[0].is_doubtful else []
    if len(others) != 1 or not known.verbs_beginning_with(verb):
        return None
    direction = others[0]
    if not any(tree.word(direction).said in words for words in known.lists_of(verb)):
        return None
    # The verb is the first word now.
    edit = TreeEdit(behind_verb(tree, [verb], kept))
    edit.rehang(direction + 1, 1, "advmod")
    edit.retag(direction + 1, "ADV", "RB")
    edit.rehang(amounts[0].unit_position + 1, 1, "obl:unmarked")
    return Sentence(edit.tree(), known.types)


def _device(sentence: Sentence, kept: FrozenSet[int], known: FramedLexicon) -> Optional[Sentence]:
    """Return the command to switch a device: "*turn* the lights off"; None if something else is said."""
    tree = sentence.tree
    heads = [index for index in kept if tree.word(index).head not in kept]
    switches = [
        child
        for index in heads
        for child in tree.children(index)
        if child.deprel == "compound:prt" and child.said in _ON_AND_OFF and child.index in kept
    ]
    is_more_said = any(tree.word(index).upos == "ADV" for index in kept)
    if len(heads) != 1 or len(switches) != 1 or is_more_said or not known.verbs_beginning_with(_SWITCHING):
        return None
    is_device = tree.word(heads[0]).upos == "NOUN" and sentence.types.fit(heads[0], _DEVICES) is Fit.LIKELY
    return Sentence(behind_verb(tree, [_SWITCHING], kept), known.types) if is_device else None


def _thing(sentence: Sentence, kept: FrozenSet[int], known: FramedLexicon) -> Optional[Sentence]:
    """Return the command to bring a thing; None if something else is said, or the thing is none that is brought."""
    tree = sentence.tree
    if not known.verbs_beginning_with(_VERB):
        return None
    heads = [index for index in sorted(kept) if tree.word(index).head not in kept]
    if len(heads) != 1 or tree.word(heads[0]).upos not in NOUNS or not kept <= tree.subtree(heads[0]):
        return None
    children = [child for child in tree.children(heads[0]) if child.index in kept]
    first = [child.said for child in children if child.deprel in ("det", "nmod:poss", "case", "nummod")]
    is_counted = any(form in _ONE for form in first) or any(child.deprel == "nummod" for child in children)
    if first and not is_counted:
        return None
    accepted = _COUNTED if is_counted else _BARE
    fits = sentence.types.fit(heads[0], accepted) is Fit.LIKELY
    if not fits or sentence.types.fit(heads[0], _FIXED) is Fit.LIKELY:
        return None
    return Sentence(behind_verb(tree, [_VERB], kept), known.types)


def as_said(understood: Understood) -> Understood:
    """Return what such a command leads to, with positions of the words that were said."""
    return replace(
        understood,
        clauses=tuple(
            tuple(
                replace(
                    reading,
                    verb_positions=(),
                    arguments=tuple(
                        with_moved_positions(one, lambda position: position - 1) for one in reading.arguments
                    ),
                )
                for reading in readings
            )
            for readings in understood.clauses
        ),
    )
