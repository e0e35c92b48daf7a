"""Lexical units from annotated sentences: the relations that their parses show between a verb and its elements.

FrameNet's annotations were meant for this (Thomas and Jenkins, ICRA 2012, section IV). What is learned is an ordinary
lexical unit file: verbs of a frame that want the same elements are one unit, and a preposition stands for those of its
kind (to: into, towards; from: out of, off), so that ten sentences say something about others.
"""

from collections import Counter, defaultdict
from dataclasses import dataclass, field
from typing import Callable
from typing import Counter as CounterType
from typing import Dict, FrozenSet, Iterable, List, Mapping, Optional, Sequence, Set, Tuple

from roboframenet_tools.annotated_sentences import AnnotatedSentence, Span
from semantic_frames.frame import SemanticFrame
from semantic_frames.relation_names import MEASURE
from semantic_framer.matching import DIRECTIONAL
from semantic_framer.sentence import Sentence
from stanford_parser_ros.tree import DependencyTree

#: Prepositions that say the same of a frame element; one of a group stands for all of it.
PREPOSITION_GROUPS: Tuple[Tuple[str, ...], ...] = (
    ("to", "into", "onto", "towards", "toward"),
    ("from", "out_of", "off"),
    ("through", "along", "across", "via", "past", "around"),
    (
        "in", "on", "at", "near", "next_to", "in_front_of", "inside", "under", "behind", "by", "beside", "between",
        "above", "over", "close_to",
    ),
)  # fmt: skip
#: Relations that an argument may have, the most telling first.
_PREFERRED = (
    "dobj", "iobj", "nsubj", "nsubjpass", "prt", "ccomp", "xcomp", "acomp", "attr", "advcl", "tmod", "advmod", "poss",
)  # fmt: skip
_CLOSED_CLASSES = frozenset(["ADV", "ADP", "PART"])
_DIRECTIONS = frozenset("left right forward forwards backward backwards back up down around".split())
_LONGEST_PATH = 2
#: So many examples stand in a file; more make it hard to read.
MOST_EXAMPLES = 6


@dataclass(frozen=True)
class Lesson:
    """What one sentence shows.

    Attributes:
        sentence: the sentence
        verb: lemma, with its particle
        relations: path of relations from the verb by element
        words: lemma of the head by element
        closed: elements that a word of a closed class fills ("slowly", "left", "you")
        places: elements with a preposition that says where, behind an object: a parser may hang them on the object
        arguments: by element, as the framer would give them
    """

    sentence: AnnotatedSentence
    verb: str
    relations: Mapping[str, str]
    words: Mapping[str, str]
    closed: FrozenSet[str]
    places: FrozenSet[str]
    arguments: Mapping[str, str]


@dataclass
class LearnedUnit:
    """A unit that is being put together; written by :func:`to_yaml`.

    Attributes:
        frame_name: the frame that it evokes
        verbs: lemmas, particles included
        open_relations: relations by element, whatever the word is
        closed_relations: relations by element for the words alone that were seen
        words: those words, by element
        required: elements without which the unit does not count
        lessons: what it was learned from
    """

    frame_name: str
    verbs: List[str] = field(default_factory=list)
    open_relations: Dict[str, List[str]] = field(default_factory=dict)
    closed_relations: Dict[str, List[str]] = field(default_factory=dict)
    words: Dict[str, List[str]] = field(default_factory=dict)
    required: Set[str] = field(default_factory=set)
    lessons: List[Lesson] = field(default_factory=list)


def learn(
    sentences: Iterable[AnnotatedSentence],
    parse: Callable[[str], DependencyTree],
    frames: Mapping[str, SemanticFrame],
) -> Tuple[Tuple[LearnedUnit, ...], Tuple[str, ...]]:
    """Learn units.

    Args:
        sentences: annotated
        parse: gives the tree of a text
        frames: that are known, by name: an element that measures takes any measure
    Returns:
        units by frame, those of several required elements first; and one line for each thing that was not explained
    """
    lessons: List[Lesson] = []
    unexplained: List[str] = []
    for sentence in sentences:
        lesson = _lesson(sentence, Sentence(parse(sentence.text)), frames.get(sentence.frame_name), unexplained)
        if lesson is not None:
            lessons.append(lesson)
    return _units(lessons, frames), tuple(unexplained)


