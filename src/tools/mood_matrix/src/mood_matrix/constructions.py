"""The 24 rows of the mood matrix: how each construction is said, and what is right.

Rows 4, 9, 11, 13, 16, 19, 21 and 24 are for scoring, and frozen: whoever writes rules of understanding does not look at
their sentences. To check that their English is right is allowed.
"""

from dataclasses import dataclass, replace
from enum import Enum
from typing import Callable, Dict, FrozenSet, Iterable, Iterator, List, Mapping, Optional, Tuple

from mood_matrix.english import NounPhrase, gerund_of, participle_of, sentence, words
from mood_matrix.units import AGENT, Served, Unit, words_of

#: Rows for scoring only.
FROZEN = frozenset([4, 9, 11, 13, 16, 19, 21, 24])
ROBOT, NOBODY = "robot", "nobody"


class Outcome(Enum):
    """What is right.

    Attributes:
        ACT: the deed is done
        ACT_OR_ASK: the deed is done, or the robot asks whether it should
        STOP: the robot stops
        RULE: the prohibition is noted or kept, and nothing is done
        ANSWER: the question is answered
        TELL: the answer is told
        WAIT: the robot waits for what is embedded; then it does what was said for then
        CANNOT_NOTICE: refused; the reply says what the robot cannot notice
        BOTH: the deed and then the other deed
        DECIDE: the other deed, if the log says so
        ORDER: nothing now; the other deed only after the deed
        VISIT: the robot goes to the thing that the log knows
        NOTE: the world learns the result
        NOTHING_TO_NOTE: nothing; the report is told from a command
    """

    ACT = "act"
    ACT_OR_ASK = "act or ask"
    STOP = "stop"
    RULE = "keep a rule"
    ANSWER = "answer"
    TELL = "answer, told"
    WAIT = "wait"
    CANNOT_NOTICE = "cannot notice"
    BOTH = "plan of two"
    DECIDE = "decide by the log"
    ORDER = "order of two, nothing now"
    VISIT = "act on what the log knows"
    NOTE = "note"
    NOTHING_TO_NOTE = "nothing to note"


@dataclass(frozen=True)
class Deed:
    """A filled frame.

    Attributes:
        frame: its name
        elements: texts that must fill its elements, by name
        optional: texts that may fill others
        loose: words of the example that no element of it has; another element may have them ("give me *a hug*")
        asked: name of the element that may have any text, because it is asked for or described; empty for none
    """

    frame: str
    elements: Mapping[str, str]
    optional: Mapping[str, str]
    loose: FrozenSet[str] = frozenset()
    asked: str = ""


@dataclass(frozen=True)
class Expected:
    """The right answer.

    Attributes:
        deed: the frame of the verb, with its elements
        outcome: what is right
        agent: "robot", "nobody" for the passive, "who", or the name of a person
        form: the form of the clause of the deed
        polarity: "positive" or "negative"
        modality: "can", "should", "want" or nothing
        aspect: "done", "ever_done", "running", "able" or nothing
        asks: what is asked: "whether", "when", "why", "how_often", "who", or the name of an element
        embedded_in: what the clause stands under: "assurance", "when", "telling" ...
        then: what else is to be done
        theme: noun of the thing that is described
        things: what stands in a relation, or is in a state, after the deed
        states: words, any of which says the state; none for a relation
        said: the predicate as it stands after "why did you not": "close the door"
        watched_as: frames of the conditions that a shipped server watches for the deed of a person
    """

    deed: Deed
    outcome: Outcome
    agent: str = ROBOT
    form: str = "imperative"
    polarity: str = "positive"
    modality: str = ""
    aspect: str = ""
    asks: str = ""
    embedded_in: str = ""
    then: Optional[Deed] = None
    theme: str = ""
    things: Tuple[str, ...] = ()
    states: Tuple[str, ...] = ()
    said: str = ""
    watched_as: Tuple[str, ...] = ()


@dataclass(frozen=True)
class Sentence:
    """A sentence of the matrix.

    Attributes:
        row: number of its row
        domain: domain of its unit
        text: as it is said
        expected: the right answer
    """

    row: int
    domain: str
    text: str
    expected: Expected

    @property
    def is_frozen(self) -> bool:
        """Whether it is for scoring only."""
        return self.row in FROZEN


