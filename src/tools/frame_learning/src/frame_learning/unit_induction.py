"""Learns lexical units from annotated sentences: the relations between a verb and its elements in the parses.

Thomas and Jenkins (ICRA 2012, section IV) propose FrameNet's annotations for this. The result is an ordinary lexical
unit file. Verbs of a frame that take the same elements make one unit, and a preposition stands for those of its kind
(to: into, towards; from: out of, off), so a few sentences cover others.
"""

from collections import Counter, defaultdict
from dataclasses import dataclass, field
from typing import Callable, Dict, FrozenSet, Iterable, List, Mapping, Optional, Sequence, Set, Tuple
from typing import Counter as CounterType

from frame_learning.annotated_sentences import AnnotatedSentence
from frame_learning.evidence import Lesson, lesson_of
from semantic_framer.values.sentence import Sentence
from semantic_frames.frame import SemanticFrame
from semantic_frames.relation_names import MEASURE
from utterance_passes.engine.running import run_tree_passes
from utterance_passes.table import PARSE_CORRECTING_PASSES
from utterance_passes.trees.tree import DependencyTree
from utterance_passes.trees.vocabulary import Verbs
from word_classes import word_class, word_list

#: Prepositions with the same meaning for a frame element; one of a group stands for the whole group.
PREPOSITION_GROUPS: Tuple[Tuple[str, ...], ...] = tuple(
    tuple(phrase.replace(" ", "_") for phrase in word_list(name))
    for name in ("to_prepositions", "from_prepositions", "along_prepositions", "place_prepositions_alike")
)
#: Prepositions that mean the same in every frame.
_OF_PERIPHERAL = frozenset(f"prep_{preposition}" for group in PREPOSITION_GROUPS[1:3] for preposition in group)
#: Who gets something, or has it done for him, is said alike in every frame.
_OF_RECEIVERS = frozenset(["iobj", "prep_for"])
_RECEIVERS = frozenset(["Beneficiary", "Recipient"])
#: "Go to the hall by crossing the room" says the way, like "through the room".
_WAYS, _BY_DOING = frozenset(["prep_through", "prep_via", "prep_by"]), "prepc_by"
#: Words of closed classes of the same kind; one of a group stands for the whole group.
WORD_GROUPS: Tuple[Tuple[str, ...], ...] = tuple(
    word_list(name) for name in ("manner_adverbs", "left_and_right", "forward_and_backward", "portals")
)
_SIDES = word_class("left_and_right")
_OF_SIDES = frozenset(["advmod", "prep_to"])
#: Share of the sentences of a verb and a frame.
_NEARLY_ALWAYS = 0.8
#: FrameNet's names of elements that the same adverbs fill: "quickly".
_ALIKE = {"Speed": "Manner"}


@dataclass
class LearnedUnit:
    """A unit under construction; written by :func:`.unit_files.to_yaml`.

    Attributes:
        frame_name: the frame that it evokes
        verbs: lemmas, particles included
        verbs_alike: other verbs that mean the same as those, or ways to do it
        open_relations: relations by element, for any word
        closed_relations: relations by element, only for the words that were seen
        words: those words, by element
        required: elements without which the unit does not fit
        types: semantic types that also may fill an element with listed words: a beneficiary is a person
        after_place: elements that count only after another phrase of place, with its preposition
        lessons: evidence from which it was learned
    """

    frame_name: str
    verbs: List[str] = field(default_factory=list)
    verbs_alike: List[str] = field(default_factory=list)
    open_relations: Dict[str, List[str]] = field(default_factory=dict)
    closed_relations: Dict[str, List[str]] = field(default_factory=dict)
    words: Dict[str, List[str]] = field(default_factory=dict)
    types: Dict[str, Tuple[str, ...]] = field(default_factory=dict)
    required: Set[str] = field(default_factory=set)
    after_place: Dict[str, str] = field(default_factory=dict)
    lessons: List[Lesson] = field(default_factory=list)


