"""View models: the values that the page shows. The browser adds nothing but layout.

Each view is frozen and can be written as JSON by `as_json`. Times are seconds; positions are metres and radians.
"""

import json
from dataclasses import dataclass
from typing import Any, Optional, Tuple

from web_console.picture import Picture


@dataclass(frozen=True)
class TraceLine:
    """What one rule did: its name, what it was about, and the effect."""

    rule: str
    about: str
    effect: str


@dataclass(frozen=True)
class StageView:
    """The latest word of a stage on a command.

    Attributes:
        name: package name of the stage
        sentence: its result, for the person
        after_s: time from the command to the event
        is_final: whether the command ended there
        trace: what each rule did
    """

    name: str
    sentence: str
    after_s: float
    is_final: bool = False
    trace: Tuple[TraceLine, ...] = ()


@dataclass(frozen=True)
class Note:
    """One attribute of an argument: what kind it is ("relation", "measure", ...), and its value in words."""

    kind: str
    text: str


@dataclass(frozen=True)
class ArgumentView:
    """The argument of a frame element, with its attributes."""

    name: str
    text: str
    notes: Tuple[Note, ...] = ()


@dataclass(frozen=True)
class ReadingView:
    """A clause as one lexical unit understands it."""

    frame: str
    verb: str
    arguments: Tuple[ArgumentView, ...]
    left_over: Tuple[str, ...]
    coverage: float
    source: str


@dataclass(frozen=True)
class ClauseView:
    """The words of a clause, and its readings, the best first."""

    words: str
    readings: Tuple[ReadingView, ...]


@dataclass(frozen=True)
class StepView:
    """One frame of a candidate, and how far it is: waiting, active, done, failed or stopped."""

    frame: str
    server: str
    arguments: Tuple[ArgumentView, ...]
    state: str = "waiting"


@dataclass(frozen=True)
class CandidateView:
    """A sequence of frames that carries a clause out."""

    steps: Tuple[StepView, ...]
    left_over: Tuple[str, ...] = ()
    state: str = "waiting"


@dataclass(frozen=True)
class PlanView:
    """A node of a plan.

    Attributes:
        kind: DO, SEQUENCE, ...
        label: the words
        notes: what else the node says: "3 times", "for 600 s"
        children: nodes below
        candidates: of a clause, in the order in which they are tried
        more: how many candidates are not shown
        state: waiting, active, done, failed or stopped
    """

    kind: str
    label: str
    notes: Tuple[str, ...] = ()
    children: Tuple["PlanView", ...] = ()
    candidates: Tuple[CandidateView, ...] = ()
    more: int = 0
    state: str = "waiting"


@dataclass(frozen=True)
class TaskView:
    """A clause of a plan in a line: its words, how far it is as in `PlanView`, and a note: "if the door is open"."""

    text: str
    state: str
    note: str = ""


@dataclass(frozen=True)
class ReplyView:
    """The reply to a command.

    Attributes:
        outcome: DONE, FAILED, REFUSED, NEEDS_INFORMATION or SUPERSEDED
        code: stable name of the reason
        sentence: for the person
        stage: where the command ended
        after_s: time from the command to the reply
        help: what would help; empty when the sentence says it
    """

    outcome: str
    code: str
    sentence: str
    stage: str
    after_s: float
    help: str = ""


@dataclass(frozen=True)
class QuestionView:
    """A question to the person, and the answers that can be given by a button."""

    sentence: str
    answers: Tuple[str, ...]


@dataclass(frozen=True)
class CommandView:
    """Everything about a command.

    Attributes:
        id: of the command
        text: the sentence
        stamp_s: when it was heard, seconds of the ROS clock
        is_cancellable: whether the page can cancel it: it came by action, and has no reply
        stages: in the order in which they reported
        parse: arcs of the dependencies
        parse_words: the same for a screen reader
        clauses: what the framer understood
        plan: what will be done, or is being done
        reply: none while the command is open
        question: what the reply asks
        tasks: the clauses of the plan in a line, for persons
        did: what the robot was doing, in its words, the newest last
        now: what happens now, for persons; empty when it has ended
    """

    id: str
    text: str
    stamp_s: float
    is_cancellable: bool = False
    stages: Tuple[StageView, ...] = ()
    parse: Optional[Picture] = None
    parse_words: str = ""
    clauses: Tuple[ClauseView, ...] = ()
    plan: Optional[PlanView] = None
    reply: Optional[ReplyView] = None
    question: Optional[QuestionView] = None
    tasks: Tuple[TaskView, ...] = ()
    did: Tuple[str, ...] = ()
    now: str = ""


@dataclass(frozen=True)
class AbilityView:
    """A frame that living servers can carry out, with sentences to say."""

    frame: str
    description: str
    domain: str
    servers: Tuple[str, ...]
    examples: Tuple[str, ...]


@dataclass(frozen=True)
class AbilitiesView:
    """What the robot can do now, and the words that it knows."""

    abilities: Tuple[AbilityView, ...] = ()
    words: Tuple[str, ...] = ()
    frames: int = 0
    units: int = 0


@dataclass(frozen=True)
class SuggestionsView:
    """Sentences that can be said here and now."""

    sentences: Tuple[str, ...] = ()


