"""Sets aside the words that open a correction of a running command: "no, turn right", "don't turn left, turn right"."""

from typing import Iterator

from utterance_passes.engine.utterance_pass import Example, Kind, tree_pass
from utterance_passes.trees.formula_file import pattern_of
from utterance_passes.trees.tree import ASIDE, DependencyTree, Word
from utterance_passes.trees.tree_edits import set_aside
from utterance_passes.trees.vocabulary import Verbs, Vocabulary, is_verb
from word_classes import word_class

#: Marks behind which something new begins.
_ENDS = frozenset(",.;!?")
_LEAD_IN = word_class("lead_in")
_NOT = word_class("not")
_OPENING = pattern_of("objections")


@tree_pass(
    Kind.POLICY,
    Example(
        "no|INTJ|3|discourse ,|PUNCT|1|punct turn|VERB|0|root left|ADV|3|advmod",
        ("no: discourse(turn) -> discourse:aside(turn)", ",: punct(no) -> discourse:aside(turn)"),
        Verbs(frozenset(["turn", "go"]), lists={"turn": (("left", "right"),)}),
    ),
    assigns=[ASIDE, "root", "parataxis"],
)
def objection(tree: DependencyTree, vocabulary: Vocabulary) -> DependencyTree:
    """Set aside the opening of a correction if a whole command follows: "no, turn right", "I meant turn right".

    What is not to be done is such an opening, too: "don't turn left, turn right". But "don't touch the vase, clean the
    table" says how the command is to be carried out.
    """
    for position in _openings(tree):
        is_of_first = _is_forbidden_too(tree, position) or _is_not_to_be_said(tree, position, vocabulary)
        is_correction = not is_of_first and not _is_of_command(tree, position, vocabulary)
        if _begins_command(tree, position, vocabulary) and is_correction:
            opening = frozenset(range(1, position + 1))
            return set_aside(tree, opening, ASIDE, lambda word: is_verb(vocabulary, word))
    return tree


def forbids_first(tree: DependencyTree) -> bool:
    """Whether a sentence may begin with what is not to be done: "*don't turn left*, turn right"."""
    return any(_forbids(tree, position) for position in _openings(tree))


def _openings(tree: DependencyTree) -> Iterator[int]:
    """Yield the lengths of the openings that a sentence may have, the shortest first."""
    text = ""
    for position, word in enumerate(tree.words):
        if position and _OPENING.fullmatch(text):
            yield position
        text = f"{text} {plain(word)}".strip()


def _forbids(tree: DependencyTree, position: int) -> bool:
    return any(plain(word) in _NOT for word in tree.words[:position])


def plain(word: Word) -> str:
    """Return a word in the form that the patterns of objections expect: lower case, straight apostrophes, any mark as
    a comma.
    """
    form = word.said.replace("\u2019", "'")
    return "," if word.upos == "PUNCT" else "n't" if form == "nt" else form


def _begins_command(tree: DependencyTree, position: int, vocabulary: Vocabulary) -> bool:
    words = [word for word in tree.words[position:] if word.upos != "PUNCT" and word.said not in _LEAD_IN]
    # "Do" may be a verb, as in "do the rounds", but in "no, do not turn" it is none.
    return bool(words) and words[0].upos != "AUX" and is_verb(vocabulary, words[0])


def _is_of_command(tree: DependencyTree, position: int, vocabulary: Vocabulary) -> bool:
    """Whether what is not to be done may happen while the command at a position is carried out: "*don't drop it*, bring
    me the vase". A robot does only what it is told, so any other deed is a correction: "don't turn left, turn right".
    """
    before = tree.words[:position]
    verb = next((word for word in before if word.upos == "VERB"), None)
    if not _forbids(tree, position) or verb is None or plain(before[-1]) != ",":
        return False
    is_same = any(word.lemma.lower() == verb.lemma.lower() for word in tree.words[position:])
    return not is_same and not is_verb(vocabulary, verb)


def _is_not_to_be_said(tree: DependencyTree, position: int, vocabulary: Vocabulary) -> bool:
    """Whether what stands at a position is what nobody shall say: "don't say: *open the door*"."""
    before = tree.words[:position]
    is_saying = any(word.upos == "VERB" and vocabulary.speech_of(word.lemma.lower()) is not None for word in before)
    return _forbids(tree, position) and is_saying and before[-1].form not in _ENDS


def _is_forbidden_too(tree: DependencyTree, position: int) -> bool:
    """Whether the deed at a position goes on with a list of what is not to be done: "don't shout, *run or jump*"."""
    before, behind = tree.words[:position], [word for word in tree.words[position:] if word.upos == "VERB"]
    if not _forbids(tree, position):
        return False
    if any(word.said == "again" for word in before[-2:]):
        return True  # "Don't use it again. Go home." says what is never to be done.
    if not behind or behind[0].index != position + 1 or behind[0].deprel in ("obj", "obl", "nmod", "compound"):
        return True  # "Don't bring anything but water": it is a thing.
    is_same = any(word.lemma.lower() == behind[0].lemma.lower() for word in before)
    joined = [word for word in behind[1:] if word.deprel == "conj"]
    joints = [child for word in joined for child in tree.children(word.index) if child.deprel == "cc"]
    is_list = any(joint.said != "but" for joint in joints)
    return is_list and before[-1].form == "," and not is_same
