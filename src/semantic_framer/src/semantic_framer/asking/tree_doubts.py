"""Signs in what was understood that the tree of the sentence is wrong.

They are rules of grammar and of meaning over all units: the items of a list are of one sort, a possessor has its mark,
the verb of a description takes its phrases, "and" joins like verbs.
"""

from dataclasses import dataclass
from typing import Callable, Dict, Iterator, Mapping, NamedTuple, Sequence, Tuple

from semantic_framer.clauses.readings import Heard
from semantic_framer.filling.matching import match_units
from semantic_framer.filling.relation_paths import DIRECTIONAL
from semantic_framer.referring.persons_spoken_of import PERSONAL_PRONOUNS
from semantic_framer.units.frame_roles import ADDRESSEE, MESSAGE
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.outcome import Understood
from semantic_framer.values.reading import Reading, heads_of
from semantic_framer.values.sentence import Sentence
from semantic_framer.values.things import is_direction
from semantic_frames.semantic_type import with_parents
from semantic_types import Fit, Likelihoods
from typed_arguments import TypedArgument
from utterance_passes.phrases.clauses import clause_of
from utterance_passes.phrases.verb_matching import match_verbs
from utterance_passes.trees.tree import NOUNS, DependencyTree, Word

_EMBEDDED = frozenset(["acl", "acl:relcl"])
#: Relations of clauses below a clause.
_CLAUSES = frozenset(["ccomp", "advcl", "acl:relcl", "parataxis"])
_FINITE = frozenset(["VBZ", "VBD", "VBN"])
#: Sorts of what can be touched, of which a list has one.
_SORTS = ("Physical_object", "Sentient", "Location", "Substance")
#: The least share of a sort that is certain.
_CERTAIN = 0.7


def doubts_of(tree: DependencyTree, heard: Heard, known: FramedLexicon) -> Tuple[str, ...]:
    """Return the names of the signs that the tree of what was understood is wrong; none for what was not understood.

    Args:
        tree: as it was parsed
        heard: what it means
        known: lexical units and frames
    """
    if heard.sentence is None or not isinstance(heard.outcome, Understood):
        return ()
    case = _Case(tree, heard.sentence, known, tuple(readings[0] for readings in heard.outcome.clauses))
    return tuple(name for name, doubt in DOUBTS.items() if name not in known.without and doubt.shows(case))


@dataclass(frozen=True)
class _Case:
    parsed: DependencyTree
    sentence: Sentence
    known: FramedLexicon
    readings: Tuple[Reading, ...]

    @property
    def tree(self) -> DependencyTree:
        return self.sentence.tree

    def filled(self) -> Iterator[Tuple[Reading, TypedArgument]]:
        """Return each argument that words of the sentence fill."""
        for reading in self.readings:
            for argument in reading.arguments:
                if argument.head_position and argument.positions and reading.verb_positions:
                    yield reading, argument


def _has_unlike_items(case: _Case) -> bool:
    """Whether a list has items of unlike sorts: "to *me and the fork*", "the remote and wave"."""
    for _, argument in case.filled():
        sorts = {_sort(case.sentence.types.of(item)) for item in case.sentence.types.items(argument.head_position)}
        if len(sorts - {""}) > 1:
            return True
    return False


def _has_deed_in_list(case: _Case) -> bool:
    """Whether an item of a list is the whole verb of a unit: "the kitchen and *high five*"."""
    for _, argument in case.filled():
        for item in case.sentence.types.items(argument.head_position)[1:]:
            words = [index for index in case.tree.subtree(item) if case.tree.word(index).deprel not in ("cc", "punct")]
            if len(words) > 1 and case.sentence.text(sorted(words)).lower() in case.known.lexicon.verbs:
                return True
    return False


def _has_most_as_goal(case: _Case) -> bool:
    """Whether "up to" before a number says where to: it may say how many: "bring me *up to three* apples"."""
    words = case.parsed.words
    phrases = {argument.head_position for _, argument in case.filled() if argument.measure is None}
    for before, preposition, number in zip(words, words[1:], words[2:]):
        is_most = (before.said, preposition.said) == ("up", "to") and number.upos == "NUM"
        if is_most and preposition.deprel == "case" and preposition.head in phrases:
            return True
    return False


def _sort(types: Likelihoods) -> str:
    """Return whether something is a thing, a being, a place, ...; empty if that is not certain."""
    shares: Dict[str, float] = {}
    for name, share in types.types:
        top = next((one for one in _SORTS if one in with_parents(name)), name)
        shares[top] = shares.get(top, 0.0) + share
    return next((name for name, share in shares.items() if share >= _CERTAIN), "")


def _has_unmarked_possessor(case: _Case) -> bool:
    """Whether a noun is a possessor without "'s", or has "'s" and is none: "*Anna* orange juice"."""
    for word in case.tree.words:
        is_marked = any(child.xpos == "POS" for child in case.tree.children(word.index))
        is_possessor = word.deprel == "nmod:poss"
        if word.upos in NOUNS and is_possessor != is_marked and not case.tree.quoted & {word.index}:
            return True
    return False


