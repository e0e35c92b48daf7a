"""Reads questions about deeds by the units of the verbs that command them: "did you close the door".

The same unit that fills the frame of a command fills the frame that is asked about. The features of the clause say
what is asked: whether, when, where, why, how often, who, or one of the elements.
"""

from dataclasses import replace
from typing import FrozenSet, Optional, Tuple

from semantic_framer.clauses.readings import plausible_readings
from semantic_framer.filling.extra_phrases import extra_arguments
from semantic_framer.judging.verdicts import Case, ClauseCase
from semantic_framer.kinds.clause_features import Aspect, ClauseFeatures, Form, features_of
from semantic_framer.kinds.mood_file import UtteranceKind
from semantic_framer.kinds.question_extent import words_of_question
from semantic_framer.kinds.question_orders import length_of_opening
from semantic_framer.referring.persons_spoken_of import PERSON
from semantic_framer.referring.references import resolve
from semantic_framer.referring.world_references import refer
from semantic_framer.units.frame_roles import PLACES
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.values.dialogue import Context
from semantic_framer.values.reading import Reading, rank
from semantic_framer.values.sentence import Sentence
from typed_arguments import EmbeddedFrame, Source, TypedArgument
from utterance_passes.phrases.clauses import Clause, clause_of
from utterance_passes.phrases.verb_matching import match_verbs
from utterance_passes.trees.tree_edits import TreeEdit
from utterance_passes.trees.vocabulary import Speech
from word_classes import word_class

#: The frame that asks about another frame.
QUESTION_OF_EVENT = "question_of_event"
DEED, ASKS, ASPECT, AGENT, TIME = "deed", "asks", "aspect", "agent", "time"
ROBOT, SPEAKER, WHO, ABLE, WHETHER, WHERE = "robot", "speaker", "who", "able", "whether", "where"
_HEARERS, _SPEAKERS = word_class("hearers"), word_class("speaker_subjects")
_WHO = word_class("relative_persons") | word_class("indefinite_persons_asked") | word_class("indefinite_persons")
_SPEAKER_OBJECTS, _WHETHER = word_class("speaker_objects"), word_class("whether_words")
_QUESTION_WORDS = word_class("question_words")
_ABILITIES = word_class("permission_modals")
_PADDING = word_class("condition_padding") | word_class("habitual_adverbs")
#: What a question word asks for that stands for no element.
_ASKED = {"when": "when", "why": "why"}
_HOW, _CAN = "how", "can"
#: FrameNet's name of when something is done.
_TIME_SAID = "Time"
_OF_AMOUNT = {"often": "how_often", "times": "how_often", "long": "how_long"}


def deed_question(case: Case, context: Context) -> Tuple[Reading, ...]:
    """Return the readings of a question about what was done, runs, is planned or can be done; none for other sentences.

    Args:
        case: the sentence
        context: what was said before, for its pronouns
    """
    tops = [word.index for word in case.sentence.children(0)]
    if len(tops) != 1 or any(kind.kind is not UtteranceKind.QUESTION for kind in case.kinds):
        return ()
    return _asked_of(case, features_of(case.sentence.tree, tops[0]), context)


def embedded_deed_question(case: Case, context: Context) -> Tuple[Reading, ...]:
    """Return the readings of such a question inside a sentence that only asks it: "I want to know whether *you left*",
    "tell me when *you left*"."""
    sentence = case.sentence
    words = words_of_question(sentence)
    length = length_of_opening([word.form.lower() for word in words])
    first = words[length].index if 0 < length < len(words) else 0
    is_told = is_told_to_speaker(sentence, case.known)
    for word in sentence.tree.words if first or is_told else ():
        begin = min(sentence.subtree(word.index))
        is_question = sentence.word(begin).form.lower() in _WHETHER | _QUESTION_WORDS
        if word.deprel in ("ccomp", "advcl") and is_question and (begin == first or (is_told and word.head)):
            features = features_of(sentence.tree, word.index)
            form = Form.OPEN if features.asked else Form.POLAR
            return _asked_of(case, replace(features, form=form), context)
    return ()