class _Case:
    """A unit, and what its constructions are made of."""

    def __init__(self, unit: Unit, served: Served) -> None:
        self.unit = unit
        self.served = served
        self.predicate = unit.predicate
        said = words_of(f"{unit.predicate.base()} {unit.predicate.said_of('of_her').base()}")
        loose = said - words_of(" ".join(unit.elements.values()))
        self.deed = Deed(unit.frame, unit.elements, unit.defaults, loose)
        self.person = "Anna" if "Anna" not in " ".join(unit.elements.values()) else "Clara"
        self.hello, self.then = _consequence(unit)

    @property
    def is_motion_alone(self) -> bool:
        """Whether it is a motion that says neither where nor how far: "don't move" stops it."""
        return self.unit.domain in ("moving", "navigation") and self.predicate.base() == self.predicate.verb

    @property
    def by_person(self) -> Deed:
        """The deed of a person: "introduces herself"."""
        return self._of("of_her")

    @property
    def by_somebody(self) -> Deed:
        """The deed of whom it may be: "introduced themselves"."""
        return self._of("of_somebody")

    def _of(self, others: str) -> Deed:
        return replace(
            self.deed,
            elements={name: _changed(text, others) for name, text in self.deed.elements.items()},
        )

    @property
    def without_object(self) -> Deed:
        """The deed without the object, which is asked or described."""
        name = self.unit.object_element
        others = {key: text for key, text in self.deed.elements.items() if key != name}
        return replace(self.deed, elements=others, asked=name)

    @property
    def states(self) -> Tuple[str, ...]:
        """Words for the state of the object after the deed; none where it is in a relation to something."""
        if self.unit.result and "state" not in self.unit.result:
            return ()
        found = [self.unit.result.get("state", ""), participle_of(self.predicate.verb)]
        found += [*self.predicate.particle.split(), *self.predicate.rest.split()[-1:]]
        found += [self.served.states.get(word, "") for word in found]
        return tuple(dict.fromkeys(word for word in found if word))

    def things(self, agent: str) -> Tuple[str, ...]:
        """Return what stands in a relation, or is in a state, after the deed of somebody."""
        named = tuple(agent if text == AGENT else text for name, text in self.unit.result.items() if name != "state")
        return named or (self.predicate.object,)

    @property
    def result_is_seen(self) -> bool:
        """Whether a shipped server sees what the deed results in."""
        result = self.unit.result
        return bool(result) and ("state" not in result or result["state"] in self.served.states)

    @property
    def passive_is_seen(self) -> bool:
        """Whether a shipped server sees the state that is said in the passive: "closed", "switched on"."""
        said = self.predicate.passive(participle_of(self.predicate.verb)).split()
        # "Closed", "switched on": one word, or the last of two.
        last = set(said[-1:] if len(said) < 3 else ())
        is_of_nobody = AGENT not in self.unit.result.values()
        return (self.result_is_seen and is_of_nobody) or bool(last & set(self.served.states))


def _consequence(unit: Unit) -> Tuple[str, Deed]:
    if unit.frame == "saying":
        return "nod", Deed("nodding", {}, {})
    return "say hello", Deed("saying", {"message": "hello"}, {})


def _changed(text: str, others: str) -> str:
    return " ".join(words()[others].get(word, word) for word in text.split())


_Made = Optional[Tuple[str, Expected]]


def _imperative(case: _Case) -> _Made:
    return sentence(case.predicate.base()), Expected(case.deed, Outcome.ACT)


def _request(case: _Case) -> _Made:
    text = sentence(f"could you {case.predicate.base()}, please", "?")
    return text, Expected(case.deed, Outcome.ACT, form="polar question", modality="can")


def _wish(case: _Case) -> _Made:
    text = sentence(f"I want you to {case.predicate.base()}")
    return text, Expected(case.deed, Outcome.ACT, form="infinitive", modality="want", embedded_in="wanting")


def _need(case: _Case) -> _Made:
    subject = case.predicate.passive_subject
    if not subject:
        return None
    verb = case.predicate.verb
    if case.unit.is_odd:
        needs = "need" if NounPhrase(subject).is_plural else "needs"
        text = f"{subject} {needs} {case.predicate.passive(gerund_of(verb))}"
        form = "gerund"
    else:
        text = f"{subject} should be {case.predicate.passive(participle_of(verb))}"
        form = "passive"
    return sentence(text), Expected(case.deed, Outcome.ACT_OR_ASK, agent=NOBODY, form=form, modality="should")


def _assurance(case: _Case) -> _Made:
    if case.unit.frame == "verifying":
        return None
    text = sentence(f"make sure that you {case.predicate.base()}")
    return text, Expected(case.deed, Outcome.ACT, form="declarative", embedded_in="assurance")


def _prohibition(case: _Case) -> _Made:
    outcome = Outcome.STOP if case.is_motion_alone else Outcome.RULE
    return sentence(f"don't {case.predicate.base()}"), Expected(case.deed, outcome, polarity="negative")


