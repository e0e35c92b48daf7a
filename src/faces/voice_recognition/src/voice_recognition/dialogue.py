"""The dialogue about one spoken command, as values: each state has an expiry, each event makes the next state."""

import enum
from dataclasses import dataclass, field, replace
from types import MappingProxyType
from typing import FrozenSet, Mapping, Tuple, Union

from command_server.answers import YES_NO
from voice_recognition.agreement import Heard, Verdict
from voice_recognition.offers import Offer
from voice_recognition.voice_words import voice_words

#: An expiry that never comes.
NEVER_S = float("inf")


class Confirm(enum.Enum):
    """When the robot asks before it does what it heard."""

    ALWAYS = "always"
    MOTION = "motion"  # only frames that may move it
    NEVER = "never"


@dataclass(frozen=True)
class DialogueSettings:
    """How the robot talks about what it heard.

    Attributes:
        confirm: when it asks; what the two searches did not agree on is always asked
        confirm_frames: the same for single frames
        frames_without_motion: frames that move nothing
        always_listening: whether it listens without push to talk, to who calls it by a name
        listen_s: seconds that it listens after a push
        think_s: seconds for understanding what was heard
        answer_s: seconds that it waits for an answer
        deaf_s: seconds after which it hears again, even if nobody says that the robot is silent
        most_repeats: how often it asks again
    """

    confirm: Confirm = Confirm.MOTION
    confirm_frames: Mapping[str, Confirm] = field(default_factory=lambda: MappingProxyType({}))
    frames_without_motion: FrozenSet[str] = field(default_factory=lambda: voice_words().frames_without_motion)
    always_listening: bool = False
    listen_s: float = 8.0
    think_s: float = 5.0
    answer_s: float = 10.0
    deaf_s: float = 30.0
    most_repeats: int = 2

    def asks(self, offer: Offer, verdict: Verdict) -> bool:
        """Whether a command has to be confirmed."""
        if verdict is not Verdict.SURE:
            return True
        confirm = self.confirm_frames.get(offer.frame, self.confirm)
        if confirm is Confirm.MOTION:
            return not offer.is_question and offer.frame not in self.frames_without_motion
        return confirm is Confirm.ALWAYS


# --- states


@dataclass(frozen=True)
class Waiting:
    """Hears only words that stop the robot, until somebody pushes to talk."""

    until: float = NEVER_S


@dataclass(frozen=True)
class Listening:
    """Hears one command; ``repeats`` counts how often it asked for it again."""

    until: float
    repeats: int = 0


@dataclass(frozen=True)
class Thinking:
    """Has heard the end of an utterance, and waits for what the searches make of it; then comes ``behind``."""

    until: float
    behind: Union[Listening, "Confirming", "Replying"]


@dataclass(frozen=True)
class Confirming:
    """Has offered one command, or two, and hears the answer."""

    until: float
    offers: Tuple[Offer, ...]
    repeats: int = 0


@dataclass(frozen=True)
class Replying:
    """The pipeline has asked a question that some answers fit: hears one of them, or another command."""

    until: float
    repeats: int = 0


@dataclass(frozen=True)
class Deaf:
    """The robot itself speaks: hears only words that stop it; then comes ``behind``."""

    until: float
    behind: "Awake"


Awake = Union[Waiting, Listening, Thinking, Confirming, Replying]
State = Union[Awake, Deaf]

# --- events


@dataclass(frozen=True)
class Pushed:
    """Somebody pushes to talk."""


@dataclass(frozen=True)
class SpeechEnded:
    """An utterance has ended, and the searches begin."""


@dataclass(frozen=True)
class Understood:
    """The searches have ended.

    Attributes:
        heard: what they heard
        is_called: whether it begins with a name of the robot
        is_call_only: whether it is nothing else
    """

    heard: Heard
    is_called: bool = False
    is_call_only: bool = False


@dataclass(frozen=True)
class Answered:
    """An answer by another way than the voice: a page, or text.

    Attributes:
        name: as in ``voice.yaml``, or what the pipeline gets
    """

    name: str


@dataclass(frozen=True)
class Asked:
    """The pipeline asks the person a question; ``has_answers`` when it can be answered by one of some phrases."""

    has_answers: bool


@dataclass(frozen=True)
class Settled:
    """The pipeline has replied to a command without a question: the last one was answered."""


@dataclass(frozen=True)
class OtherCommand:
    """Somebody gave a command by another way: an open question is about nothing."""


@dataclass(frozen=True)
class Stopped:
    """Words that stop the robot were heard: `is_emergency` when they engage the emergency stop."""

    is_emergency: bool = False


