"""Reads what a clause says of a deed, in any mood, by the units of the verb that command it."""

from dataclasses import replace
from typing import FrozenSet, Optional, Tuple

from semantic_framer.clauses.readings import meant_readings
from semantic_framer.filling.extra_phrases import extra_arguments
from semantic_framer.judging.verdicts import Case, ClauseCase
from semantic_framer.kinds.clause_features import Aspect, ClauseFeatures, Form, features_of
from semantic_framer.units.frame_roles import PLACES
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from typed_arguments import EmbeddedFrame, Source, TypedArgument
from utterance_passes.phrases.clauses import Clause, clause_of
from utterance_passes.phrases.verb_matching import match_verbs
from utterance_passes.trees.tree_edits import TreeEdit
from word_classes import word_class

#: Names of elements of the frames that are about deeds.
DEED, AGENT, TIME = "deed", "agent", "time"
ROBOT, SPEAKER, WHO, WHETHER, WHERE, HOW = "robot", "speaker", "who", "whether", "where", "how"
_HEARERS, _SPEAKERS = word_class("hearers"), word_class("speaker_subjects")
_WHO = word_class("relative_pronouns") | word_class("indefinite_persons_asked") | word_class("indefinite_persons")
_PADDING = word_class("condition_padding") | word_class("habitual_adverbs")
_OBJECTS = frozenset(["dobj", "obj"])
#: What a question word asks for that stands for no element.
_ASKED = {"when": "when", "why": "why"}
_OF_AMOUNT = {"often": "how_often", "times": "how_often", "long": "how_long"}
#: The semantic type of a person.
_PERSON = "Human"
_BEEN, _TO, _GO = "been", "to", "go"
_OF_NOUNS = frozenset(["det", "case", "amod", "compound", "nmod", "nummod", "acl", "flat", "appos"])
#: "Yesterday", "last night".
_PERIODS = frozenset(["obl:unmarked", "advmod"])
#: FrameNet's name of when something is done, and the semantic type of its words.
_TIME_SAID = "Time"


def of_own_deed(sentence: Sentence, features: ClauseFeatures, known: FramedLexicon) -> ClauseFeatures:
    """Return the features of "you are *docked*" as those of "you have docked", others as they are.

    Only a deed without an object results in a state of who does it: who is moved did not move.

    Args:
        sentence: the sentence
        features: of the clause
        known: lexical units and frames
    """
    if not features.is_passive or features.agent or features.modal or features.aspect is not Aspect.PRESENT:
        return features
    subjects = [child for child in sentence.children(features.top) if child.deprel == "nsubj:pass"]
    units = known.units_of(sentence.word(features.top).lemma.lower())
    acting = [unit for unit in units if unit.frame_name in known.frames and known.frames[unit.frame_name].acts]
    has_object = any(
        path.steps[0] in _OBJECTS for unit in acting for relation in unit.relations for path in relation.relations
    )
    if not acting or has_object or [child.said in _HEARERS for child in subjects] != [True]:
        return features
    return replace(features, agent=subjects[0].index, is_passive=False, aspect=Aspect.DONE)


def with_going(sentence: Sentence, features: ClauseFeatures) -> Tuple[Sentence, ClauseFeatures]:
    """Return "you have *been to* the hall" as "you have *gone to* the hall", with its features; no others.

    Args:
        sentence: the sentence
        features: of the clause
    """
    tree, top = sentence.tree, sentence.word(features.top)
    children = tree.children(top.index)
    been = next((child for child in children if child.deprel == "cop" and child.said == _BEEN), None)
    if been is None or not any(child.deprel == "case" and child.said == _TO for child in children):
        return sentence, features
    edit = TreeEdit(tree)
    edit.drop_brackets()
    edit.rehang(been.index, top.head, top.deprel)
    edit.retag(been.index, "VERB")
    edit.respell(been.index, been.form, _GO)
    edit.rehang(top.index, been.index, "obl")
    for child in children:
        if child is not been and child.deprel.split(":")[0] not in _OF_NOUNS:
            edit.rehang(child.index, been.index)
    went = sentence.attached(edit.tree())
    going = features_of(went.tree, been.index)
    return went, going if features.form is Form.PLAIN else going.as_question()