def _rule(case: _Case) -> _Made:
    if case.unit.embeds:
        return None
    return sentence(f"never {case.predicate.base()} at night"), Expected(case.deed, Outcome.RULE, polarity="negative")


def _asked(case: _Case, text: str, asks: str, aspect: str = "done", **features: str) -> _Made:
    form = "polar question" if asks == "whether" else "open question"
    expected = Expected(case.deed, Outcome.ANSWER, form=form, asks=asks, aspect=aspect, **features)  # type: ignore[arg-type]
    return sentence(text, "?"), expected


def _with_loose(made: _Made, word: str) -> _Made:
    """Let an element of the deed have a word of the construction: "today"."""
    if made is None:
        return None
    text, expected = made
    return text, replace(expected, deed=replace(expected.deed, loose=expected.deed.loose | {word}))


def _whether_done(case: _Case) -> _Made:
    return _asked(case, f"did you {case.predicate.base()}", "whether")


def _which(case: _Case) -> _Made:
    name = case.unit.object_element
    # "Whom did you introduce?" does not ask for "yourself".
    if not name or (case.unit.object.is_pronoun and not case.unit.object.is_person):
        return None
    thing = case.unit.object
    asked = "who" if thing.is_person else "what"
    if asked == "what" and case.unit.is_odd and thing.determiner and thing.is_place and not thing.is_mass:
        asked = f"which {thing.without_determiner}"
    made = _asked(case, f"{asked} did you {case.predicate.base(gap='object')}", name)
    return made and (made[0], replace(made[1], deed=case.without_object))


def _when_done(case: _Case) -> _Made:
    return _asked(case, f"when did you {case.predicate.base()}", "when")


def _why_not(case: _Case) -> _Made:
    said = case.predicate.base()
    return _asked(case, f"why did you not {said}", "why", polarity="negative", said=said)


def _ever_done(case: _Case) -> _Made:
    made = _asked(case, f"have you ever {case.predicate.participle()}", "whether", "ever_done")
    return _with_loose(made, "ever")


def _how_often(case: _Case) -> _Made:
    if case.unit.embeds:
        return None
    made = _asked(case, f"how often have you {case.predicate.participle()} today", "how_often")
    return _with_loose(made, "today")


def _running(case: _Case) -> _Made:
    return _asked(case, f"are you {case.predicate.gerund()}", "whether", "running")


def _able(case: _Case) -> _Made:
    """ "Can you close doors?"; "Are you able to ..." where "Can you ..." would be a request."""
    name, thing = case.unit.object_element, case.predicate.object
    said_to_speaker = {"me", "us"} & set(case.predicate.base().split())
    if not name or said_to_speaker or NounPhrase(thing).is_pronoun or case.predicate.receiver:
        return _asked(case, f"are you able to {case.predicate.base()}", "whether", "able", modality="can")
    phrase = NounPhrase(thing)
    if phrase.is_mass or not phrase.is_whole or not (phrase.is_place or phrase.is_name):
        return _asked(case, f"are you able to {case.predicate.base()}", "whether", "able", modality="can")
    generic = replace(case.predicate, object=phrase.kind)
    deed = replace(case.deed, elements={**case.deed.elements, name: phrase.kind})
    made = _asked(case, f"can you {generic.base()}", "whether", "able", modality="can")
    return made and (made[0], replace(made[1], deed=deed))


def _who(case: _Case) -> _Made:
    text = f"who {case.predicate.said_of('of_somebody').past()}"
    made = _asked(case, text, "who", agent="who")
    return made and (made[0], replace(made[1], deed=case.by_somebody))


def _when_somebody(case: _Case) -> _Made:
    is_noticed = case.unit.frame in case.served.events or case.result_is_seen
    text = f"when {case.person} {case.predicate.said_of('of_her').third()}, {case.hello}"
    return sentence(text), Expected(
        case.by_person,
        Outcome.WAIT if is_noticed else Outcome.CANNOT_NOTICE,
        agent=case.person,
        form="subordinate",
        embedded_in="when",
        then=case.then,
        things=case.things(case.person),
        states=case.states,
        watched_as=tuple(case.served.events.get(case.unit.frame, ())),
    )


def _after(case: _Case) -> _Made:
    text = f"after {case.predicate.gerund()}, {case.hello}"
    return sentence(text), Expected(case.deed, Outcome.BOTH, form="gerund", embedded_in="after", then=case.then)


def _if_not(case: _Case) -> _Made:
    text = f"if you have not {case.predicate.participle()}, {case.hello}"
    return sentence(text), Expected(
        case.deed,
        Outcome.DECIDE,
        form="subordinate",
        polarity="negative",
        aspect="done",
        embedded_in="if",
        then=case.then,
    )


