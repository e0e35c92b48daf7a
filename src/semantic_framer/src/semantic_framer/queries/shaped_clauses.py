"""Reads clauses about the robot by their grammar: "what can you do", "do you have rules", "never use the left arm"."""

from dataclasses import dataclass, replace
from typing import Dict, FrozenSet, List, Optional, Sequence, Tuple

from semantic_framer.clauses.state_phrases import FUNCTION, WHICH, WHO
from semantic_framer.judging.verdicts import Case
from semantic_framer.kinds.clause_features import Aspect, ClauseFeatures, Form
from semantic_framer.kinds.question_extent import words_of_question
from semantic_framer.units.framed_lexicon import FramedLexicon
from semantic_framer.units.word_patterns import whole_reading
from semantic_framer.values.reading import Reading
from semantic_framer.values.sentence import Sentence
from semantic_frames.clause_shape import ANYBODY, ASKED_FOR, IT, NOBODY, ROBOT, SPEAKER, ClauseShape
from utterance_passes.trees.tree import Word
from word_classes import word_class

_HEARERS, _SPEAKERS = word_class("hearers"), word_class("speaker_subjects")
_OBJECTS_OF_TALK = word_class("speaker_objects") | _HEARERS
_SPOKEN_OF = word_class("pronouns") - word_class("plural_pronouns")
_DETERMINERS = word_class("determiners_and_possessives") | {"any", "all", "no"}
_PADDING = word_class("lead_in") | word_class("condition_padding") | word_class("habitual_adverbs")
_PADDING |= word_class("padding") | word_class("exact_adverbs")
_GENERAL = word_class("general_thing_nouns")
_KINDS = frozenset(["kind", "sort"])
_NO_PHRASES = FUNCTION | {"case"}
_OF_NOUNS = frozenset(["det", "amod", "nmod", "compound"])
_TO_DO = frozenset(["xcomp", "ccomp"])
_FUTURE = word_class("future_auxiliaries")
_HOW, _MANY = "how", "many"


@dataclass(frozen=True)
class _Clause:
    """A clause as shapes describe it.

    Attributes:
        verbs: its verb in the spellings that a shape may have, "be docked" and "be dock"
        subject: the head of its subject; None if it has none
        asks: what it asks, as shapes say it
        asked: position of the head of the phrase that is asked for; 0 for none
        others: what else hangs on its verb
        features: of the clause, with those of the verb that is meant: "are you *going* to do it" is planned
    """

    verbs: Tuple[str, ...]
    subject: Optional[Word]
    asks: str
    asked: int
    others: Tuple[Word, ...]
    features: ClauseFeatures


def own_question(case: Case, features: ClauseFeatures) -> Tuple[Reading, ...]:
    """Return the reading of a question whose grammar a unit describes; none for other clauses.

    Args:
        case: the sentence
        features: of the clause that asks
    """
    if features.form is Form.PLAIN:
        return ()
    sentence = case.sentence
    inside = sentence.subtree(features.top)
    words = frozenset(word.index for word in words_of_question(sentence)) & inside
    found = shaped_reading(sentence, case.known, features, words)
    return (found,) if found is not None else ()


def shaped_reading(
    sentence: Sentence,
    known: FramedLexicon,
    features: ClauseFeatures,
    words: FrozenSet[int],
    *,
    needs_server: bool = True,
) -> Optional[Reading]:
    """Return the reading of a clause whose grammar a unit describes; None for other clauses.

    Args:
        sentence: the sentence
        known: lexical units and frames
        features: of the clause
        words: positions of the words that count
        needs_server: whether a server must answer it
    """
    clause = _clause(sentence, features, words)
    # "What will you do *next*" asks less than "what will you do".
    possible = sorted(
        ((verb, unit, shape) for verb in clause.verbs for unit, shape in known.lexicon.shaped_units(verb)),
        key=lambda one: not one[2].said,
    )
    for verb, unit, shape in possible:
        frame = known.frames.get(unit.frame_name)
        if frame is None or (needs_server and known.heeded and frame.name not in known.heeded):
            continue
        found = _Match(sentence, clause, shape, words).elements()
        filled = {*(found or ()), *unit.values}
        if found is not None and all(one.name in filled for one in frame.frame_elements if one.is_core):
            return whole_reading(sentence, frame, unit, verb, found)
    return None