def learn(
    sentences: Iterable[AnnotatedSentence],
    parse: Callable[[str], DependencyTree],
    frames: Mapping[str, SemanticFrame],
) -> Tuple[Tuple[LearnedUnit, ...], Tuple[str, ...]]:
    """Learn units.

    Args:
        sentences: annotated sentences
        parse: returns the tree of a text
        frames: known frames by name; an element with a quantity takes any measure
    Returns:
        units by frame, those with several required elements first, and one line for each sentence that is not explained
    """
    lessons: List[Lesson] = []
    unexplained: List[str] = []
    for sentence in sentences:
        tree = run_tree_passes(parse(sentence.text), Verbs(), PARSE_CORRECTING_PASSES)
        lesson = lesson_of(sentence, Sentence(tree), frames.get(sentence.frame_name), unexplained)
        if lesson is not None:
            lessons.append(lesson)
    return _units(lessons, frames), tuple(unexplained)


def _units(lessons: Sequence[Lesson], frames: Mapping[str, SemanticFrame]) -> Tuple[LearnedUnit, ...]:
    frames_of: Dict[str, Set[str]] = defaultdict(set)
    groups: Dict[Tuple[str, str, FrozenSet[str], FrozenSet[Tuple[str, str]]], List[Lesson]] = defaultdict(list)
    core = {
        name: core_elements(name, lessons, frames.get(name))
        for name in {lesson.sentence.frame_name for lesson in lessons}
    }
    for lesson in lessons:
        frame = lesson.sentence.frame_name
        frames_of[lesson.verb].add(frame)
        # A core element is searched for on the object anyway.
        places = lesson.places - core[frame]
        after_place = frozenset((name, preposition) for name, preposition in lesson.after_place if name in places)
        groups[(frame, lesson.verb, places, after_place)].append(lesson)
    rarer, same_shape = _rarer(lessons), _same_shape(lessons)
    units: Dict[object, LearnedUnit] = {}
    for (frame, verb, places, after_place), members in sorted(
        groups.items(), key=lambda item: (item[0][0], -len(item[0][2]))
    ):
        pieces = [(places, members)]
        if len(frames_of[verb]) > 1:
            # The frames of one verb differ in the elements that (nearly) all of their sentences have: "move to the
            # kitchen" has a goal; "move to your left" has none and makes a unit of its own.
            telling = _telling(members)
            if _is_told_by_core(frame, members, core, lessons):
                # "Look *for* the mug", "look *at* the mug": where to look need not be said.
                telling &= core[frame]
            others = [lesson for lesson in members if not telling <= set(lesson.relations)]
            pieces = [(places | telling, [lesson for lesson in members if lesson not in others])]
            pieces += [(places | _telling(others), others)] if others else []
        for required, piece in pieces:
            empty = LearnedUnit(frame, required=set(required), after_place=dict(after_place))
            unit = units.setdefault((frame, required, places, after_place, same_shape.get((verb, frame))), empty)
            unit.verbs += [verb] if verb not in unit.verbs else []
            unit.lessons += piece
    for unit in units.values():
        _fill(unit, rarer, same_shape, frames.get(unit.frame_name))
    _share_without_particles(list(units.values()))
    _share_closed(list(units.values()), lessons)
    _share_optional(list(units.values()))
    _share_between_frames(list(units.values()), lessons, frames)
    return tuple(sorted(units.values(), key=lambda unit: (unit.frame_name, -len(unit.required))))


def _is_told_by_core(
    frame: str, members: Sequence[Lesson], core: Mapping[str, FrozenSet[str]], lessons: Sequence[Lesson]
) -> bool:
    """Whether the core elements alone tell the sentences of a verb and frame from those of its other frames: they are
    said in all of them, and with other relations."""
    said = _core_relations(members, core[frame])
    if not said or any(not core[frame] <= frozenset(lesson.relations) for lesson in members):
        return False
    verb = members[0].verb
    others = [lesson for lesson in lessons if lesson.verb == verb and lesson.sentence.frame_name != frame]
    return not any(said & _core_relations([other], core[other.sentence.frame_name]) for other in others)


def _core_relations(lessons: Sequence[Lesson], core: FrozenSet[str]) -> FrozenSet[str]:
    return frozenset(lesson.relations[name] for lesson in lessons for name in core & frozenset(lesson.relations))


def _telling(lessons: Sequence[Lesson]) -> FrozenSet[str]:
    """Return the elements that sentences of a verb and frame nearly always have.

    Of a single sentence the open elements count, or all elements if none is open.
    """
    counts = Counter(name for lesson in lessons for name in lesson.relations)
    return frozenset(
        name
        for name, count in counts.items()
        if count >= _NEARLY_ALWAYS * len(lessons)
        and not any(lesson.relations.get(name) == "nsubj" for lesson in lessons)
        and (len(lessons) > 1 or name not in lessons[0].closed or lessons[0].closed == set(lessons[0].relations))
    )