def _has_phrase_of_no_unit(case: _Case) -> bool:
    """Whether the verb of a description has a phrase that none of its units takes: "the box I gave you *to the
    kitchen*"."""
    tree, sentence = case.tree, case.sentence
    inside = frozenset().union(*(argument.positions for _, argument in case.filled())) - heads_of(case.readings)
    for word in tree.words:
        if word.deprel not in _EMBEDDED or word.upos != "VERB" or word.index not in inside:
            continue
        phrases = [
            child.index
            for child in tree.children(word.index)
            if child.index in inside and child.deprel == "obl" and tree.said_prepositions(child.index)
        ]
        directional = [
            one
            for one in phrases
            if "_".join(tree.said_prepositions(one)) in DIRECTIONAL and not is_direction(tree, one)
        ]
        if not directional:
            continue
        # What stands behind may say where all of it is: "brought to the hall *at noon*".
        phrases = [one for one in phrases if one <= max(directional)]
        clause = clause_of(tree, word.index, tree.subtree(word.index), False)
        readings = match_units(sentence, clause, match_verbs(tree, clause, case.known), case.known)
        if readings and not any(_takes(reading, phrases) and not reading.wrong_types for reading in readings):
            return True
    return False


def _takes(reading: Reading, phrases: Sequence[int]) -> bool:
    return frozenset(phrases) <= frozenset(argument.head_position for argument in reading.arguments)


def _has_unlike_verbs(case: _Case) -> bool:
    """Whether "and" joins a command to a statement: "what he *wants and bring* it"."""
    tree = case.parsed
    for word in tree.words:
        if word.deprel == "conj" and word.xpos == "VB" and word.head and not _has_subject(tree, word):
            governor = tree.governor(word)
            children = tree.children(governor.index)
            is_stated = governor.xpos in _FINITE or any(child.deprel == "cop" for child in children)
            has_modal = any(child.xpos in ("MD", "TO") for child in children)
            if governor.head and is_stated and not has_modal and _has_subject(tree, governor):
                return True
    return False


def _has_subject(tree: DependencyTree, verb: Word) -> bool:
    return tree.subject(verb.index) is not None


def _messages(case: _Case) -> Iterator[Tuple[TypedArgument, TypedArgument]]:
    """Return each message with its hearer."""
    for reading in case.readings:
        frame = case.known.frames[reading.unit.frame_name]
        message, hearer = (reading.argument_in_role(role, frame) for role in (MESSAGE, ADDRESSEE))
        if message is not None and hearer is not None and message.positions and hearer.head_position:
            yield message, hearer


def _has_addressee_again(case: _Case) -> bool:
    """Whether somebody is told to do something to themselves: "ask Anna to sit down and bring *her* a coffee"."""
    for message, hearer in _messages(case):
        words = [case.parsed.word(index) for index in sorted(message.positions)]
        deeds = [word.index for word in words if word.deprel == "conj" and word.xpos == "VB"]
        for word in words:
            is_object = word.deprel in ("obj", "iobj", "obl") and word.head in deeds
            is_meant = is_object and word.said in PERSONAL_PRONOUNS and hearer.head.lower() not in PERSONAL_PRONOUNS
            if is_meant and not _is_person_before(case, words, word):
                return True
    return False


def _is_person_before(case: _Case, words: Sequence[Word], pronoun: Word) -> bool:
    before = [word.index for word in words if word.index < pronoun.index and word.upos in NOUNS]
    return any(case.sentence.types.of(index).fit(["Sentient"]) is Fit.LIKELY for index in before)


def _has_description_as_message(case: _Case) -> bool:
    """Whether a message describes its hearer, and another is behind it: "tell the man *who wants to leave to wait*"."""
    tree = case.parsed
    for message, hearer in _messages(case):
        words = [tree.word(index) for index in sorted(message.positions)]
        described = [word for word in words if word.deprel == "acl:relcl" and word.head == hearer.head_position]
        others = [word for word in words if word.deprel in _CLAUSES and word not in described[:1]]
        if described and others:
            return True
    return False


def _has_way_at_its_start(case: _Case) -> bool:
    """Whether the end of a way hangs on its start: "from *the sofa to the kitchen*"."""
    return any(
        word.deprel == "nmod"
        and case.tree.said_prepositions(word.index) == ["to"]
        and case.tree.said_prepositions(word.head) == ["from"]
        for word in case.tree.words
        if word.head
    )


class _Doubt(NamedTuple):
    shows: Callable[[_Case], bool]
    reason: str
    is_grave: bool = False


#: The signs, each with the reason that the trace gives. Where no tree is without a grave one, nothing is done: whoever
#: is told something would hear what is meant for the robot, or what describes them.
DOUBTS: Mapping[str, _Doubt] = {
    "unlike_items": _Doubt(_has_unlike_items, "A list has items of unlike sorts."),
    "unmarked_possessor": _Doubt(_has_unmarked_possessor, "A possessor has no mark, or no possessor has one."),
    "deed_in_list": _Doubt(_has_deed_in_list, "A deed is an item of a list.", is_grave=True),
    "most_as_goal": _Doubt(_has_most_as_goal, "The most of something is taken for a place.", is_grave=True),
    "phrase_of_no_unit": _Doubt(
        _has_phrase_of_no_unit, "No unit of the verb of a description takes its phrase.", is_grave=True
    ),
    "unlike_verbs": _Doubt(_has_unlike_verbs, "A command is joined to a statement.", is_grave=True),
    "addressee_again": _Doubt(_has_addressee_again, "Somebody is told to do it to themselves.", is_grave=True),
    "description_as_message": _Doubt(_has_description_as_message, "A message describes its hearer.", is_grave=True),
    "way_at_its_start": _Doubt(_has_way_at_its_start, "The end of a way hangs on its start."),
}