def _clause(sentence: Sentence, features: ClauseFeatures, words: FrozenSet[int]) -> _Clause:
    top = sentence.word(features.top)
    children = [child for child in sentence.children(top.index) if child.index in words]
    subject = next((child for child in children if child.deprel.startswith("nsubj")), None)
    asks, asked = _asked(sentence, features)
    particles = [child for child in children if child.deprel == "compound:prt"]
    spelled = [" ".join([spelling, *(one.said for one in particles)]) for spelling in _spellings(top)]
    if any(child.deprel == "cop" for child in children):
        # "*What* is your name", "*which room* is this".
        is_asked = asked == top.index and top.upos != "ADJ"
        spelled = ["be"] if is_asked else [f"be {spelling}" for spelling in spelled]
    left = {features.top, *(one.index for one in particles)}
    inner = next((child for child in children if child.deprel in _TO_DO and child.upos == "VERB"), None)
    if inner is not None:
        left.add(inner.index)
        below = [child for child in sentence.children(inner.index) if child.index in words]
        children += below
        if sentence.tree.is_infinitive(inner.index):
            spelled = [f"{spelling} to" for spelling in spelled]
            how = [child for child in below if child.said == _HOW and child.index != features.asked]
            left.update(child.index for child in how)
        meant = _of_what_is_meant(spelled[0], features)
        features = meant or features
        spelled = [*_spellings(inner)] if meant else [f"{one} {inner.lemma.lower()}" for one in spelled]
    if subject is not None:
        left.add(subject.index)
    others = [
        child
        for child in children
        if child.index not in left | features.auxiliaries and child.deprel.split(":")[0] not in _NO_PHRASES
    ]
    return _Clause(tuple(dict.fromkeys(spelled)), subject, asks, asked, tuple(others), features)


def _spellings(word: Word) -> Tuple[str, ...]:
    return (word.lemma.lower(), word.said)


def _of_what_is_meant(verb: str, features: ClauseFeatures) -> Optional[ClauseFeatures]:
    """Return the features of a deed that is only planned or possible: "going to", "able to"; None for other verbs."""
    if verb in ("go to", "be about to"):
        return replace(features, aspect=Aspect.PLANNED)
    return replace(features, modal="can") if verb == "be able to" else None


def _asked(sentence: Sentence, features: ClauseFeatures) -> Tuple[str, int]:
    """Return what a clause asks, and the head of the phrase that is asked for."""
    if features.form is Form.PLAIN or not features.asked:
        return ("nothing" if features.form is Form.PLAIN else "whether"), 0
    word = sentence.word(features.asked)
    form = word.said
    head = word
    while (
        head.deprel in ("det", "amod", "advmod") and head.head and sentence.tree.governor(head).upos in ("NOUN", "ADJ")
    ):
        head = sentence.tree.governor(head)
    if form == _HOW and any(sentence.word(index).lemma.lower() == _MANY for index in sentence.subtree(head.index)):
        return "how many", head.index
    return ("what" if form in WHICH else "who" if form in WHO else form), head.index


