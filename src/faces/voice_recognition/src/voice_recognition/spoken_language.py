"""What can be said to the robot: templates with slots, made from the examples of its lexical units."""

import re
from dataclasses import dataclass
from typing import Dict, FrozenSet, Iterable, Iterator, List, Mapping, Optional, Sequence, Set, Tuple, Union

from semantic_frames.frame import Quantity, SemanticFrame
from semantic_frames.lexical_unit import Example, LexicalUnit
from semantic_frames.semantic_type import with_parents
from semantic_types import WordTypes
from spoken_quantities.numbers import QuantityError, parse_number
from voice_recognition.voice_words import voice_words, words_of_number

Words = Tuple[str, ...]
_WORD = re.compile(r"[A-Za-z]+(?:['’.-][A-Za-z]+)*|\d+")
#: Words of the longest filler of a class; longer ones stay in their example.
_LONGEST_FILLER = 3


@dataclass(frozen=True)
class Filler:
    """What may stand in a slot.

    Attributes:
        ways: the ways to say it, in words; the usual one first
        text: as it is written, "the kitchen", "120 degrees"
        values: arguments of the elements of its slot: ("120", "degrees")
    """

    ways: Tuple[Words, ...]
    text: str
    values: Tuple[str, ...]


@dataclass(frozen=True)
class Slot:
    """A place in a template.

    Attributes:
        filled_from: name of the class of its fillers
        elements: frame elements that a filler fills
    """

    filled_from: str
    elements: Tuple[str, ...]


Part = Union[str, Slot]


@dataclass(frozen=True)
class Template:
    """A command with slots.

    Attributes:
        frame: the frame that it evokes
        parts: words in lower case, and slots
        fixed: arguments that its words give, without those that are the default
        begins_with_verb: whether it begins with the verb of its unit: "turn left", not "high five"
        text: the example that it was made from
    """

    frame: str
    parts: Tuple[Part, ...]
    fixed: Tuple[Tuple[str, str], ...] = ()
    begins_with_verb: bool = True
    text: str = ""

    @property
    def elements(self) -> FrozenSet[str]:
        """Names of the elements that it fills."""
        return frozenset(name for name, _ in self.fixed) | {
            name for part in self.parts if isinstance(part, Slot) for name in part.elements
        }

    @property
    def slots(self) -> Tuple[Slot, ...]:
        """Its slots, in order."""
        return tuple(part for part in self.parts if isinstance(part, Slot))


@dataclass(frozen=True)
class SpokenLanguage:
    """Everything that can be said to the robot.

    Attributes:
        templates: without repeats
        classes: fillers by the name of their class
        defaults: arguments of elements that nobody names, by frame
    """

    templates: Tuple[Template, ...]
    classes: Mapping[str, Tuple[Filler, ...]]
    defaults: Mapping[str, Tuple[Tuple[str, str], ...]]

    def vocabulary(self) -> Words:
        """Every word of it, sorted."""
        words = {part for template in self.templates for part in template.parts if isinstance(part, str)}
        used = {slot.filled_from for template in self.templates for slot in template.slots}
        for name in used:
            words.update(word for filler in self.classes[name] for way in filler.ways for word in way)
        return tuple(sorted(words))


#: Names that the robot knows, and the semantic types of each.
KnownTypes = Mapping[str, Sequence[str]]


def make_language(
    frames: Mapping[str, SemanticFrame],
    units: Iterable[LexicalUnit],
    grounded: FrozenSet[str],
    names: KnownTypes,
    types: WordTypes,
) -> SpokenLanguage:
    """Make what can be said to a robot.

    Args:
        frames: by name
        units: with their examples
        grounded: names of the frames that the robot can carry out; only they are in the language
        names: what the robot knows, "kitchen", "Alice"
        types: semantic types of words, for the fillers of the examples
    """
    maker = _Maker(frames, names, types)
    wanted = [unit for unit in units if unit.frame_name in grounded and unit.frame_name in frames]
    for unit in wanted:
        for example in unit.examples:
            maker.learn(unit, example)
    templates: Dict[Tuple[Part, ...], Template] = {}
    for unit in wanted:
        for example in unit.examples:
            template = maker.template(unit, example)
            if template is not None:
                templates.setdefault(template.parts, template)
    defaults = {
        name: tuple((element.name, element.default) for element in frames[name].frame_elements if element.default)
        for name in {unit.frame_name for unit in wanted}
    }
    return SpokenLanguage(tuple(templates.values()), maker.classes(), defaults)