def is_told_to_speaker(sentence: Sentence, known: FramedLexicon) -> bool:
    """Whether a sentence asks the robot to tell its speaker something, and nothing else: "tell me ..."."""
    tops = sentence.children(0)
    if len(tops) != 1 or known.speech_of(tops[0].lemma.lower()) is not Speech.TOLD:
        return False
    children = sentence.children(tops[0].index)
    told = [child for child in children if child.deprel in ("iobj", "obj") and child.form.lower() in _SPEAKER_OBJECTS]
    return bool(told) and not any(child.deprel in ("conj", "parataxis") for child in children)


def _asked_of(case: Case, features: ClauseFeatures, context: Context) -> Tuple[Reading, ...]:
    sentence, known = case.sentence, case.known
    top, features = _of_what_is_meant(sentence, features.top, features)
    aspect = _aspect(features)
    is_state = any(child.deprel == "cop" for child in sentence.children(top))
    if features.form is Form.PLAIN or not aspect or is_state or not (features.agent or features.is_passive):
        return ()
    question = _Question(case, top, features)
    if not question.is_answerable(aspect):
        return ()
    deed = question.deed()
    if deed is None or (aspect == ABLE and question.said_when):
        return ()
    meant = resolve(deed, context, known)
    if isinstance(meant, TypedArgument):
        return ()
    meant, _ = refer(meant, known, context)
    return (_reading(sentence, meant, question, aspect),)


def _aspect(features: ClauseFeatures) -> str:
    """Return which deeds are asked about; empty for what asks how things are, and for requests ("will you")."""
    if features.modal in _ABILITIES:
        return ABLE
    if features.modal or features.aspect is Aspect.PRESENT:
        return ""
    return features.aspect.value


def _of_what_is_meant(sentence: Sentence, top: int, features: ClauseFeatures) -> Tuple[int, ClauseFeatures]:
    """Return the verb of "are you *going to close* the door", with when it happens; others stay as they are."""
    word = sentence.word(top)
    inner = next((child for child in sentence.children(top) if child.deprel == "xcomp" and child.upos == "VERB"), None)
    if inner is None or not features.agent or not sentence.tree.is_infinitive(inner.index):
        return top, features
    if word.lemma.lower() == "go" and features.aspect is Aspect.RUNNING:
        return inner.index, replace(features, aspect=Aspect.PLANNED)
    if word.lemma.lower() == ABLE:
        return inner.index, replace(features, modal=_CAN)
    return top, features


