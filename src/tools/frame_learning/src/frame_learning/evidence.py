"""Finds, in one annotated sentence, the relations that lead from its verb to the heads of its frame elements."""

from dataclasses import dataclass
from typing import Dict, FrozenSet, List, Mapping, Optional, Sequence, Set, Tuple

from frame_learning.annotated_sentences import AnnotatedSentence, Span
from phrase_meanings.head_words import is_side_of_something
from semantic_framer.filling.attachment import places_before
from semantic_framer.filling.relation_paths import DIRECTIONAL
from semantic_framer.values.sentence import Sentence
from semantic_frames.frame import SemanticFrame
from semantic_frames.relation_names import MEASURE
from utterance_passes.trees.tree import VERBS
from word_classes import word_class

_DIRECTIONS = word_class("all_directions")
_HEARERS = word_class("hearers")
_PORTALS = word_class("portals")
#: Relations that an argument may have, the most specific first.
_PREFERRED = (
    "dobj", "iobj", "nsubj", "nsubjpass", "prt", "ccomp", "xcomp", "acomp", "attr", "advcl", "tmod", "advmod", "poss",
)  # fmt: skip
_CLOSED_CLASSES = frozenset(["ADV", "ADP", "PART"])
_LONGEST_PATH = 3


@dataclass(frozen=True)
class Lesson:
    """The evidence of one sentence.

    Attributes:
        sentence: the sentence
        verb: lemma, with its particle
        relations: path of relations from the verb by element
        words: lemma of the head by element
        closed: elements that a word of a closed class fills ("slowly", "left", "you")
        places: elements with a preposition of place, after an object; a parser may attach them to the object
        after_place: those of them that follow another phrase of place, with its preposition ("on" in "take the box on
            the table on the couch")
        arguments: arguments by element, in the form of the framer
    """

    sentence: AnnotatedSentence
    verb: str
    relations: Mapping[str, str]
    words: Mapping[str, str]
    closed: FrozenSet[str]
    places: FrozenSet[str]
    after_place: FrozenSet[Tuple[str, str]]
    arguments: Mapping[str, str]

    def is_of_subject(self, name: str) -> bool:
        """Whether an element is a place of what is said to be there: "a lamp *on the desk*"."""
        is_place = self.relations[name].startswith("prep_") and "dobj" not in self.relations.values()
        return is_place and "nsubj" in self.relations.values()


def lesson_of(
    annotated: AnnotatedSentence, sentence: Sentence, frame: Optional[SemanticFrame], unexplained: List[str]
) -> Optional[Lesson]:
    verb_words = _positions(sentence, annotated.verb)
    if not verb_words:
        unexplained.append(f'{annotated.place}: the parser has no word for the verb in "{annotated.text}"')
        return None
    ranked = [word for upos in VERBS for word in verb_words if sentence.word(word).upos == upos]
    verb = (ranked or list(verb_words))[0]
    particles = [
        sentence.word(word).said for word in verb_words if word > verb and sentence.word(word).upos in _CLOSED_CLASSES
    ]
    relations: Dict[str, str] = {}
    words: Dict[str, str] = {}
    arguments: Dict[str, str] = {}
    closed: Set[str] = set()
    places: Set[str] = set()
    after_place: Set[Tuple[str, str]] = set()
    for name, spans in annotated.elements.items():
        positions = _positions(sentence, spans)
        element = frame.element(name) if frame is not None else None
        if element is not None and element.quantity is not None:
            relations.update({measured: MEASURE for measured in (name, element.unit_element) if measured})
            continue
        head = _head(sentence, positions)
        path = _path(sentence, verb, head) if head else None
        if path is None:
            unexplained.append(f'{annotated.place}: nothing leads from the verb to {name} in "{annotated.text}"')
            continue
        if path[0] in ("dobj", "iobj", "nsubj", "tmod") and path[-1].startswith("prep_"):
            path = path[-1:]
        if len(path) == _LONGEST_PATH:
            unexplained.append(f'{annotated.place}: {name} is too far from the verb in "{annotated.text}"')
            continue
        if path[0].startswith("prep_") and path[0][len("prep_") :] not in DIRECTIONAL:
            places.add(name)
            after_place |= {(name, preposition) for preposition in places_before(sentence.tree, head)[:1]}
        relations[name] = "/".join(path)
        word = sentence.word(head)
        words[name] = word.said
        if (
            word.upos in _CLOSED_CLASSES
            or (word.said in _DIRECTIONS and not is_side_of_something(sentence.tree, head))
            or (path == ("dobj",) and word.said in _PORTALS)
            or (path[-1] == "nsubj" and word.said in _HEARERS)
        ):
            closed.add(name)
        arguments[name] = _argument(sentence, positions, head)
    return Lesson(
        sentence=annotated,
        verb=" ".join([sentence.word(verb).lemma.lower()] + particles),
        relations=relations,
        words=words,
        closed=frozenset(closed),
        places=frozenset(places) if "dobj" in relations.values() else frozenset(),
        after_place=frozenset(after_place),
        arguments=arguments,
    )


def _positions(sentence: Sentence, spans: Sequence[Span]) -> Tuple[int, ...]:
    return tuple(
        word.index
        for word in sentence.tree.words
        if any(word.start_character < end and start < word.end_character for start, end in spans)
    )


def _head(sentence: Sentence, positions: Sequence[int]) -> int:
    """Return the word of a phrase whose head is outside the phrase; of several the first noun or pronoun; 0 for
    none."""
    tops = [index for index in positions if sentence.word(index).head not in positions]
    nouns = [index for index in tops if sentence.word(index).upos in ("NOUN", "PROPN", "PRON", "NUM", "ADJ", "VERB")]
    return (nouns or tops or [0])[0]


def _path(sentence: Sentence, verb: int, head: int) -> Optional[Tuple[str, ...]]:
    """Return the shortest chain of relations from a verb to a word, collapsed names of prepositions first."""
    reached: Dict[int, Tuple[str, ...]] = {verb: ()}
    for _ in range(_LONGEST_PATH):
        for arc in sentence.arcs:
            before = reached.get(arc.governor)
            if before is not None and len(before) < _LONGEST_PATH and arc.dependent not in reached:
                name = _name(arc.relations)
                if name:
                    reached[arc.dependent] = before + (name,)
        if head in reached:
            return reached[head] or None
    return None


def _name(relations: FrozenSet[str]) -> str:
    prepositions = sorted(name for name in relations if name.startswith("prep_"))
    if prepositions:
        return prepositions[0]
    return next((name for name in _PREFERRED if name in relations), "")


def _argument(sentence: Sentence, positions: Sequence[int], head: int) -> str:
    """Return the words of an element without its first preposition."""
    cases = {
        inner
        for child in sentence.children(head)
        if child.deprel in ("case", "mark")
        for inner in sentence.subtree(child.index)
        if inner < head
    }
    return sentence.text([index for index in positions if index not in cases])
