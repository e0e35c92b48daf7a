"""The rest of a sentence without the words that join its deeds, and what to reply if these are not understood."""

from typing import FrozenSet, Optional, Sequence, Union

from semantic_framer.clause_links import Joints, find_joints
from semantic_framer.framed_lexicon import FramedLexicon
from semantic_framer.link_file import shipped_links
from semantic_framer.outcome import Question, Refusal
from semantic_framer.reading import Reading
from semantic_framer.sentence import Sentence
from utterance_passes.tree import ASIDE, DependencyTree, Word
from utterance_passes.tree_edits import TreeEdit, mark_times, set_aside

#: Codes of refusals of the deeds that say more than that the sentence has a condition.
TELLING = frozenset(["UNKNOWN_VERB", "UNKNOWN_FRAME", "NO_READING", "LEFT_OVER_WORDS"])
#: Relations of a verb that depends on the one before it.
_DEPENDENT = frozenset(["advcl", "xcomp", "ccomp", "acl", "dep"])


def without_joints(sentence: Sentence, joints: Joints, known: FramedLexicon) -> Optional[DependencyTree]:
    """Return the tree of a sentence with the words that join set aside; None if no other words are left.

    Raises:
        NotATree: the words that are left make no tree
    """
    tree = sentence.tree
    left = [word for word in tree.open_words if word.index not in joints.positions and word.upos != "PUNCT"]
    if not left:
        return None

    def is_verb(word: Word) -> bool:
        return word.upos == "VERB" or bool(known.verbs_beginning_with(word.lemma.lower()))

    # The times among the words that join are accounted for.
    times = tuple(time for time in tree.times if not time <= joints.positions)
    made = set_aside(_with_deeds_apart(tree, joints.positions), joints.positions, ASIDE, is_verb)
    return mark_times(made, times)


def _with_deeds_apart(tree: DependencyTree, joining: FrozenSet[int]) -> DependencyTree:
    """Let each deed that hangs on words that join stand beside the others: "if that fails *bring* me the cup"."""
    edit = TreeEdit(tree)
    for word in tree.words:
        if word.index in joining or word.upos != "VERB" or word.deprel not in _DEPENDENT:
            continue
        marks = [child for child in tree.children(word.index) if child.index in joining and child.deprel == "mark"]
        if marks or word.head in joining:
            edit.relabel(word.index, "parataxis")
    return edit.tree()


def swallowed_joints(sentence: Sentence, known: FramedLexicon, readings: Sequence[Reading]) -> Joints:
    """Return the conditions at the end of arguments: "go to the kitchen *at the moment that Anna comes*".

    "Tell me if the door is open" asks for the condition itself, and a message may have a condition of its own.
    """
    inside = [argument for reading in readings for argument in reading.arguments if len(argument.positions) > 1]
    forms = {sentence.word(index).form.lower() for argument in inside for index in argument.positions}
    if not any(map(shipped_links().is_link_word, forms)):
        return Joints()
    found = [
        joint
        for joint in find_joints(sentence, known).found
        if joint.condition is not None
        for argument in inside
        if min(argument.positions) < joint.first <= max(argument.positions) <= max(joint.positions)
        if not any(sentence.word(index).upos in ("VERB", "AUX") for index in argument.positions if index < joint.first)
    ]
    return Joints(tuple(found))


def joint_words(sentence: Sentence, joints: Joints) -> str:
    """Return the words that join, as a person would quote them."""
    words = sentence.text(sorted(joints.positions)).strip(" ,.!?")
    return words[:1].lower() + words[1:]


def unknown_link(
    sentence: Sentence, joints: Joints, before: Union[Refusal, Question]
) -> Optional[Union[Refusal, Question]]:
    """Return what to reply if nothing is understood behind a link: "until when?", or which condition it is.

    Args:
        sentence: the sentence
        joints: what joins its deeds
        before: why the sentence cannot be understood as it is
    """
    if before.code != "CONDITION":
        return None
    if joints.question:
        return Question("MISSING_ELEMENT", joints.question)
    if not joints.unknown:
        return None
    words = sentence.text(joints.unknown)
    return Refusal("CONDITION", f'I do not understand "{words}" as a condition, so I do nothing.')