class _Question:
    """What a question asks about the frame of its verb."""

    def __init__(self, case: Case, top: int, features: ClauseFeatures) -> None:
        self._case = case
        self._known = case.known
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
            word = self._sentence.word(word.head)
        return word.index

    def _asks(self) -> str:
        """Return what is asked for; empty for one of the elements."""
        if not self.features.asked:
            return WHETHER
        if self._asked_phrase == self.features.agent and not self.features.is_passive:
            return WHO
        form = self._sentence.word(self.features.asked).form.lower()
        if form in _ASKED:
            return _ASKED[form]
        head = self._sentence.word(self._asked_phrase).form.lower()
        if form == _HOW:
            return _OF_AMOUNT.get(head, "") if head != _HOW else _HOW
        return WHERE if form == WHERE else ""

    def is_answerable(self, aspect: str) -> bool:
        """Whether the robot can know it: what it did, does and can do, and what persons did that it watched."""
        if self.asks == _HOW or (aspect == ABLE and self.asks not in (WHETHER, "")):
            return False
        if self._is_robot() or not self.features.agent:
            return True
        is_done = aspect in (Aspect.DONE.value, Aspect.EVER_DONE.value)
        form = self._sentence.word(self.features.agent).form.lower()
        is_person = form in _WHO | _SPEAKERS or self._sentence.types.likeliest(self.features.agent) == PERSON
        return is_done and is_person

    def deed(self) -> Optional[Reading]:
        """Return the best reading of the verb that has all words but those that say what is asked; None without one."""
        tree = self._sentence.tree
        own = tree.subtree(self._top) - self._outside()
        for words in tree.times:
            if words <= own:
                own -= words
                head = next((index for index in words if tree.word(index).head not in words), min(words))
                self.said_when = (self._sentence.phrases.argument(TIME, head),)
        clause = clause_of(tree, self._top, own, False)
        clause = replace(clause, subject=self.features.agent if self._is_robot() else 0)
        of = replace(self._case, sentence=self._sentence, clauses=(clause,), kinds=self._case.kinds[:1])
        asking = ClauseCase(of, clause, match_verbs(tree, clause, self._known))
        for reading in plausible_readings(asking):
            if self._is_whole(reading, clause):
                return replace(reading, clause_text=self._words(clause))
        return None

    def _outside(self) -> FrozenSet[int]:
        """Return the words of the clause that fill nothing: who acts, what is asked, auxiliaries, "already"."""
        tree = self._sentence.tree
        outside = set(self.features.auxiliaries)
        if self.features.agent:
            outside |= tree.subtree(self.features.agent)
        if self.asks and self._asked_phrase not in (0, self._top):
            outside |= tree.subtree(self._asked_phrase)
        for child in tree.children(self._top):
            if child.form.lower() in _PADDING or child.deprel in ("punct", "mark", "cc"):
                outside.add(child.index)
        return frozenset(outside)

    def _is_whole(self, reading: Reading, clause: Clause) -> bool:
        frame = self._known.frames[reading.unit.frame_name]
        if frame.is_question or frame.is_condition or reading.wrong_types:
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

    def _is_robot(self) -> bool:
        return bool(self.features.agent) and self._sentence.word(self.features.agent).form.lower() in _HEARERS

    def agent(self) -> TypedArgument:
        """Return who acts: the robot, the speaker, somebody with a name, or whoever is asked for."""
        head = self.features.agent
        form = self._sentence.word(head).form.lower() if head else ""
        if not form or form in _HEARERS:
            return TypedArgument(AGENT, ROBOT if form else WHO, Source.INFERRED)
        if form in _SPEAKERS:
            return TypedArgument(AGENT, SPEAKER, Source.INFERRED)
        if form in _WHO:
            return TypedArgument(AGENT, WHO, Source.INFERRED)
        return self._sentence.phrases.argument(AGENT, head)

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


def _reading(sentence: Sentence, deed: Reading, question: _Question, aspect: str) -> Reading:
    asks = question.asked_element(deed)
    arguments = tuple(
        replace(argument, is_asked=True) if argument.name == asks else argument
        for argument in deed.arguments
        # Who acts is told beside the deed.
        if not argument.head_position or argument.head_position != question.features.agent
    )
    about = TypedArgument(
        DEED,
        deed.clause_text,
        words=deed.clause_text,
        frames=(
            EmbeddedFrame(
                role="says",
                frame_name=deed.unit.frame_name,
                words=deed.clause_text,
                mood="question",
                is_negated=question.features.is_negated,
                frame_elements=arguments,
            ),
        ),
    )
    words = [word for word in sentence.tree.words if word.upos != "PUNCT"]
    return Reading(
        unit=replace(deed.unit, frame_name=QUESTION_OF_EVENT),
        verb=deed.verb,
        verb_positions=tuple(word.index for word in words),
        arguments=(
            about,
            TypedArgument(ASKS, asks, Source.INFERRED),
            TypedArgument(ASPECT, aspect, Source.INFERRED),
            question.agent(),
            *question.said_when,
        ),
        missing=(),
        left_over=(),
        coverage=1.0,
        clause_text=sentence.tree.text.strip(),
    )