def grounded_frames(frames: Mapping[str, SemanticFrame], served: FrozenSet[str]) -> FrozenSet[str]:
    """Return the frames that can be carried out: those with a server, and those with a sequence of such children."""
    grounded = set(served & set(frames))
    while True:
        more = {
            name
            for name, frame in frames.items()
            if name not in grounded
            and any(all(child.name in grounded for child in sequence) for sequence in frame.children)
        }
        if not more:
            return frozenset(grounded)
        grounded |= more


def spoken_words(text: str) -> Words:
    """Return the words of a text as they are said, in lower case: "Turn left 120 degrees." has "one", "hundred", ..."""
    return tuple(word for token in tokens_of(text) for word in token.ways[0])


@dataclass(frozen=True)
class Token:
    """A word, or a number of one or several words."""

    text: str
    number: Optional[int] = None

    @property
    def ways(self) -> Tuple[Words, ...]:
        """The ways to say it."""
        if self.number is not None and 0 <= self.number < 1000:
            return words_of_number(self.number)
        return ((self.text.lower().replace("’", "'"),),)


def tokens_of(text: str) -> Tuple[Token, ...]:
    """Return the words of a text; number words that belong together are one token."""
    words = [match.group() for match in _WORD.finditer(text)]
    found: List[Token] = []
    at = 0
    while at < len(words):
        length, number = _number_at(words, at)
        if length:
            found.append(Token(" ".join(words[at : at + length]), number))
            at += length
        else:
            found.append(Token(words[at]))
            at += 1
    return tuple(found)


def _number_at(words: Sequence[str], at: int) -> Tuple[int, Optional[int]]:
    """Return how many words a whole number has that begins here, and the number; 0 for none."""
    known = voice_words()
    names = {*known.small_numbers, *known.tens, known.hundred}

    def is_part(word: str) -> bool:
        return word.isdigit() or all(part in names for part in word.lower().split("-"))

    if not is_part(words[at]):
        return 0, None
    end = at + 1
    while end < len(words) and end - at < 5 and is_part(words[end]):
        end += 1
    for last in range(end, at, -1):
        try:
            value = parse_number(" ".join(words[at:last]))
        except QuantityError:
            continue
        if value == int(value):
            return last - at, int(value)
    return 0, None