@dataclass(frozen=True)
class RobotSpeaks:
    """The robot begins or ends to speak."""

    is_speaking: bool


@dataclass(frozen=True)
class Tick:
    """Time has passed."""


Event = Union[Pushed, SpeechEnded, Understood, Answered, Asked, Settled, OtherCommand, Stopped, RobotSpeaks, Tick]

# --- actions


@dataclass(frozen=True)
class Say:
    """The robot says a sentence; ``is_question`` when it expects an answer."""

    sentence: str
    is_question: bool = False


@dataclass(frozen=True)
class Command:
    """A command goes to the pipeline."""

    text: str
    frame: str
    is_confirmed: bool


@dataclass(frozen=True)
class Stop:
    """The robot stops, at once and without a question; for `is_emergency`, until a person releases it."""

    is_emergency: bool = False


Action = Union[Say, Command, Stop]
Step = Tuple[State, Tuple[Action, ...]]

#: When somebody calls the robot, and says nothing else.
CALLED = "Yes?"
AGAIN = "Please say that again."
YES_OR_NO = "Please say yes or no."
ALL_RIGHT = "All right, I will not do it."
NOT_ANSWERED = "I heard no answer, so I do nothing."


def begin(settings: DialogueSettings) -> Union[Waiting, Listening]:
    """Return the first state, which is also the one between commands."""
    return Listening(NEVER_S) if settings.always_listening else Waiting()


def hears(state: State) -> bool:
    """Whether an utterance counts in a state, and not only words that stop the robot."""
    return isinstance(state, (Listening, Confirming, Replying))


def step(state: State, event: Event, now: float, settings: DialogueSettings) -> Step:
    """Return the state after an event, and what is to be done.

    Args:
        state: before
        event: what happened
        now: seconds on a monotonic clock
        settings: of the dialogue
    """
    if isinstance(event, Stopped):
        # An open question is gone as well: nothing may begin after a stop by a "yes" to a question before it.
        between = begin(settings)
        return (replace(state, behind=between) if isinstance(state, Deaf) else between), (Stop(event.is_emergency),)
    if isinstance(event, OtherCommand):
        return _without_question(state, settings), ()
    if isinstance(event, Settled):
        return _without_question(state, settings) if isinstance(open_question(state), Replying) else state, ()
    if isinstance(event, Asked):
        return _asked(state, event, now, settings), ()
    if isinstance(event, RobotSpeaks):
        return _speaking(state, event, now, settings), ()
    if isinstance(event, Tick):
        return _expired(state, now, settings) if now >= state.until else (state, ())
    if isinstance(event, Pushed):
        if isinstance(state, Deaf):
            return replace(state, behind=_pushed(state.behind, now, settings)), ()
        return _pushed(state, now, settings), ()
    if isinstance(event, SpeechEnded):
        if isinstance(state, (Listening, Confirming, Replying)):
            return Thinking(now + settings.think_s, state), ()
        return state, ()
    if isinstance(event, Answered):
        question = open_question(state)
        return _answered(question, event.name, now, settings) if question is not None else (state, ())
    if isinstance(state, Thinking):
        state = state.behind
    if isinstance(state, (Confirming, Replying)):
        return _heard_answer(state, event.heard, now, settings)
    if isinstance(state, Listening):
        return _heard_command(state, event, now, settings)
    return state, ()


def open_question(state: State) -> Union[Confirming, Replying, None]:
    """Return the question that waits for an answer."""
    awake = state.behind if isinstance(state, Deaf) else state
    behind = awake.behind if isinstance(awake, Thinking) else awake
    return behind if isinstance(behind, (Confirming, Replying)) else None


def _asked(state: State, event: Asked, now: float, settings: DialogueSettings) -> State:
    """The voice's own question comes first: its answer is another command, and ends that of the pipeline."""
    if isinstance(open_question(state), Confirming):
        return state
    if isinstance(state, Deaf):
        return replace(state, behind=_asked_awake(state.behind, event, now, settings))
    return _asked_awake(state, event, now, settings)


def _asked_awake(state: Awake, event: Asked, now: float, settings: DialogueSettings) -> Awake:
    return Replying(now + settings.answer_s) if event.has_answers else _pushed(state, now, settings)


def _without_question(state: State, settings: DialogueSettings) -> State:
    if open_question(state) is None:
        return state
    return replace(state, behind=begin(settings)) if isinstance(state, Deaf) else begin(settings)


