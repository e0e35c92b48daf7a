"""Reads what a person teaches of things and places: "a mug is a cup", "this room is the den".

A noun becomes a kind of another noun, if both name things that can be seen. A name becomes another name of the place
where the robot is. What the robot knows already, and what names no thing or place, teaches nothing.
"""

from typing import FrozenSet, NamedTuple, Optional, Sequence

from nearest_meaning.learned import KIND, PLACE
from referring_expressions.describing import article, name_of
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.dialogue import Lesson
from semantic_types import Fit, shipped_nouns
from utterance_passes.trees.tree import DependencyTree, Word
from word_classes import without_determiner, word_class

_INDEFINITE = frozenset(["a", "an"])
_THIS = "this"
_PLACE_NOUNS = word_class("general_place_nouns")
_PLACES = ("Location",)
_THINGS = ("Physical_object", "Substance")
#: "A mug is *a kind of* cup."
_KIND_NOUNS = frozenset(["kind", "sort", "type"])
_OF = "of"
#: Relations of words that belong to the name of a thing or a place.
_OF_NAMES = frozenset(["compound", "amod", "nmod:poss", "flat"])
_BESIDE_NAMES = frozenset(["det", "cop", "nsubj", "punct", "nmod", "case"])


class TaughtName(NamedTuple):
    """What a sentence teaches of a thing or a place.

    Attributes:
        lesson: what a yes teaches
        question: whether it is meant
        refusal: why it is not learned; empty if it may be
    """

    lesson: Lesson
    question: str
    refusal: str = ""


def taught_name(tree: DependencyTree, known: FramedLexicon) -> Optional[TaughtName]:
    """Return what a sentence teaches of a thing or a place; None for nothing."""
    roots = [word for word in tree.words if not word.head and word.upos in ("NOUN", "PROPN")]
    if len(roots) != 1 or tree.text.rstrip().endswith("?"):
        return None
    (root,) = roots
    children = tree.children(root.index)
    subjects = [one for one in children if one.deprel == "nsubj" and one.upos in ("NOUN", "PROPN")]
    copulas = [one for one in children if one.deprel == "cop" and one.lemma.lower() == "be"]
    if len(subjects) != 1 or len(copulas) != 1 or not subjects[0].index < copulas[0].index < root.index:
        return None
    subject = subjects[0]
    if not all(_is_bare(tree, one) for one in (root, subject)):
        return None
    return _kind(tree, subject, root, known) or _place(tree, subject, root, known)


def _is_bare(tree: DependencyTree, noun: Word) -> bool:
    return all(one.deprel in _OF_NAMES | _BESIDE_NAMES for one in tree.children(noun.index))


def _kind(tree: DependencyTree, subject: Word, root: Word, known: FramedLexicon) -> Optional[TaughtName]:
    upper = root
    if root.lemma.lower() in _KIND_NOUNS:
        named = [one for one in tree.children(root.index) if one.deprel == "nmod"]
        if len(named) != 1 or not any(one.said == _OF for one in tree.children(named[0].index)):
            return None
        upper = named[0]
    elif any(one.deprel == "nmod" for one in tree.children(root.index)):
        return None
    is_of_all = all(_determiners(tree, one) <= _INDEFINITE for one in {subject, root})
    is_one = bool(_determiners(tree, subject))
    if not is_of_all or (not is_one and "Number=Plur" not in subject.feats and subject.xpos != "NNS"):
        return None
    said, kind = _noun(tree, subject), _noun(tree, upper)
    nouns = shipped_nouns()
    seen = nouns.synsets(kind) or nouns.synsets(upper.lemma.lower())
    is_thing = nouns.types(said, False).fit(_THINGS) in (Fit.LIKELY, Fit.UNKNOWN)
    is_known = said == kind or bool(nouns.kinds(said) & seen) or known.taught.kinds.get(said) == kind
    if not seen or not is_thing or is_known:
        return None
    told = f"{article(said)} is {article(kind)}"
    before = known.taught.kinds.get(said, "")
    so_far = f" So far, I take it for {article(before)}." if before else ""
    lesson = Lesson(said, kind, KIND, tree.text, told=told)
    return TaughtName(lesson, f"Shall I remember that {told}? Say yes or no.{so_far}")


def _place(tree: DependencyTree, subject: Word, root: Word, known: FramedLexicon) -> Optional[TaughtName]:
    if subject.lemma.lower() not in _PLACE_NOUNS or _determiners(tree, subject) != {_THIS}:
        return None
    fit = known.types.of_noun([root.form, root.lemma], is_name=root.upos == "PROPN").fit(_PLACES)
    is_name = root.upos == "PROPN" or bool(_determiners(tree, root)) or _has_owner(tree, root)
    if not is_name or _determiners(tree, root) & _INDEFINITE or not (fit is Fit.LIKELY or root.upos == "PROPN"):
        return None
    robot = known.world.robot
    here = known.world.room_of(robot) if robot is not None else None
    if here is None:
        return None
    words = tree.text_of(sorted(_name_positions(tree, root) | _determiner_positions(tree, root)))
    said = without_determiner(words).lower()
    called_so = (*known.world.named(said), *known.world.exactly(said))
    if here in called_so:
        return None
    lesson = Lesson(said, here.id, PLACE, tree.text, told=f"{words} is {name_of(here)}")
    if called_so:
        return TaughtName(lesson, "", f"I know {words} already. I am in {name_of(here)}.")
    return TaughtName(lesson, f'By "{words}", do you always mean this place, {name_of(here)}?')


def _determiner_positions(tree: DependencyTree, noun: Word) -> FrozenSet[int]:
    return frozenset(one.index for one in tree.children(noun.index) if one.deprel == "det")


def _determiners(tree: DependencyTree, noun: Word) -> FrozenSet[str]:
    return frozenset(tree.word(index).said for index in _determiner_positions(tree, noun))


def _has_owner(tree: DependencyTree, noun: Word) -> bool:
    return any(one.deprel == "nmod:poss" for one in tree.children(noun.index))


def _name_positions(tree: DependencyTree, noun: Word) -> FrozenSet[int]:
    parts = (tree.subtree(one.index) for one in tree.children(noun.index) if one.deprel in _OF_NAMES)
    return frozenset([noun.index]).union(*parts)


def _noun(tree: DependencyTree, noun: Word) -> str:
    """Return a noun with the words before it, in the singular: "coffee mug"."""
    before: Sequence[int] = sorted(_name_positions(tree, noun) - {noun.index})
    return " ".join([*(tree.word(index).said for index in before), noun.lemma.lower()])