class _Maker:
    """Collects fillers, then makes templates."""

    def __init__(self, frames: Mapping[str, SemanticFrame], names: KnownTypes, types: WordTypes) -> None:
        self._frames = frames
        self._names = names
        self._types = types
        self._fillers: Dict[str, Dict[str, Filler]] = {}
        self._seeded: Set[str] = set()
        self._add_measures()

    def classes(self) -> Mapping[str, Tuple[Filler, ...]]:
        return {name: tuple(fillers.values()) for name, fillers in self._fillers.items()}

    def _add_measures(self) -> None:
        for quantity, units in voice_words().measures.items():
            for (one, several), numbers in units.items():
                for number in numbers:
                    unit = one if number == 1 else several
                    ways = tuple((*way, *unit.split()) for way in words_of_number(number))
                    text = f"{number} {unit}".strip()
                    self._add(f"{quantity}", Filler(ways, text, (str(number), unit)))
                    self._add(f"{quantity}_whole", Filler(ways, text, (text,)))

    def _add(self, name: str, filler: Filler) -> None:
        self._fillers.setdefault(name, {}).setdefault(filler.text.lower(), filler)

    def learn(self, unit: LexicalUnit, example: Example) -> None:
        """Add the arguments of an example to their classes."""
        for element, value in example.frame_elements.items():
            name = self._class_of(unit, example, element, value)
            if name and name.split("_")[0] not in voice_words().measures:
                self._add_value(name, value)
                if name not in self._seeded:
                    self._seeded.add(name)
                    self._seed(name, unit, element)

    def _seed(self, name: str, unit: LexicalUnit, element: str) -> None:
        """Add the listed words, or the names that the robot knows, to a class."""
        semantic_type = name.rsplit(":", 1)[-1]
        if not semantic_type:
            return
        frame_element = self._frames[unit.frame_name].element(element)
        accepted = frame_element.semantic_types if frame_element is not None else ()
        for known, known_types in self._names.items():
            if _coarse(known_types[0]) != semantic_type:
                continue
            if not accepted or any(one in with_parents(known_types[0]) for one in accepted):
                is_person = any("Sentient" in with_parents(one) for one in known_types)
                bare = is_person or known[:1].isupper() or "'" in known
                self._add_value(name, known if bare else f"the {known}")

    def _add_value(self, name: str, value: str) -> None:
        ways: List[Words] = [()]
        for token in tokens_of(value):
            ways = [way + more for way in ways for more in token.ways]
        if ways and ways[0]:
            self._add(name, Filler(tuple(ways[:4]), value, (value,)))

    def _class_of(self, unit: LexicalUnit, example: Example, element: str, value: str) -> str:
        """Return the name of the class that an argument belongs to; empty for a fixed argument."""
        declared = self._frames[unit.frame_name].element(element)
        if declared is None:
            return ""
        if declared.quantity is not None and declared.quantity is not Quantity.NUMBER:
            return declared.quantity.value if declared.unit_element else f"{declared.quantity.value}_whole"
        if declared.values:
            # One word does for another where it follows the same word: "to the left", and not "to the clockwise".
            before = _word_before(example.text, value)
            verb = "verb" if before in {word for verb in unit.verbs for word in verb.split()} else before
            return f"{unit.frame_name}:{element}:{unit.path}:{unit.line}:{verb}:" if before else ""
        tokens = value.split()
        if not tokens or len(tokens) > _LONGEST_FILLER:
            return ""
        if tokens[0].lower() not in voice_words().before_things and not tokens[0][:1].isupper():
            return ""
        if any(token.lower() in voice_words().other_person for token in tokens[-1:]):
            return ""
        is_name = tokens[0].lower() not in voice_words().before_things
        likeliest = self._types.of_noun([tokens[-1].lower(), tokens[-1]], is_name=is_name).likeliest()
        if not likeliest and is_name:
            likeliest = "Human"
        return f"{unit.frame_name}:{element}:{_coarse(likeliest)}"

    def template(self, unit: LexicalUnit, example: Example) -> Optional[Template]:
        """Make a template of an example; None when it cannot be said as it is read."""
        tokens = _without_politeness(tokens_of(example.text))
        parts: List[Optional[Part]] = [None] * len(tokens)
        taken = [False] * len(tokens)
        fixed: List[Tuple[str, str]] = []
        declared = self._frames[unit.frame_name]
        units_of = {element.unit_element for element in declared.frame_elements if element.unit_element}
        for element, value in example.frame_elements.items():
            if element in units_of:
                continue
            name = self._class_of(unit, example, element, value)
            frame_element = declared.element(element)
            unit_element = frame_element.unit_element if frame_element is not None else ""
            unit_value = example.frame_elements.get(unit_element, "") if unit_element else ""
            sought = tokens_of(f"{value} {unit_value}".strip())
            at = _find(tokens, sought, taken)
            if at is None or not name:
                fixed.append((element, value))
                if unit_element and unit_value:
                    fixed.append((unit_element, unit_value))
                continue
            elements = (element, unit_element) if unit_element and unit_value else (element,)
            if unit_element and not unit_value:
                fixed.append((element, value))
                continue
            if not self._fits(name, sought, elements):
                fixed += [(element, value)] + ([(unit_element, unit_value)] if len(elements) > 1 else [])
                continue
            parts[at] = Slot(name, elements)
            for position in range(at, at + len(sought)):
                taken[position] = True
        made: List[Part] = []
        for token, part, is_taken in zip(tokens, parts, taken):
            if part is not None:
                made.append(part)
            elif not is_taken and token.text.isdigit():
                return None  # as words, it may mean something else: "pull a 180"
            elif not is_taken:
                made += token.ways[0]
        if not made:
            return None
        verbs = {verb.split()[0] for verb in unit.verbs}
        begins = isinstance(made[0], str) and made[0] in verbs
        defaults = {(element.name, element.default) for element in declared.frame_elements}
        said = tuple(pair for pair in fixed if pair not in defaults)
        return Template(unit.frame_name, tuple(made), said, begins, example.text)

    def _fits(self, name: str, sought: Sequence[Token], elements: Sequence[str]) -> bool:
        """Whether the class has fillers for these elements: "2 feet" is a length, "half a foot" is not."""
        fillers = self._fillers.get(name, {})
        if name.split("_")[0] in voice_words().measures:
            return len(sought) == 2 and sought[0].number is not None
        return bool(fillers) and all(len(filler.values) == len(elements) for filler in fillers.values())