def _pushed(state: Awake, now: float, settings: DialogueSettings) -> Awake:
    if isinstance(state, Waiting):
        return Listening(now + settings.listen_s)
    if isinstance(state, Listening) and state.until != NEVER_S:
        return replace(state, until=now + settings.listen_s)
    return state


def _speaking(state: State, event: RobotSpeaks, now: float, settings: DialogueSettings) -> State:
    if event.is_speaking:
        behind = state.behind if isinstance(state, Deaf) else state
        return Deaf(now + settings.deaf_s, behind)
    return _hearing_again(state.behind, now, settings) if isinstance(state, Deaf) else state


def _hearing_again(state: Awake, now: float, settings: DialogueSettings) -> Awake:
    """Return a state whose time begins only when the robot has spoken."""
    if isinstance(state, (Confirming, Replying)):
        return replace(state, until=now + settings.answer_s)
    if isinstance(state, Listening) and state.until != NEVER_S:
        return replace(state, until=now + settings.listen_s)
    return state


def _expired(state: State, now: float, settings: DialogueSettings) -> Step:
    if isinstance(state, Deaf):
        return _hearing_again(state.behind, now, settings), ()
    if isinstance(state, Thinking):
        return _hearing_again(state.behind, now, settings), ()
    return begin(settings), (Say(NOT_ANSWERED),) if isinstance(state, Confirming) else ()


def _heard_command(state: Listening, event: Understood, now: float, settings: DialogueSettings) -> Step:
    heard = event.heard
    if heard.is_stop:
        return begin(settings), (Stop(heard.is_emergency),)
    if state.until == NEVER_S and not event.is_called:
        return state, ()  # talk that is not for the robot
    if event.is_call_only:
        return Listening(now + settings.listen_s), (Say(CALLED),)
    if heard.offers:
        return _offered(heard, now, settings)
    if state.until == NEVER_S and heard.verdict is Verdict.NOTHING:
        return state, ()  # talk about the robot
    return _again(state, now, settings, Say(AGAIN))


def _again(state: Listening, now: float, settings: DialogueSettings, sentence: Say) -> Step:
    if state.repeats >= settings.most_repeats:
        return begin(settings), (sentence,)
    return Listening(now + settings.listen_s, state.repeats + 1), (sentence,)


def _offered(heard: Heard, now: float, settings: DialogueSettings) -> Step:
    first = heard.offers[0]
    if not settings.asks(first, heard.verdict):
        return begin(settings), (Command(first.text, first.frame, is_confirmed=False),)
    question = first.question
    if len(heard.offers) == 2:
        one, other = (offer.deed or offer.text for offer in heard.offers)
        question = f"Shall I first, {one}, or second, {other}?"
    return Confirming(now + settings.answer_s, heard.offers), (Say(question, is_question=True),)


def _heard_answer(state: Union[Confirming, Replying], heard: Heard, now: float, settings: DialogueSettings) -> Step:
    if heard.answer and isinstance(state, Replying) and heard.answer not in YES_NO:
        # One thing of several may be misheard as another one.
        return _offered(Heard(Verdict.LIKELY, (Offer("", (), heard.answer),)), now, settings)
    if heard.answer:
        return _answered(state, heard.answer, now, settings)
    if heard.is_stop:
        return begin(settings), (Stop(heard.is_emergency),)
    if heard.verdict is Verdict.SURE and heard.offers:
        return _offered(heard, now, settings)
    if state.repeats >= settings.most_repeats:
        return begin(settings), (Say(ALL_RIGHT),)
    if isinstance(state, Replying):
        return Replying(now + settings.answer_s, state.repeats + 1), (Say(AGAIN, is_question=True),)
    sentence = YES_OR_NO if len(state.offers) == 1 else "Please say the first, the second, or no."
    return (
        Confirming(now + settings.answer_s, state.offers, state.repeats + 1),
        (Say(sentence, is_question=True),),
    )


def _answered(state: Union[Confirming, Replying], name: str, now: float, settings: DialogueSettings) -> Step:
    """Only a yes to one offer, or the choice of one of two, begins anything; the pipeline gets its answer."""
    if isinstance(state, Replying):
        return begin(settings), (Command(name, "", is_confirmed=True),)
    chosen = {"yes": 0} if len(state.offers) == 1 else {"first": 0, "second": 1}
    if name in chosen:
        offer = state.offers[chosen[name]]
        return begin(settings), (Command(offer.text, offer.frame, is_confirmed=True),)
    if name == "no":
        return begin(settings), (Say(ALL_RIGHT),)
    return _heard_answer(state, Heard(Verdict.NOTHING), now, settings)
