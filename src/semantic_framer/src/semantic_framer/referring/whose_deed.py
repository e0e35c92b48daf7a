"""A deed behind a request to somebody, that person's or the robot's: "tell Bob to come and *bring me the book*"."""

from typing import Sequence, Tuple

from semantic_framer.referring.persons_spoken_of import PERSONAL_PRONOUNS
from semantic_framer.units.frame_roles import ADDRESSEE, MESSAGE
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from utterance_passes.engine.utterance_pass import Choice
from utterance_passes.trees.tree import Word
from utterance_passes.trees.tree_edits import TreeEdit
from word_classes import word_class

_ADDRESSEES = PERSONAL_PRONOUNS | word_class("pronouns_of_persons_or_things")


def whose_deed(sentence: Sentence, known: FramedLexicon, readings: Sequence[Reading]) -> Tuple[Choice, ...]:
    """Return who may be to do what stands behind a request, as choices; none if that is plain.

    A mark before "and", "then" and "to" tell ("..., and bring me the book", "... and to bring me the book"), and so
    does a pronoun for the hearer: "ask Anna to sit down and bring *her* a coffee".
    """
    for reading in readings:
        frame = known.frames[reading.unit.frame_name]
        message, hearer = (reading.argument_in_role(role, frame) for role in (MESSAGE, ADDRESSEE))
        if message is None or hearer is None or not (message.positions and reading.verb_positions):
            continue  # A repeated command has no words in this sentence.
        if not sentence.tree.is_infinitive(message.head_position):
            continue  # "Tell Bob that dinner is ready" says nothing to do.
        for deed in sentence.tree.children(min(reading.verb_positions)):
            if _may_be_theirs(sentence, deed, max(message.positions)):
                said = sentence.text(sorted(sentence.tree.subtree(deed.index))).strip(" ,.!?").split(" ", 1)[-1]
                theirs, own = TreeEdit(sentence.tree), TreeEdit(sentence.tree)
                theirs.rehang(deed.index, message.head_position, "conj")
                own.relabel(deed.index, "parataxis")
                return (
                    Choice(f"{hearer.text} shall {said}", theirs.tree()),
                    Choice(f"you shall {said}", own.tree()),
                )
    return ()


def _may_be_theirs(sentence: Sentence, deed: Word, end: int) -> bool:
    """Whether a deed of the robot follows the end of a request in such a way that it may be a part of it."""
    inside = sentence.tree.subtree(deed.index)
    forms = {sentence.word(index).said for index in inside}
    follows = deed.deprel == "conj" and deed.xpos == "VB" and min(inside) == end + 1 and deed.index == end + 2
    return follows and sentence.word(end + 1).said == "and" and not forms & _ADDRESSEES