def _word_before(text: str, value: str) -> str:
    """Return the word before an argument in lower case; empty when it is not there, or begins the text."""
    tokens, sought = tokens_of(text), tokens_of(value)
    at = _find(tokens, sought, [False] * len(tokens))
    return tokens[at - 1].text.lower() if at else ""


def _coarse(semantic_type: str) -> str:
    """Return the kind of a type, which decides what may stand in the place of what."""
    parents = with_parents(semantic_type) if semantic_type else ()
    return next((kind for kind in ("Sentient", "Location") if kind in parents), "Physical_object")


def _without_politeness(tokens: Tuple[Token, ...]) -> Tuple[Token, ...]:
    words = tuple(token.text.lower() for token in tokens)
    for phrase in sorted(voice_words().polite_before, key=len, reverse=True):
        if words[: len(phrase)] == phrase and len(words) > len(phrase):
            return _without_politeness(tokens[len(phrase) :])
    for phrase in voice_words().polite_after:
        if words[-len(phrase) :] == phrase and len(words) > len(phrase):
            return _without_politeness(tokens[: -len(phrase)])
    return tokens


def _find(tokens: Sequence[Token], sought: Sequence[Token], taken: Sequence[bool]) -> Optional[int]:
    """Return where a run of tokens begins that nothing has taken; None if it is nowhere."""

    def key(token: Token) -> str:
        return str(token.number) if token.number is not None else token.text.lower()

    wanted = [key(token) for token in sought]
    for at in range(len(tokens) - len(wanted) + 1):
        run = range(at, at + len(wanted))
        if wanted and [key(tokens[i]) for i in run] == wanted and not any(taken[i] for i in run):
            return at
    return None


def sentences(language: SpokenLanguage) -> Iterator[Tuple[Template, Tuple[Filler, ...], Words]]:
    """Yield sentences in which every template and every filler of each of its slots occurs."""
    for template in language.templates:
        slots = [language.classes[slot.filled_from] for slot in template.slots]
        ways = [[(filler, way) for filler in fillers for way in filler.ways] for fillers in slots]
        for turn in range(max([len(way) for way in ways] or [1])):
            chosen = [way[(turn + 7 * place) % len(way)] for place, way in enumerate(ways)]
            yield template, tuple(filler for filler, _ in chosen), _fill(template, [way for _, way in chosen])


def _fill(template: Template, ways: Sequence[Words]) -> Words:
    left = iter(ways)
    return tuple(word for part in template.parts for word in ((part,) if isinstance(part, str) else next(left)))