class _Match:
    """A shape beside a clause."""

    def __init__(self, sentence: Sentence, clause: _Clause, shape: ClauseShape, words: FrozenSet[int]) -> None:
        self._sentence = sentence
        self._clause = clause
        self._shape = shape
        self._words = words
        self._small = _DETERMINERS.union(shape.beside)

    def elements(self) -> Optional[Dict[str, Tuple[int, ...]]]:
        """Return the words of each element; None if the clause does not have this shape."""
        shape, features = self._shape, self._clause.features
        # "Will" says when; "can't" is two words.
        modal = "" if features.modal in _FUTURE else "can" if features.modal == "ca" else features.modal
        modal_fits = (modal or NOBODY) in (shape.modals or (NOBODY,))
        if self._clause.asks not in shape.asks or not modal_fits or features.is_negated != shape.is_negated:
            return None
        if shape.aspects and features.aspect.value not in shape.aspects:
            return None
        return self._of_phrases() if self._has_subject() else None

    def _of_phrases(self) -> Optional[Dict[str, Tuple[int, ...]]]:
        shape, sentence, top = self._shape, self._sentence, self._clause.features.top
        said, beside = self._spans(shape.said), self._spans(shape.beside)
        if shape.said and not said:
            return None
        found: Dict[str, Tuple[int, ...]] = {}
        subject = self._clause.subject
        if subject is not None and ANYBODY in shape.subjects:
            name = self._element(subject)
            if not name:
                return None
            found[name] = self._phrase(subject)
        has_object = not shape.objects or NOBODY in shape.objects
        # "Which *room* is this" has its noun at the top.
        others = list(self._clause.others)
        if self._clause.asked == top and sentence.word(top).upos == "NOUN":
            others = [sentence.word(top), *(one for one in others if one.deprel.split(":")[0] not in _OF_NOUNS)]
        for word in others:
            phrase = self._phrase(word) if word.index != top else self._noun_phrase(word, others[1:])
            if frozenset(phrase) <= said | beside:
                continue
            name = self._element(word)
            if shape.objects and self._names(word, phrase, shape.objects):
                has_object = True
            elif name:
                found[name] = phrase
            elif not self._is_padding(word, phrase):
                return None
        return found if has_object else None

    def _element(self, word: Word) -> str:
        """Return the element that a phrase fills; empty for none, and for a pronoun, which names nothing."""
        top = self._clause.features.top
        if word.upos == "PRON":
            return ""
        governors = {top, word.head}
        for name, relations in self._shape.elements.items():
            if any(
                word.index in self._sentence.dependents(one, relation) for one in governors for relation in relations
            ):
                return name
        return ""

    def _has_subject(self) -> bool:
        subject, wanted = self._clause.subject, self._shape.subjects
        if subject is None:  # "What is next?"
            return (ASKED_FOR if self._clause.asked == self._clause.features.top else NOBODY) in wanted
        form = subject.said
        if self._clause.asked == subject.index:
            return ASKED_FOR in wanted
        if form in _HEARERS:
            return ROBOT in wanted
        if form in _SPEAKERS:
            return SPEAKER in wanted
        if ANYBODY in wanted or (form in _SPOKEN_OF and IT in wanted):
            return True
        return self._names(subject, self._phrase(subject), wanted)

    def _phrase(self, word: Word) -> Tuple[int, ...]:
        inside = self._sentence.subtree(word.index) & self._words
        return tuple(index for index in sorted(inside) if self._sentence.word(index).upos != "PUNCT")

    def _noun_phrase(self, top: Word, others: Sequence[Word]) -> Tuple[int, ...]:
        """Return the phrase of a noun that is the predicate, without its clause."""
        clause = [*others, *([self._clause.subject] if self._clause.subject else [])]
        lost = self._clause.features.auxiliaries.union(*(self._sentence.subtree(one.index) for one in clause))
        return tuple(index for index in self._phrase(top) if index not in lost)

    def _names(self, word: Word, phrase: Sequence[int], wanted: Sequence[str]) -> bool:
        """Whether a phrase says one of some things, with nothing beside it but determiners: "any of *your rules*"."""
        head = word
        while head.lemma.lower() in _KINDS | {"all"} or head.said in WHICH:
            inner = [child for child in self._sentence.children(head.index) if child.deprel == "nmod"]
            if not inner:
                break
            head = inner[0]
        said = {index: _spellings(self._sentence.word(index)) for index in phrase if index not in self._asking()}
        for thing in wanted:
            parts = thing.split()
            if not set(parts).intersection(_spellings(head)):
                continue
            rest = {
                index
                for index, spelled in said.items()
                if not set(parts).intersection(spelled) and not self._is_between(index, word, head)
            }
            has_all = all(any(part in spelled for spelled in said.values()) for part in parts)
            if has_all and all(self._sentence.word(index).said in self._small for index in rest):
                return True
        return False

    def _is_between(self, index: int, word: Word, head: Word) -> bool:
        """Whether a word only leads to the noun that is meant: "kind of"."""
        return self._is_case(index) or (index == word.index and word is not head)

    def _is_case(self, index: int) -> bool:
        return self._sentence.word(index).deprel == "case"

    def _asking(self) -> FrozenSet[int]:
        """Return the words that only ask: "which", "how many"."""
        asked = self._clause.features.asked
        if not asked:
            return frozenset()
        many = self._sentence.word(asked).head if self._clause.asks == "how many" else 0
        return frozenset([asked, many])

    def _is_padding(self, word: Word, phrase: Sequence[int]) -> bool:
        """Whether a phrase says nothing that matters: "already", "for us", and "what", which is asked for."""
        forms = [self._sentence.word(index).said for index in phrase if index not in self._asking()]
        if self._clause.asked in phrase:
            # "What *else* can you do", "what *kind of things* can you do".
            cases = {self._sentence.word(index).said for index in phrase if self._is_case(index)}
            return all(form in _GENERAL | _KINDS | _DETERMINERS | cases | {"else"} for form in forms)
        if word.said in _OBJECTS_OF_TALK:
            return len(phrase) <= 2
        return all(form in _PADDING for form in forms)

    def _spans(self, phrases: Sequence[str]) -> FrozenSet[int]:
        """Return the words of phrases that are said in the clause: "next time"."""
        # "Then" behind a question may be padding, or what is asked about.
        order = [word.index for word in self._sentence.tree.words if word.upos != "PUNCT"]
        forms = [self._sentence.word(index).said for index in order]
        found: List[int] = []
        for phrase in phrases:
            parts = phrase.split()
            for start in range(len(forms) - len(parts) + 1):
                if forms[start : start + len(parts)] == parts:
                    found += order[start : start + len(parts)]
        return frozenset(found)
