"""Things that are told apart by what the robot did to them: "the door *that you closed*"."""

from dataclasses import replace
from typing import Optional, Sequence, Tuple

from referring_expressions import resolve
from referring_expressions.deeds import is_deed
from semantic_framer.clauses.deed_clauses import DeedClause
from semantic_framer.clauses.readings import ClauseReadings
from semantic_framer.filling.descriptions import relative_clauses
from semantic_framer.judging.verdicts import Case
from semantic_framer.kinds.clause_features import Aspect, ClauseFeatures, features_of
from semantic_framer.values.outcome import Refusal
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from typed_arguments import EmbeddedFrame, TypedArgument
from utterance_passes.engine.trace import Trace
from utterance_passes.phrases.clauses import Clause
from utterance_passes.phrases.verb_matching import match_verbs
from utterance_passes.trees.tree_edits import TreeEdit
from word_classes import word_class

#: FrameNet's frame of seeing something.
_SEEING = "Perception_experience"
_RELATIVE_WORDS = word_class("relative_pronouns") | word_class("relative_adverbs")


def told_by_deeds(
    case: Case, clauses: Tuple[ClauseReadings, ...], trace: Optional[Trace]
) -> Tuple[Optional[Refusal], Tuple[ClauseReadings, ...]]:
    """Return why it is not known which thing a deed of the robot tells apart, and the readings with that deed.

    A thing that is told apart by a deed is no other thing of its kind: who does not know which it is does nothing.

    Args:
        case: the sentence
        clauses: the readings of its clauses
        trace: receives a line for each such thing; None for no trace
    """
    for clause in relative_clauses(case.sentence, [read.clause for read in clauses]):
        features = features_of(case.sentence.tree, clause.verb)
        is_over = features.aspect in (Aspect.DONE, Aspect.EVER_DONE)
        if not is_over or not match_verbs(case.sentence.tree, clause, case.known):
            continue
        stand_in = _stand_in(case, clause)
        of = DeedClause(replace(case, sentence=_with_thing(case, clause, stand_in)), clause.verb, features)
        deed = of.deed() if of.is_of_robot else None
        # What it saw, it may see again; "the person whom you met" is in its log.
        if not of.is_of_robot or (deed is None and _is_seen(case, clause)):
            continue
        positions = sorted(case.sentence.subtree(clause.verb))
        words = case.sentence.text(positions)
        gap = _gap(case, clause, deed, stand_in) if deed is not None else ""
        told = clauses
        if deed is not None and gap:
            description = _description(case, positions, deed, gap, features)
            told = tuple(_with(case, read, clause, description) for read in clauses)
        is_known = told != clauses and _is_known(case, told)
        if trace is not None:
            after = "of what was done" if is_known else "refused. It is not known which thing that is."
            trace.add("told_by_deeds", words, after=after, positions=positions)
        if not is_known:
            sentence = f'I cannot tell which one is meant by "{words}". Please name it.'
            return Refusal("UNKNOWN_THING", sentence), clauses
        clauses = told
    return None, clauses


def _description(
    case: Case, positions: Sequence[int], deed: Reading, gap: str, features: ClauseFeatures
) -> EmbeddedFrame:
    """Return a deed as the description of the thing that it was done to.

    Args:
        case: the sentence
        positions: of the words that tell of the deed
        deed: what was done
        gap: the element that the thing fills
        features: of the clause that tells of it
    """
    said = (one for one in deed.arguments if one.positions)
    return EmbeddedFrame(
        role="describes",
        frame_name=deed.unit.frame_name,
        words=case.sentence.text(positions),
        positions=tuple(positions),
        head_element=gap,
        mood="statement",
        is_negated=features.is_negated,
        frame_elements=tuple(one for one in said if one.name != gap and one.head_position != features.agent),
    )


def _is_seen(case: Case, clause: Clause) -> bool:
    """Whether a relative clause tells what was seen."""
    units = case.known.lexicon.events.units_of(clause.lemma)
    frames = [case.known.frames.get(unit.frame_name) for unit in units]
    return any(frame is not None and frame.framenet == _SEEING for frame in frames)


def _stand_in(case: Case, clause: Clause) -> int:
    """Return the position of the word that stands for the thing in a relative clause, "that"; 0 if none does."""
    inside = case.sentence.subtree(clause.verb)
    found = [index for index in sorted(inside) if case.sentence.word(index).said in _RELATIVE_WORDS]
    return found[0] if found and case.sentence.word(found[0]).upos == "PRON" else 0


def _with_thing(case: Case, clause: Clause, stand_in: int) -> Sentence:
    """Return the sentence with the thing in its relative clause: "the door (you closed *door*)".

    What was done follows from what it was done to: a table is cleaned in another way than a room.
    """
    if not stand_in:
        return case.sentence
    thing = case.sentence.tree.governor(case.sentence.word(clause.verb))
    edit = TreeEdit(case.sentence.tree)
    edit.drop_brackets()
    edit.respell(stand_in, thing.form, thing.lemma)
    edit.retag(stand_in, thing.upos)
    return case.sentence.attached(edit.tree())


def _gap(case: Case, clause: Clause, deed: Reading, stand_in: int) -> str:
    """Return the element of a deed that the thing fills which it describes; empty where that is not clear."""
    missing = [one.name for one in deed.asked]
    if stand_in:
        filled = [one.name for one in deed.arguments if one.head_position == stand_in]
        return filled[0] if len(filled) == 1 and not missing else ""
    # "The door you closed": nothing there says of what kind it is that was closed.
    units = case.known.units_of(clause.lemma)
    names = {unit.frame_name for unit in units if unit.frame_name in case.known.frames}
    acting = {name for name in names if case.known.frames[name].acts}
    return missing[0] if len(missing) == 1 and acting == {deed.unit.frame_name} else ""


def _with(case: Case, read: ClauseReadings, clause: Clause, description: EmbeddedFrame) -> ClauseReadings:
    """Return readings in which the thing that a relative clause describes has that description."""
    thing = case.sentence.word(clause.verb).head

    def described(reading: Reading) -> Reading:
        return replace(reading, arguments=tuple(map(of_argument, reading.arguments)))

    def of_argument(argument: TypedArgument) -> TypedArgument:
        if argument.head_position != thing:
            return argument
        others = tuple(one for one in argument.frames if not set(one.positions) & set(description.positions))
        return replace(argument, frames=(*others, description))

    return replace(read, kept=tuple(map(described, read.kept)))


def _is_known(case: Case, clauses: Sequence[ClauseReadings]) -> bool:
    """Whether the things are known that deeds tell apart; yes where nobody tells what was done."""
    if case.known.deeds is None:
        return True
    situation = case.known.situation()
    things = [
        argument
        for read in clauses
        for reading in read.kept[:1]
        for argument in reading.arguments
        if any(map(is_deed, argument.frames))
    ]
    found = [resolve(thing, situation) for thing in things]
    return all(one is not None and one.objects for one in found)