@dataclass(frozen=True)
class ProblemView:
    """A problem of a file."""

    place: str
    code: str
    found: str
    expected: str
    hint: str


@dataclass(frozen=True)
class ProblemsView:
    """All problems of files."""

    problems: Tuple[ProblemView, ...] = ()


@dataclass(frozen=True)
class NodeView:
    """A node of the graph: what it is for, and its state: "runs", "does not answer" or "is missing"."""

    name: str
    role: str
    state: str


@dataclass(frozen=True)
class HealthView:
    """The nodes, and whether the master answers."""

    nodes: Tuple[NodeView, ...] = ()
    is_master_up: bool = True


@dataclass(frozen=True)
class StatusView:
    """What the robot is doing, in a sentence."""

    sentence: str = ""
    active: Tuple[str, ...] = ()


@dataclass(frozen=True)
class EmergencyView:
    """Whether the emergency stop holds.

    Attributes:
        is_engaged: whether it does
        sentence: since when, why, and how to release it; empty when it does not
    """

    is_engaged: bool = False
    sentence: str = ""


@dataclass(frozen=True)
class VoiceView:
    """What the voice hears.

    Attributes:
        state: waiting, listening, thinking, confirming, replying or deaf; empty without a voice
        heard: what was heard last
        question: what the robot asks before it does that; empty for nothing
        takes_sound: whether it hears the microphone of the page
    """

    state: str = ""
    heard: str = ""
    question: str = ""
    takes_sound: bool = False


@dataclass(frozen=True)
class StopView:
    """The last stop that was asked for by a page.

    Attributes:
        number: counts them, from 1; 0 before the first
        state: sent, stopped, not_stopped or unknown
        sentence: who stopped the robot, or why it may still move
    """

    number: int = 0
    state: str = ""
    sentence: str = ""


@dataclass(frozen=True)
class Point:
    """A position on the ground."""

    x_m: float
    y_m: float


@dataclass(frozen=True)
class PoseView:
    """Where the robot is; `frame` is that of the numbers."""

    x_m: float
    y_m: float
    heading_rad: float
    frame: str


@dataclass(frozen=True)
class MapView:
    """A map: the address of its picture, whose first pixel is the corner with the largest y, and its place."""

    address: str
    width_m: float
    height_m: float
    x_m: float
    y_m: float
    heading_rad: float


@dataclass(frozen=True)
class LandmarkView:
    """Something that is drawn beside the robot.

    Attributes:
        name: for persons
        kind: room, furniture, door, place, person, thing, device or goal
        x_m: of its middle
        y_m: of its middle
        width_m: along its x axis; 0 when unknown
        depth_m: along its y axis; 0 when unknown
        heading_rad: of its x axis
        states: what is known of it: open, on, dirty
        is_held: whether the robot holds it
    """

    name: str
    kind: str
    x_m: float
    y_m: float
    width_m: float = 0.0
    depth_m: float = 0.0
    heading_rad: float = 0.0
    states: Tuple[str, ...] = ()
    is_held: bool = False


@dataclass(frozen=True)
class GroundView:
    """The surroundings of the robot; a part is there when its topic is there."""

    map: Optional[MapView] = None
    path: Tuple[Point, ...] = ()
    landmarks: Tuple[LandmarkView, ...] = ()


@dataclass(frozen=True)
class KnownView:
    """An object of the world: what it is called, what it is, where it is in words, and what is known of it."""

    name: str
    sort: str
    where: str
    attributes: Tuple[str, ...] = ()


@dataclass(frozen=True)
class WorldView:
    """What the robot knows; `more` objects are not shown."""

    objects: Tuple[KnownView, ...] = ()
    more: int = 0


@dataclass(frozen=True)
class OrderView:
    """A standing order.

    Attributes:
        sentence: what the robot will do
        state: waits, due, runs, suspended or blind
        reason: of the state; empty for none
        next_s: when it is due next, seconds since 1970; 0 when it waits for a condition
        count: how often it was carried out, or tried
    """

    sentence: str
    state: str
    reason: str = ""
    next_s: float = 0.0
    count: int = 0


@dataclass(frozen=True)
class OrdersView:
    """What the robot will do later, or whenever something happens; the oldest order first."""

    orders: Tuple[OrderView, ...] = ()


@dataclass(frozen=True)
class LearnedItemView:
    """Something that was taught.

    Attributes:
        said: the words
        meaning: what they mean, as a sentence
        who: taught it; empty when nobody was known
        when_s: when, seconds since 1970
        sentence: in which the words were said
        forgets: the sentence by which it is forgotten
    """

    said: str
    meaning: str
    who: str
    when_s: float
    sentence: str
    forgets: str


@dataclass(frozen=True)
class LearnedView:
    """What was taught, the last first, and how many more there are."""

    items: Tuple[LearnedItemView, ...] = ()
    more: int = 0


@dataclass(frozen=True)
class PastView:
    """How often the past conversations have changed, so that a page knows when to look again."""

    changes: int = 0


def as_json(kind: str, view: Any) -> str:
    """Write a message for the page: the name of the view, and the view."""
    return json.dumps({"view": kind, "value": view}, default=vars, separators=(",", ":"), allow_nan=False)
