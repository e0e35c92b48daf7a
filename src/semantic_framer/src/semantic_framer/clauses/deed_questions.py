"""Reads questions about deeds by the units of the verbs that command them: "did you close the door".

The same unit that fills the frame of a command fills the frame that is asked about. The features of the clause say
what is asked: whether, when, where, why, how often, who, or one of the elements.
"""

from dataclasses import replace
from typing import Optional, Tuple

from semantic_framer.filling.matching import match_units
from semantic_framer.judging.verdicts import Case
from semantic_framer.kinds.clause_features import Aspect, ClauseFeatures, Form, features_of
from semantic_framer.kinds.mood_file import UtteranceKind
from semantic_framer.referring.references import resolve
from semantic_framer.referring.world_references import refer
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.units.frame_roles import PLACES
from semantic_framer.values.dialogue import Context
from semantic_framer.values.reading import Reading, rank
from semantic_framer.values.sentence import Sentence
from typed_arguments import EmbeddedFrame, Source, TypedArgument
from utterance_passes.phrases.clauses import Clause, clause_of
from utterance_passes.phrases.verb_matching import match_verbs
from utterance_passes.trees.tree_edits import TreeEdit
from word_classes import word_class

#: The frame that asks about another frame.
QUESTION_OF_EVENT = "question_of_event"
DEED, ASKS, ASPECT, AGENT, TIME = "deed", "asks", "aspect", "agent", "time"
ROBOT, SPEAKER, WHO, ABLE, WHETHER, WHERE = "robot", "speaker", "who", "able", "whether", "where"
_HEARERS, _SPEAKERS = word_class("hearers"), word_class("speaker_subjects")
_PERSONS = word_class("relative_persons")
_ABILITIES = word_class("permission_modals")
_PADDING = word_class("condition_padding") | word_class("habitual_adverbs")
#: What a question word asks for that stands for no element.
_ASKED = {"when": "when", "why": "why"}
_OF_AMOUNT = {"often": "how_often", "times": "how_often", "long": "how_long"}


def deed_question(case: Case, context: Context) -> Tuple[Reading, ...]:
    """Return the readings of a question about what was done, runs, is planned or can be done; none for other sentences.

    Args:
        case: the sentence
        context: what was said before, for its pronouns
    """
    frame = case.known.frames.get(QUESTION_OF_EVENT)
    if frame is None or (case.known.heeded and frame.name not in case.known.heeded):
        return ()
    if any(kind.kind is not UtteranceKind.QUESTION for kind in case.kinds):
        return ()
    tops = [word.index for word in case.sentence.children(0)]
    return _asked_of(case.sentence, tops[0], case.known, context) if len(tops) == 1 else ()


def _asked_of(sentence: Sentence, top: int, known: FramedLexicon, context: Context) -> Tuple[Reading, ...]:
    features = features_of(sentence.tree, top)
    top, features = _of_what_is_meant(sentence, top, features)
    aspect = _aspect(features)
    if features.form is Form.PLAIN or not features.agent and not features.is_passive or not aspect:
        return ()
    question = _Question(sentence, top, features, known)
    deed = question.deed()
    if deed is None:
        return ()
    meant = resolve(deed, context, known)
    if isinstance(meant, TypedArgument):
        return ()
    meant, _ = refer(meant, known, context)
    return (_reading(sentence, meant, question, aspect),)


def _aspect(features: ClauseFeatures) -> str:
    """Return which deeds are asked about; empty for what is a request or asks about nobody's deeds."""
    if features.modal in _ABILITIES or (not features.modal and features.aspect is Aspect.PRESENT):
        return ABLE if features.form is Form.OPEN or not features.modal else ""
    if features.modal and features.aspect is not Aspect.PLANNED:
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
    if word.lemma.lower() == "able":
        return inner.index, replace(features, aspect=Aspect.PRESENT, modal="")
    return top, features


class _Question:
    """What a question asks about the frame of its verb."""

    def __init__(self, sentence: Sentence, top: int, features: ClauseFeatures, known: FramedLexicon) -> None:
        self._known = known
        self.features = features
        self.time: Optional[int] = None
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
        word = self._sentence.word(self.features.asked) if self.features.asked else None
        while word is not None and word.index != self._top and word.head != self._top:
            word = self._sentence.word(word.head)
        return word.index if word is not None else 0

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
        if form == "how":
            return _OF_AMOUNT.get(head, "") if head != "how" else "how"
        return WHERE if form == WHERE else ""

    def deed(self) -> Optional[Reading]:
        """Return the best reading of the verb with all words that do not only say what is asked; None if there is none."""
        tree = self._sentence.tree
        outside = set(self.features.auxiliaries)
        if self.features.agent:
            outside |= tree.subtree(self.features.agent)
        if self.asks:
            outside |= tree.subtree(self._asked_phrase) if self._asked_phrase not in (0, self._top) else frozenset()
        for words in tree.times:
            if words & tree.subtree(self._top) and not words & outside:
                self.time = self.time or min(words, key=lambda index: tree.word(index).head in words)
                outside |= words
        outside |= {child.index for child in tree.children(self._top) if child.form.lower() in _PADDING}
        outside |= {child.index for child in tree.children(self._top) if child.deprel in ("punct", "mark", "cc")}
        clause = clause_of(tree, self._top, tree.subtree(self._top) - outside, False)
        clause = replace(clause, subject=self.features.agent if self._is_robot() else 0)
        found = [
            reading
            for reading in match_units(self._sentence, clause, match_verbs(tree, clause, self._known), self._known)
            if self._is_whole(reading)
        ]
        best = min(found, key=rank, default=None)
        return replace(best, clause_text=self._words(clause)) if best is not None else None

    def _is_whole(self, reading: Reading) -> bool:
        frame = self._known.frames[reading.unit.frame_name]
        if frame.is_question or frame.is_condition or reading.left_over or reading.wrong_types:
            return False
        if self.asks or not self._asked_phrase:
            return True
        return any(self._asked_phrase in argument.positions for argument in reading.arguments)

    def _words(self, clause: Clause) -> str:
        words = sorted(index for index in clause.positions if self._sentence.word(index).upos != "PUNCT")
        return self._sentence.text(words)

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
        if form in _PERSONS:
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

    def said_when(self) -> Tuple[TypedArgument, ...]:
        """Return the time that the question names, if any."""
        if self.time is None:
            return ()
        return (self._sentence.phrases.argument(TIME, self.time),)


def _reading(sentence: Sentence, deed: Reading, question: _Question, aspect: str) -> Reading:
    asks = question.asked_element(deed)
    arguments = tuple(
        replace(argument, is_asked=True) if argument.name == asks else argument for argument in deed.arguments
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
            *question.said_when(),
        ),
        missing=(),
        left_over=(),
        coverage=1.0,
        clause_text=sentence.tree.text.strip(),
    )
