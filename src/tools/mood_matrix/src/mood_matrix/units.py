"""The verb units that a shipped server carries out, from the YAML files: verb, frame, and one example in pieces.

It reads the files itself, so that a mistake of the framer is not a mistake of the right answers.
"""

import re
import zlib
from dataclasses import dataclass
from pathlib import Path
from typing import AbstractSet, Any, Dict, FrozenSet, Iterator, List, Mapping, Optional, Sequence, Tuple

import yaml

from mood_matrix.english import NounPhrase, Predicate, words

#: The parser of libyaml, if there is one, is many times faster.
_LOADER = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
#: What a frame file calls whoever carries the frame out.
AGENT = "agent"
_POLITE = re.compile(r"^(?:please )?(?P<text>.*?)(?:,? please)?\.?$", re.IGNORECASE)


@dataclass(frozen=True)
class Unit:
    """A lexical unit of a verb, with an example taken to pieces.

    Attributes:
        domain: name of its domain
        frame: name of its frame
        predicate: the verb of the example with what belongs to it
        elements: texts of the elements that the example says, by name
        defaults: texts of the elements that it does not say
        object_element: name of the element that the direct object fills; empty for none
        embeds: whether the example has a clause inside: "ask Alice to wait"
        result: texts of what the deed results in, by element of the frame that says so; :data:`AGENT` stands for
            whoever does it; empty if the frame file names no result, or the example does not say all of it
    """

    domain: str
    frame: str
    predicate: Predicate
    elements: Mapping[str, str]
    defaults: Mapping[str, str]
    object_element: str
    embeds: bool
    result: Mapping[str, str]

    @property
    def is_odd(self) -> bool:
        """Which of two wordings it has; it does not depend on other units."""
        return zlib.crc32(self.predicate.base().encode()) % 2 == 1

    @property
    def object(self) -> NounPhrase:
        """The direct object; the unit has one."""
        return NounPhrase(self.predicate.object)


@dataclass(frozen=True)
class Served:
    """What shipped servers do and watch.

    Attributes:
        frames: they carry these out
        states: words for states of things that they see, each with the name of the state
        events: frames of deeds of persons that they notice, each with the frames of the conditions that they watch
        perceivers: words for those of whom they can tell what they see
    """

    frames: FrozenSet[str]
    states: Mapping[str, str]
    events: Mapping[str, Sequence[str]]
    perceivers: Sequence[str]


def load_served(frames: Mapping[str, Mapping[str, Any]]) -> Served:
    """Read ``served.yaml``; a frame is also served when all frames of one of its sequences are.

    Args:
        frames: what the frame files say, by name
    """
    text = Path(__file__).resolve().with_name("served.yaml").read_text(encoding="utf-8")
    data = yaml.safe_load(text)
    found = {name for names in data["acts"].values() for name in names}
    while True:
        more = {
            name
            for name, frame in frames.items()
            if name not in found and any(found.issuperset(sequence) for sequence in _sequences(frame))
        }
        if not more:
            return Served(frozenset(found), data["states"], data["events"], data["perceivers"])
        found |= more


def _sequences(frame: Mapping[str, Any]) -> Iterator[List[str]]:
    """Yield the names of the frames of each sequence that carries out a frame."""
    for child in frame.get("children") or ():
        yield [step["name"] for step in (child if isinstance(child, list) else [child])]


def load_frames(folder: Path) -> Mapping[str, Mapping[str, Any]]:
    """Read the frame files of all domains of a folder, by the names of the frames."""
    return {
        frame["name"]: frame
        for path in sorted(folder.glob("*/frames/*.yaml"))
        for frame in _entries(path)
        if "name" in frame
    }


def load_units(folder: Path) -> Tuple[Unit, ...]:
    """Return the units of the domains in a folder that have a verb, whose frame a shipped server carries out, and that
    have an example in the imperative."""
    frames = load_frames(folder)
    served = load_served(frames).frames
    found: List[Unit] = []
    for path in sorted(folder.glob("*/lexical_units/*.yaml")):
        for entry in _entries(path):
            if not entry.get("verb") or entry["frame_name"] not in served:
                continue
            unit = _unit(path.parts[-3], entry, frames[entry["frame_name"]])
            if unit is not None:
                found.append(unit)
    return tuple(found)


def _entries(path: Path) -> List[Mapping[str, Any]]:
    loaded = yaml.load(path.read_text(encoding="utf-8"), Loader=_LOADER)  # noqa: S506 (both are safe loaders)
    return loaded if isinstance(loaded, list) else [loaded]


def _unit(domain: str, entry: Mapping[str, Any], frame: Mapping[str, Any]) -> Optional[Unit]:
    """Return a unit with its first example in the imperative that needs no sentence before it; None without one."""
    verbs = [entry["verb"]] if isinstance(entry["verb"], str) else entry["verb"]
    for text, filled in _examples(entry):
        verb = _verb_of(text, verbs)
        if not verb or text.endswith("!") or verb.split()[0] in words()["no_verbs"] or _points_back(text, filled):
            continue
        match = _POLITE.match(text)
        said = match["text"] if match else text
        elements = {name: str(value) for name, value in filled.items() if _is_in(str(value), said)}
        predicate, object_element = _predicate(said, verb, elements)
        return Unit(
            domain=domain,
            frame=entry["frame_name"],
            predicate=predicate,
            elements=elements,
            defaults={name: str(value) for name, value in filled.items() if name not in elements},
            object_element=object_element,
            embeds=_embeds(predicate, elements),
            result=_result(frame, {name: str(value) for name, value in filled.items()}),
        )
    return None