def _lesson(
    annotated: AnnotatedSentence, sentence: Sentence, frame: Optional[SemanticFrame], unexplained: List[str]
) -> Optional[Lesson]:
    verb_words = _positions(sentence, annotated.verb)
    if not verb_words:
        unexplained.append(f'{annotated.place}: the parser has no word for the verb in "{annotated.text}"')
        return None
    ranked = [word for upos in ("VERB", "AUX") for word in verb_words if sentence.word(word).upos == upos]
    verb = (ranked or list(verb_words))[0]
    particles = [
        sentence.word(word).form.lower()
        for word in verb_words
        if word > verb and sentence.word(word).upos in _CLOSED_CLASSES
    ]
    relations: Dict[str, str] = {}
    words: Dict[str, str] = {}
    arguments: Dict[str, str] = {}
    closed: Set[str] = set()
    places: Set[str] = set()
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
        if len(path) == 2 and path[0] in ("dobj", "iobj", "nsubj", "tmod") and path[1].startswith("prep_"):
            path = path[1:]
        if path[0].startswith("prep_") and path[0][len("prep_") :] not in DIRECTIONAL:
            places.add(name)
        relations[name] = "/".join(path)
        word = sentence.word(head)
        words[name] = word.form.lower()
        if (
            word.upos in _CLOSED_CLASSES
            or word.form.lower() in _DIRECTIONS
            or (path[-1] == "nsubj" and word.form.lower() in ("you", "u"))
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
        arguments=arguments,
    )


def _positions(sentence: Sentence, spans: Sequence[Span]) -> Tuple[int, ...]:
    return tuple(
        word.index
        for word in sentence.tree.words
        if any(word.start_character < end and start < word.end_character for start, end in spans)
    )


def _head(sentence: Sentence, positions: Sequence[int]) -> int:
    """Return the word of a phrase that hangs outside of it; of several the first noun or pronoun; 0 for none."""
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
    """Return the words of an element without a preposition at its front."""
    cases = {
        inner
        for child in sentence.children(head)
        if child.deprel in ("case", "mark")
        for inner in sentence.subtree(child.index)
        if inner < head
    }
    return sentence.text([index for index in positions if index not in cases])


def _units(lessons: Sequence[Lesson], frames: Mapping[str, SemanticFrame]) -> Tuple[LearnedUnit, ...]:
    frames_of: Dict[str, Set[str]] = defaultdict(set)
    hanging: Dict[Tuple[str, str], Set[str]] = defaultdict(set)
    core = {name: _core(name, lessons, frames.get(name)) for name in {lesson.sentence.frame_name for lesson in lessons}}
    for lesson in lessons:
        frames_of[lesson.verb].add(lesson.sentence.frame_name)
        # A core element is looked for on the object anyway.
        hanging[(lesson.sentence.frame_name, lesson.verb)] |= lesson.places - core[lesson.sentence.frame_name]
    groups: Dict[Tuple[str, str, FrozenSet[str]], List[Lesson]] = defaultdict(list)
    for lesson in lessons:
        frame = lesson.sentence.frame_name
        groups[(frame, lesson.verb, frozenset(hanging[(frame, lesson.verb)] & set(lesson.relations)))].append(lesson)
    units: Dict[Tuple[str, FrozenSet[str]], LearnedUnit] = {}
    for (frame, verb, wanted), members in sorted(groups.items(), key=lambda item: (item[0][0], -len(item[0][2]))):
        required = set(wanted)
        if len(frames_of[verb]) > 1:
            # What tells the frames of one verb apart is what each of them always has; of one sentence what is open.
            required |= {
                name
                for name in set.intersection(*(set(lesson.relations) for lesson in members))
                if members[0].relations[name] != "nsubj" and (len(members) > 1 or name not in members[0].closed)
            }
        unit = units.setdefault((frame, frozenset(required)), LearnedUnit(frame, required=required))
        unit.verbs += [verb] if verb not in unit.verbs else []
        unit.lessons += members
    rarer = _rarer(lessons) | _same_shape(lessons)
    for unit in units.values():
        _fill(unit, rarer)
    _share_closed(list(units.values()), lessons)
    return tuple(sorted(units.values(), key=lambda unit: (unit.frame_name, -len(unit.required))))