def _until_in_state(case: _Case) -> _Made:
    subject = case.predicate.passive_subject
    if not subject or subject != case.predicate.object:
        return None
    be = "are" if NounPhrase(subject).is_plural else "is"
    text = f"wait until {subject} {be} {case.predicate.passive(participle_of(case.predicate.verb))}"
    return sentence(text), Expected(
        case.deed,
        Outcome.WAIT if case.passive_is_seen else Outcome.CANNOT_NOTICE,
        agent=NOBODY,
        form="subordinate",
        embedded_in="until",
        things=case.things(NOBODY),
        states=case.states,
    )


def _not_until(case: _Case) -> _Made:
    text = f"do not {case.hello} until you have {case.predicate.participle()}"
    return sentence(text), Expected(
        case.deed, Outcome.ORDER, form="subordinate", aspect="done", embedded_in="until", then=case.then
    )


def _told_whether(case: _Case) -> _Made:
    text = f"tell me whether you {case.predicate.past()}"
    return sentence(text), Expected(
        case.deed, Outcome.TELL, form="embedded question", aspect="done", asks="whether", embedded_in="telling"
    )


def _report(case: _Case) -> _Made:
    text = f"{case.person} has {case.predicate.said_of('of_her').participle()}"
    return sentence(text), Expected(
        case.by_person,
        Outcome.NOTE if case.unit.result else Outcome.NOTHING_TO_NOTE,
        agent=case.person,
        form="declarative",
        aspect="done",
        things=case.things(case.person),
        states=case.states,
    )


def _relative(case: _Case) -> _Made:
    if not case.unit.object_element or not case.unit.object.is_place:
        return None
    thing = case.unit.object
    text = f"go to {thing.definite} that you {case.predicate.past(gap='object')}"
    return sentence(text), Expected(
        case.without_object, Outcome.VISIT, form="relative", aspect="done", theme=NounPhrase(thing.definite).head
    )


@dataclass(frozen=True)
class Row:
    """A construction: its number, what it is, and what makes it of a unit; that is None where it is no good English."""

    number: int
    title: str
    make: Callable[[_Case], _Made]


ROWS: Tuple[Row, ...] = (
    Row(1, "Close the door.", _imperative),
    Row(2, "Could you close the door, please?", _request),
    Row(3, "I want you to close the door.", _wish),
    Row(4, "The door should be closed. / needs closing.", _need),
    Row(5, "Make sure that you close the door.", _assurance),
    Row(6, "Don't close the door.", _prohibition),
    Row(7, "Never close the door at night.", _rule),
    Row(8, "Did you close the door?", _whether_done),
    Row(9, "Which door did you close?", _which),
    Row(10, "When did you close the door?", _when_done),
    Row(11, "Why did you not close the door?", _why_not),
    Row(12, "Have you ever closed the door?", _ever_done),
    Row(13, "How often have you closed the door today?", _how_often),
    Row(14, "Are you closing the door?", _running),
    Row(15, "Can you close doors?", _able),
    Row(16, "Who closed the door?", _who),
    Row(17, "When Anna closes the door, say hello.", _when_somebody),
    Row(18, "After closing the door, say hello.", _after),
    Row(19, "If you have not closed the door, say hello.", _if_not),
    Row(20, "Wait until the door is closed.", _until_in_state),
    Row(21, "Do not say hello until you have closed the door.", _not_until),
    Row(22, "Tell me whether you closed the door.", _told_whether),
    Row(23, "Anna has closed the door.", _report),
    Row(24, "Go to the door that you closed.", _relative),
)


def sentences_of(units: Iterable[Unit], served: Served, rows: Iterable[int] = ()) -> Iterator[Sentence]:
    """Yield the sentences of the matrix, unit by unit; each text once.

    Args:
        units: the units
        served: what shipped servers do and watch
        rows: numbers of the rows; none for all
    """
    wanted = frozenset(rows) or frozenset(row.number for row in ROWS)
    seen: Dict[str, None] = {}
    for unit in units:
        case = _Case(unit, served)
        for row in ROWS:
            made = row.make(case) if row.number in wanted else None
            if made is not None and made[0] not in seen:
                seen[made[0]] = None
                yield Sentence(row.number, unit.domain, *made)


def counts_of(sentences: Iterable[Sentence]) -> List[Tuple[Row, int]]:
    """Return how many sentences each row has."""
    numbers = [one.row for one in sentences]
    return [(row, numbers.count(row.number)) for row in ROWS]