def _share_without_particles(units: Sequence[LearnedUnit]) -> None:
    """Give units that know a verb with one particle only the verb alone: "pick the mug" for "pick up the mug".

    A verb that has several particles, or evokes several frames, means nothing certain without them.
    """
    particles: Dict[str, Set[Tuple[str, str]]] = defaultdict(set)
    for unit in units:
        for verb in unit.verbs:
            base, _, particle = verb.partition(" ")
            particles[base].add((particle, unit.frame_name))
    for unit in units:
        for verb in list(unit.verbs):
            base, _, particle = verb.partition(" ")
            if particle and len(particles[base]) == 1:
                unit.verbs.append(base)


def _share_closed(units: Sequence[LearnedUnit], lessons: Sequence[Lesson]) -> None:
    """Give each unit the relations of words of a closed class in its frame, and all of those words.

    "Slowly" says how with any verb, and "you" may be told to take as well as to grasp.
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
            _fill_closed(unit, name, relation, said[(name, relation)])


def _fill_closed(unit: LearnedUnit, name: str, relation: str, said: Sequence[str]) -> None:
    """Let words of a closed class, and those of their group, fill an element."""
    seen = unit.closed_relations.setdefault(name, [])
    seen += [relation] if relation not in seen else []
    words = unit.words.setdefault(name, [])
    words += [word for word in said if word not in words]
    for group in WORD_GROUPS:
        if any(word in group for word in words):
            words += [word for word in group if word not in words]
    if _SIDES & frozenset(words) and _OF_SIDES & frozenset(seen):
        # "Turn left" and "turn to the left" mean the same.
        seen += [other for other in sorted(_OF_SIDES) if other not in seen]


def _share_between_frames(
    units: Sequence[LearnedUnit], lessons: Sequence[Lesson], frames: Mapping[str, SemanticFrame]
) -> None:
    """Give each unit the relations that express manner, path or source in other frames.

    An element that is core in neither frame and has one name in FrameNet (Manner, Speed, Path, Source) is expressed in
    the same way in both: "go through the main door", "enter through the main door".
    """
    words: Dict[Tuple[str, str], List[str]] = defaultdict(list)
    for lesson in lessons:
        names = _peripheral(frames.get(lesson.sentence.frame_name))
        for name in sorted(lesson.closed & set(names)):
            words[(names[name], lesson.relations[name])].append(lesson.words[name])
    prepositions: Dict[str, List[str]] = defaultdict(list)
    for unit in units:
        for name, shared in _peripheral(frames.get(unit.frame_name)).items():
            alike = _OF_RECEIVERS if shared in _RECEIVERS else _OF_PERIPHERAL
            said = unit.open_relations.get(name, []) + unit.closed_relations.get(name, [])
            prepositions[shared] += [relation for relation in said if relation in alike]
            if shared == "Path" and _WAYS.intersection(said):
                prepositions[shared].append(_BY_DOING)
    for unit in units:
        for name, shared in _peripheral(frames.get(unit.frame_name)).items():
            if name in unit.required:
                continue
            # "Turn left quickly": the words tell a direction from a manner.
            others = {word for other, listed in unit.words.items() if other != name for word in listed}
            for (other, relation), said in sorted(words.items()):
                if other == shared and name not in unit.open_relations and not others.intersection(said):
                    _fill_closed(unit, name, relation, said)
            taken = {relation for relations in unit.open_relations.values() for relation in relations}
            new = [relation for relation in dict.fromkeys(prepositions[shared]) if relation not in taken]
            if new and name not in unit.closed_relations:
                unit.open_relations.setdefault(name, []).extend(new)


def _peripheral(frame: Optional[SemanticFrame]) -> Mapping[str, str]:
    """Return the elements of a frame that are not core, with their names in FrameNet."""
    elements = frame.frame_elements if frame is not None else ()
    return {
        element.name: _ALIKE.get(element.framenet, element.framenet)
        for element in elements
        if element.framenet and not element.is_core
    }


def _share_optional(units: Sequence[LearnedUnit]) -> None:
    """Give each unit the prepositions of elements that the other units of its frame do not require: "from" with any
    verb."""
    optional: Dict[str, Dict[str, List[str]]] = defaultdict(dict)
    for unit in units:
        for name, relations in unit.open_relations.items():
            if name not in unit.required:
                said = optional[unit.frame_name].setdefault(name, [])
                said += [item for item in relations if item.startswith("prep_") and item not in said]
    for unit in units:
        for name, relations in optional[unit.frame_name].items():
            if name in unit.required:
                continue
            taken = {item for other, others in unit.open_relations.items() if other != name for item in others}
            new = [item for item in relations if item not in taken and item not in unit.open_relations.get(name, [])]
            if new:
                unit.open_relations.setdefault(name, []).extend(new)


def core_elements(name: str, lessons: Sequence[Lesson], frame: Optional[SemanticFrame]) -> FrozenSet[str]:
    """Return the core elements of a frame: those of its file, or those that every sentence fills."""
    if frame is not None:
        return frozenset(element.name for element in frame.frame_elements if element.is_core)
    said = [frozenset(lesson.sentence.elements) for lesson in lessons if lesson.sentence.frame_name == name]
    return frozenset.intersection(*said)


def _rarer(lessons: Sequence[Lesson]) -> FrozenSet[Tuple[str, str, str]]:
    """Return frame, element and relation where another element of the frame has the relation more often.

    Their words distinguish such elements: "bring it to the kitchen", "bring it to my mother".
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
    """Return the relations that most sentences of a verb and frame have, or the element if its relation varies."""
    seen: Dict[str, List[str]] = defaultdict(list)
    for lesson in lessons:
        for name, relation in lesson.relations.items():
            seen[name].append(relation)
    return frozenset(
        relations[0] if len(set(relations)) == 1 else name
        for name, relations in seen.items()
        if 2 * len(relations) > len(lessons) and relations[0] != "nsubj"
    )