def _share_closed(units: Sequence[LearnedUnit], lessons: Sequence[Lesson]) -> None:
    """Give each unit what words of a closed class were seen to do in its frame, and all of those words.

    "Slowly" says how, with whatever verb; who is told "you" to grasp may be told to take.
    """
    said: Dict[Tuple[str, str], List[str]] = defaultdict(list)
    of_frame: Dict[str, Set[Tuple[str, str]]] = defaultdict(set)
    for lesson in lessons:
        for name in sorted(lesson.closed):
            key = (name, lesson.relations[name])
            if lesson.words[name] not in said[key]:
                said[key].append(lesson.words[name])
            of_frame[lesson.sentence.frame_name].add(key)
    for unit in units:
        for name, relation in sorted(of_frame[unit.frame_name]):
            if relation in unit.open_relations.get(name, []):
                continue
            seen = unit.closed_relations.setdefault(name, [])
            seen += [relation] if relation not in seen else []
            words = unit.words.setdefault(name, [])
            words += [word for word in said[(name, relation)] if word not in words]


def _core(name: str, lessons: Sequence[Lesson], frame: Optional[SemanticFrame]) -> FrozenSet[str]:
    """Return the core elements of a frame: what its file says, or what every sentence fills."""
    if frame is not None:
        return frozenset(element.name for element in frame.frame_elements if element.is_core)
    said = [frozenset(lesson.sentence.elements) for lesson in lessons if lesson.sentence.frame_name == name]
    return frozenset.intersection(*said)


def _rarer(lessons: Sequence[Lesson]) -> FrozenSet[Tuple[str, str, str]]:
    """Return frame, element and relation where another element of the frame has the relation more often.

    Such elements are told apart by their words: "bring it to the kitchen", "bring it to my mother".
    """
    counts: CounterType[Tuple[str, str, str]] = Counter(
        (lesson.sentence.frame_name, name, relation)
        for lesson in lessons
        for name, relation in lesson.relations.items()
        if name not in lesson.closed and relation != MEASURE
    )
    return frozenset(
        (frame, name, relation)
        for (frame, name, relation), count in counts.items()
        if any(
            (frame, relation) == (other_frame, other_relation) and name != other and count < other_count
            for (other_frame, other, other_relation), other_count in counts.items()
        )
    )


def _shape(lessons: Sequence[Lesson]) -> FrozenSet[str]:
    """Return what most sentences of a verb and frame have: relations, or the element where its relation varies."""
    seen: Dict[str, List[str]] = defaultdict(list)
    for lesson in lessons:
        for name, relation in lesson.relations.items():
            seen[name].append(relation)
    return frozenset(
        relations[0] if len(set(relations)) == 1 else name
        for name, relations in seen.items()
        if 2 * len(relations) > len(lessons) and relations[0] != "nsubj"
    )


def _same_shape(lessons: Sequence[Lesson]) -> FrozenSet[Tuple[str, str, str]]:
    """Return frame, element and relation where a verb evokes another frame by the same relations more often.

    Such frames are told apart by the words: "open the door", "open the water".
    """
    members: Dict[Tuple[str, str], List[Lesson]] = defaultdict(list)
    for lesson in lessons:
        members[(lesson.verb, lesson.sentence.frame_name)].append(lesson)
    shapes = {key: _shape(some) for key, some in members.items()}
    found: Set[Tuple[str, str, str]] = set()
    for (verb, frame), shape in shapes.items():
        if shape and any(
            verb == other_verb
            and frame != other
            and shape == other_shape
            and (len(members[(verb, frame)]), frame) < (len(members[(verb, other)]), other)
            for (other_verb, other), other_shape in shapes.items()
        ):
            found |= {
                (frame, name, relation)
                for lesson in members[(verb, frame)]
                for name, relation in lesson.relations.items()
                if relation in shape and relation != "nsubj"
            }
    return frozenset(found)