def _result(frame: Mapping[str, Any], elements: Mapping[str, str]) -> Mapping[str, str]:
    """Fill what a frame results in with the elements of an example, which may be the verb's own ("refrigerate").

    Returns:
        the text of each element; nothing if the example does not say one of them, or says more than the result
    """
    own = {element["name"] for element in frame.get("frame_elements") or ()} - {AGENT}
    named = {name: str(value) for name, value in (frame.get("results_in") or {}).items() if name != "frame"}
    if any(value in own and value not in elements for value in named.values()):
        return {}
    if not set(elements) <= {AGENT, *named.values()}:
        return {}
    return {name: elements[value] if value in own else value for name, value in named.items()}


def _examples(entry: Mapping[str, Any]) -> Iterator[Tuple[str, Mapping[str, Any]]]:
    examples = entry.get("examples") or {}
    for text, filled in examples.items() if isinstance(examples, dict) else ((text, {}) for text in examples):
        yield str(text), filled or {}


def _points_back(text: str, filled: Mapping[str, Any]) -> bool:
    """Whether an example needs a sentence before it: "take it", "bring that to me"."""
    alone = set(words()["pointing_alone"])
    return bool(words_of(text) & set(words()["pointing"])) or any(
        str(value).lower() in alone for value in filled.values()
    )


def words_of(text: str) -> FrozenSet[str]:
    """Return the words of a text in lower case."""
    return frozenset(re.findall(r"[\w'-]+", text.lower()))


def _is_in(value: str, text: str) -> bool:
    return re.search(rf"(?<!\w){re.escape(value.lower())}(?!\w)", text.lower()) is not None


def _verb_of(text: str, verbs: Sequence[str]) -> str:
    """Return the words of an example that are its verb; empty if it does not begin with it."""
    match = _POLITE.match(text)
    said = (match["text"] if match else text).lower().split()
    whole = [verb for verb in verbs if said[: len(verb.split())] == verb.split()]
    if whole:
        return max(whole, key=len)
    # "Take two steps": the noun of the verb "take steps" stands later.
    return next((said[0] for verb in verbs if said[:1] == verb.split()[:1]), "")


def _predicate(text: str, verb: str, elements: Mapping[str, str]) -> Tuple[Predicate, str]:
    """Take an example to pieces; return them, and the element that the direct object fills."""
    base, *particles = verb.split()
    behind = text.split()[1 + len(particles) :]
    found: List[Tuple[str, str]] = []
    while len(found) < 2:
        phrase = _phrase_at_front(behind, elements, {name for name, _ in found})
        if phrase is None:
            break
        found.append(phrase)
        behind = behind[len(phrase[1].split()) :]
    rest = " ".join(behind)
    particle = " ".join(particles)
    if not found:
        return Predicate(base, particle, rest=rest), ""
    if len(found) == 2:
        return Predicate(base, particle, found[0][1], found[1][1], rest), found[1][0]
    (name, phrase_text) = found[0]
    # "Take me": a pronoun before a noun that fills no element receives something ("give me a hug").
    is_more = behind and (behind[0].lower() in words()["determiners"] or behind[0].isdigit())
    if NounPhrase(phrase_text).is_pronoun and is_more:
        return Predicate(base, particle, phrase_text, rest=rest), ""
    return Predicate(base, particle, object=phrase_text, rest=rest), name


def _phrase_at_front(
    behind: Sequence[str], elements: Mapping[str, str], used: AbstractSet[str]
) -> Optional[Tuple[str, str]]:
    """Return the element, and its words, of the noun phrase with which a text begins; None if there is none."""
    text = " ".join(behind)
    fitting: Dict[str, str] = {}
    for name, value in elements.items():
        if name not in used and re.match(rf"{re.escape(value)}(?!\w)", text, re.IGNORECASE):
            fitting[name] = text[: len(value)]
    if not fitting:
        return None
    name = max(fitting, key=lambda one: len(fitting[one]))
    return (name, fitting[name]) if _is_noun_phrase(fitting[name]) else None


def _is_noun_phrase(text: str) -> bool:
    """Whether a text, which fills an element, is a noun phrase, and no measure, adverb or clause."""
    first, last = text.split()[0], text.split()[-1]
    if last in words()["units_of_measure"] or first.lower() in words()["clause_words"]:
        return first.lower() in words()["determiners"] and last not in words()["units_of_measure"]
    phrase = NounPhrase(text)
    is_marked = bool(phrase.determiner) or phrase.is_pronoun or first[:1].isupper()
    is_bare_plural = phrase.is_plural and last not in words()["not_plural"]
    return (is_marked or is_bare_plural) and phrase.text.lower() not in ("here", "there")


def _embeds(predicate: Predicate, elements: Mapping[str, str]) -> bool:
    """Whether a predicate has a clause inside it: "find out where Bob is", "ask Alice to wait"."""
    behind = predicate.rest.split()
    if behind and behind[0] in words()["clause_words"]:
        return True
    infinitive = re.match(r"to (?P<said>[a-z].*)", predicate.rest)
    said = [NounPhrase(value) for value in elements.values() if infinitive and infinitive["said"].startswith(value)]
    return any(not (phrase.determiner or phrase.is_pronoun) for phrase in said)