def _same_shape(lessons: Sequence[Lesson]) -> Mapping[Tuple[str, str], FrozenSet[Tuple[str, str]]]:
    """Return elements and relations of verbs that evoke another frame with the same relations more often.

    The words distinguish such frames: "open the door", "open the water". They do so for this verb alone: any device is
    switched on.

    Returns:
        elements with their relations, by verb and frame
    """
    members: Dict[Tuple[str, str], List[Lesson]] = defaultdict(list)
    for lesson in lessons:
        # Words of a closed class distinguish a frame by themselves.
        if set(lesson.relations) != lesson.closed:
            members[(lesson.verb, lesson.sentence.frame_name)].append(lesson)
    shapes = {key: _shape(some) for key, some in members.items()}
    found: Dict[Tuple[str, str], FrozenSet[Tuple[str, str]]] = {}
    for (verb, frame), shape in shapes.items():
        if shape and any(
            verb == other_verb
            and frame != other
            and shape == other_shape
            and (len(members[(verb, frame)]), frame) < (len(members[(verb, other)]), other)
            for (other_verb, other), other_shape in shapes.items()
        ):
            found[(verb, frame)] = frozenset(
                (name, relation)
                for lesson in members[(verb, frame)]
                for name, relation in lesson.relations.items()
                if relation in shape and relation != "nsubj"
            )
    return found


def _fill(
    unit: LearnedUnit,
    rarer: FrozenSet[Tuple[str, str, str]],
    same_shape: Mapping[Tuple[str, str], FrozenSet[Tuple[str, str]]],
    frame: Optional[SemanticFrame],
) -> None:
    for lesson in unit.lessons:
        for name, relation in lesson.relations.items():
            element = frame.element(name) if frame is not None else None
            if lesson.is_of_subject(name):
                # "There is a lamp on the desk": the parser may attach the place to either.
                alike = unit.open_relations.setdefault(name, [])
                alike += [f"nsubj/{relation}"] if f"nsubj/{relation}" not in alike else []
            if (unit.frame_name, name, relation) in rarer and element is not None and element.semantic_types:
                unit.types[name] = element.semantic_types
            is_closed = (relation != MEASURE and name in lesson.closed) or (unit.frame_name, name, relation) in rarer
            is_closed |= (name, relation) in same_shape.get((lesson.verb, unit.frame_name), ())
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