def _fill(unit: LearnedUnit, rarer: FrozenSet[Tuple[str, str, str]]) -> None:
    for lesson in unit.lessons:
        for name, relation in lesson.relations.items():
            is_closed = relation != MEASURE and name in lesson.closed or (unit.frame_name, name, relation) in rarer
            seen = (unit.closed_relations if is_closed else unit.open_relations).setdefault(name, [])
            seen += [relation] if relation not in seen else []
            if is_closed and lesson.words[name] not in unit.words.setdefault(name, []):
                unit.words[name].append(lesson.words[name])
    for name, relations in unit.open_relations.items():
        taken = {other for key, others in unit.open_relations.items() if key != name for other in others}
        for group in PREPOSITION_GROUPS:
            said = [f"prep_{preposition}" for preposition in group]
            if any(relation in said for relation in relations):
                relations += [relation for relation in said if relation not in relations and relation not in taken]


def to_yaml(units: Sequence[LearnedUnit], is_understood: Callable[[Lesson], bool]) -> str:
    """Write the units of one frame as a lexical unit file.

    Args:
        units: of one frame
        is_understood: whether a sentence may stand as an example
    """
    lines: List[str] = []
    for unit in units:
        lines += [f"- frame_name: {unit.frame_name}", f"  verb: [{', '.join(unit.verbs)}]"]
        if unit.open_relations or unit.closed_relations:
            lines.append("  frame_element_grammatical_relations:")
        for name, relations in list(unit.closed_relations.items()) + list(unit.open_relations.items()):
            is_closed = unit.closed_relations.get(name) is relations
            lines += [f"    - name: {name}", f"      relation: [{', '.join(relations)}]", "      argument: phrase"]
            lines += [f"      words: [{', '.join(map(_quoted, unit.words[name]))}]"] if is_closed else []
            lines += ["      required: True"] if name in unit.required else []
        examples = [lesson for lesson in unit.lessons if is_understood(lesson)][:MOST_EXAMPLES]
        if examples:
            lines.append("  examples:")
        for lesson in examples:
            filled = ", ".join(f"{name}: {_quoted(words)}" for name, words in lesson.arguments.items())
            lines.append(f"    - text: {_quoted(lesson.sentence.text)}")
            lines += [f"      frame_elements: {{{filled}}}"] if filled else []
    return "\n".join(lines) + "\n"


def frame_yaml(name: str, lessons: Sequence[Lesson]) -> str:
    """Write the file of a frame that no file describes yet; what every sentence fills is core."""
    names = list(dict.fromkeys(element for lesson in lessons for element in lesson.sentence.elements))
    core = _core(name, lessons, None)
    verbs = sorted({lesson.verb for lesson in lessons})
    lines = [
        "# Learned. Name the frame of FrameNet in `framenet`, or say in a comment why it has none.",
        f"name: {name}",
        f"description: The robot does what {' or '.join(_quoted(verb) for verb in verbs)} means.",
    ]
    lines += ["frame_elements:"] if names else []
    for element in names:
        lines += [f"  - name: {element}", f"    is_core: {element in core}"]
    return "\n".join(lines) + "\n"


def names_of_new_frames(frames: Mapping[str, SemanticFrame], units: Sequence[LearnedUnit]) -> Tuple[str, ...]:
    """Return the names of frames that units evoke and no file describes."""
    return tuple(sorted({unit.frame_name for unit in units} - set(frames)))


def _quoted(text: str) -> str:
    return '"' + text.replace("\\", "\\\\").replace('"', '\\"') + '"'