class DeedClause:
    """What a clause says of a deed: which, whose, when, and what of it is asked.

    Attributes:
        features: of the clause
        asks: what is asked for: whether, who, when, why, ...; empty for an element of the deed
        said_when: the time that the clause names, after :meth:`deed`; none if it names none
    """

    def __init__(self, case: Case, top: int, features: ClauseFeatures, within: Optional[FrozenSet[int]] = None) -> None:
        """
        Args:
            case: the sentence
            top: position of the verb of the deed
            features: of the clause, which may have another verb: "are you *going* to close it"
            within: positions of the words that count; None for all words of the clause
        """
        self._case = case
        self._known = case.known
        self._within = within
        self.features = features
        self.said_when: Tuple[TypedArgument, ...] = ()
        sentence = case.sentence
        tree = sentence.tree
        if features.is_passive:
            edit = TreeEdit(tree)
            for child in tree.children(top):
                if child.deprel == "nsubj:pass":
                    edit.relabel(child.index, "obj")
            sentence = sentence.attached(edit.tree())
        self._sentence = sentence
        self._top = top
        self._asked_phrase = self._phrase_asked()
        self.asks = self._asks()

    def _phrase_asked(self) -> int:
        """Return the head of the phrase with the question word, which hangs on the verb: "lamps" in "which lamps"."""
        if not self.features.asked:
            return 0
        # In "when are you going to go", the question word hangs on "going".
        above = (0, self._top, self.features.top)
        word = self._sentence.word(self.features.asked)
        while word.index not in above and word.head not in above:
            word = self._sentence.tree.governor(word)
        return word.index

    def _asks(self) -> str:
        """Return what is asked for; empty for one of the elements."""
        if not self.features.asked:
            return WHETHER
        if self._asked_phrase == self.features.agent and not self.features.is_passive:
            return WHO
        form = self._sentence.word(self.features.asked).said
        if form in _ASKED:
            return _ASKED[form]
        head = self._sentence.word(self._asked_phrase).said
        if form == HOW:
            return _OF_AMOUNT.get(head, "") if head != HOW else HOW
        return WHERE if form == WHERE else ""

    def deed(self) -> Optional[Reading]:
        """Return the best reading of the verb that has all words but those that say what is asked; None without one."""
        tree = self._sentence.tree
        own = tree.subtree(self._top) - self._outside()
        own = own if self._within is None else own & self._within
        for words in (*tree.times, *self._periods()):
            if words <= own:
                own -= words
                head = next((index for index in words if tree.word(index).head not in words), min(words))
                self.said_when = (self._sentence.phrases.argument(TIME, head),)
        clause = clause_of(tree, self._top, own, False)
        clause = replace(clause, subject=self.features.agent if self.is_of_robot else 0)
        of = replace(self._case, sentence=self._sentence, clauses=(clause,), kinds=self._case.kinds[:1])
        asking = ClauseCase(of, clause, match_verbs(tree, clause, self._known))
        for reading in meant_readings(asking):
            if self._is_whole(reading, clause):
                return replace(reading, clause_text=self._words(clause))
        return None

    def _periods(self) -> Tuple[FrozenSet[int], ...]:
        """Return the phrases that say when, and are no times of commands: "yesterday", "last night"."""
        adverbs = [child for child in self._sentence.children(self._top) if child.deprel in _PERIODS]
        periods = (child for child in adverbs if self._sentence.types.likeliest(child.index) == _TIME_SAID)
        return tuple(self._sentence.subtree(child.index) for child in periods)

    def _outside(self) -> FrozenSet[int]:
        """Return the words of the clause that fill nothing: who acts, what is asked, auxiliaries, "already"."""
        tree = self._sentence.tree
        outside = set(self.features.auxiliaries)
        if self.features.agent:
            outside |= tree.subtree(self.features.agent)
        if self.asks and self._asked_phrase not in (0, self._top):
            outside |= tree.subtree(self._asked_phrase)
        for child in tree.children(self._top):
            # "Do you know *how* to close it?"
            is_way = child.said == HOW and self._top != self.features.top
            if child.said in _PADDING or child.deprel in ("punct", "mark", "cc") or is_way:
                outside.add(child.index)
        return frozenset(outside)

    def _is_whole(self, reading: Reading, clause: Clause) -> bool:
        frame = self._known.frames[reading.unit.frame_name]
        if not frame.acts or reading.wrong_types:
            return False
        if reading.left_over:
            extra = extra_arguments(self._sentence, clause, reading.left_over) or ()
            if len(extra) != 1 or extra[0].name != _TIME_SAID or self.said_when:
                return False
            self.said_when = (replace(extra[0], name=TIME),)
        if self.asks or not self._asked_phrase:
            return True
        return any(self._asked_phrase in argument.positions for argument in reading.arguments)

    def _words(self, clause: Clause) -> str:
        """Return the words of the deed, with its verb in the base form: "close the door", "switch on"."""
        asked = self._sentence.subtree(self._asked_phrase) if self._asked_phrase not in (0, self._top) else ()
        words = [index for index in sorted(clause.positions.difference(asked)) if index != self._top]
        said = self._sentence.text([index for index in words if self._sentence.word(index).upos != "PUNCT"])
        return f"{self._sentence.word(self._top).lemma} {said}".strip()

    @property
    def is_of_robot(self) -> bool:
        """Whether the robot acts."""
        return bool(self.features.agent) and self._sentence.word(self.features.agent).said in _HEARERS

    def agent(self) -> TypedArgument:
        """Return who acts: the robot, the speaker, somebody with a name, or whoever is asked for."""
        head = self.features.agent
        form = self._sentence.word(head).said if head else ""
        if not form or form in _HEARERS:
            return TypedArgument(AGENT, ROBOT if form else WHO, Source.INFERRED)
        if form in _SPEAKERS:
            return TypedArgument(AGENT, SPEAKER, Source.INFERRED)
        if form in _WHO:
            return TypedArgument(AGENT, WHO, Source.INFERRED)
        return self._sentence.phrases.argument(AGENT, head)

    @property
    def is_of_person(self) -> bool:
        """Whether a person acts, or somebody."""
        form = self._sentence.word(self.features.agent).said if self.features.agent else ""
        return form in _WHO | _SPEAKERS or (
            bool(form) and self._sentence.types.likeliest(self.features.agent) == _PERSON
        )

    def asked_element(self, deed: Reading) -> str:
        """Return what is asked for, as the answer needs it: the name of an element, or a word for what none holds."""
        frame = self._known.frames[deed.unit.frame_name]
        if self.asks == WHERE:
            filled = {argument.name for argument in deed.arguments}
            places = [one for one in frame.frame_elements if one.framenet in PLACES and one.name not in filled]
            core = [one for one in places if one.is_core] or places
            return core[0].name if core else WHERE
        if self.asks:
            return self.asks
        return next(argument.name for argument in deed.arguments if self._asked_phrase in argument.positions)

    def argument(self, deed: Reading, mood: str) -> TypedArgument:
        """Return the deed as an argument that holds its frame.

        Args:
            deed: the reading of its verb
            mood: question or statement
        """
        asks = self.asked_element(deed)
        elements = tuple(
            replace(argument, is_asked=True) if argument.name == asks else argument
            for argument in deed.arguments
            # Who acts is told beside the deed.
            if not argument.head_position or argument.head_position != self.features.agent
        )
        frame = EmbeddedFrame(
            role="says",
            frame_name=deed.unit.frame_name,
            words=deed.clause_text,
            mood=mood,
            is_negated=self.features.is_negated,
            frame_elements=elements,
        )
        positions = frozenset(deed.verb_positions).union(*(element.positions for element in elements))
        return TypedArgument(
            DEED, deed.clause_text, words=deed.clause_text, positions=tuple(sorted(positions)), frames=(frame,)
        )
