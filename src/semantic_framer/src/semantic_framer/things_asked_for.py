"""Reads a thing and "please" as the command to bring it: "coffee please", "two napkins, please"."""

from dataclasses import replace
from typing import Optional, Sequence

from semantic_framer.fragment_kind import FragmentKind
from semantic_framer.fragments import fragment_of
from semantic_framer.framed_lexicon import FramedLexicon
from semantic_framer.outcome import Understood
from semantic_framer.sentence import Sentence
from semantic_types import Fit
from typed_arguments.positions import with_moved_positions
from utterance_passes.clauses import Clause
from utterance_passes.tree_edits import behind_verb
from word_classes import word_class

#: What is done with a thing for which somebody asks.
_VERB = "bring"
_PLEASE = frozenset(["please"])
_ONE = word_class("indefinite_articles") | frozenset(["some"])
#: A thing without an article: "lights, please" does not ask for lights to be brought.
_BARE = ("Food", "Fluid")
_COUNTED = ("Physical_object", "Substance")
#: Nobody brings these.
_FIXED = ("Vehicle", "Portal", "Building", "Sentient", "Location")


def asked_for(sentence: Sentence, clauses: Sequence[Clause], known: FramedLexicon) -> Optional[Sentence]:
    """Return the command that an utterance without a verb is short for; None if it asks for nothing to be brought.

    Args:
        sentence: the utterance
        clauses: its clauses
        known: lexical units and frames
    """
    tree = sentence.tree
    is_polite = any(word.form.lower() in _PLEASE for word in tree.words)
    if clauses or not is_polite or not known.verbs_beginning_with(_VERB):
        return None
    fragment = fragment_of(sentence, clauses, known)
    if fragment is None or fragment.kind is not FragmentKind.ELEMENTS or fragment.is_more:
        return None
    kept = frozenset(index for index in fragment.positions if tree.word(index).form.lower() not in _PLEASE)
    heads = [index for index in sorted(kept) if tree.word(index).head not in kept]
    if len(heads) != 1 or tree.word(heads[0]).upos not in ("NOUN", "PROPN") or not kept <= tree.subtree(heads[0]):
        return None
    children = [child for child in tree.children(heads[0]) if child.index in kept]
    first = [child.form.lower() for child in children if child.deprel in ("det", "nmod:poss", "case", "nummod")]
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
