"""How well an engine hears wordings that were written beforehand: some voices say each, to a Turtlebot or in the home.

    python3 src/faces/voice_recognition/test/heard.py --engine whisper --voices flite:slt,flite:rms

Right is what the written pipeline makes of the wording: done at once, or asked about in a question that a yes answers.
"""

import argparse
import itertools
import sys
import time
from collections import Counter
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Dict, Iterator, List, Optional, Sequence, Tuple, Union
from typing import Counter as CounterType

import numpy as np
import yaml
from figures import SERVED, false_alarms, quiet, talk, utterance_in
from synthetic_speech import VOICES, noise_like_a_room, speech, with_echo, with_noise, with_silence

from command_server.stop_words import is_stop
from offline_pipeline.knowledge import load_knowledge, pretend_servers, shipped_domains
from offline_pipeline.pipeline import Pipeline
from roboframenet_testing.workspace import REPOSITORY
from voice_recognition.agreement import Heard
from voice_recognition.command_reading import CommandReader, Meaning, Sense, make_reader
from voice_recognition.dialogue import (
    Command,
    Confirming,
    DialogueSettings,
    Pushed,
    SpeechEnded,
    Stop,
    Understood,
    begin,
    step,
)
from voice_recognition.ears import Ears, make_shipped_ears
from voice_recognition.offers import Offer
from voice_recognition.recogniser import RATE, model_dictionary
from voice_recognition.sound import duration_s, to_pcm
from voice_recognition.speech_detection import SpeechStream, load_session
from voice_recognition.spoken_language import grounded_frames, make_language, spoken_words
from voice_recognition.spotting import StopSpotter
from voice_recognition.stop_hearing import StopHearing
from voice_recognition.whisper_client import WhisperProcess
from voice_recognition.whisper_ears import WhisperEars, make_whisper_ears
from world_model import World
from world_model.names import known_names
from world_model.world import snapshot
from world_model.world_file import load_world_file

STOPS = Path(__file__).with_name("stop_phrasings.txt")
TELEVISION = Path(__file__).with_name("television.txt")
WORDINGS = Path(__file__).with_name("wordings.tsv")
HOME = REPOSITORY / "src" / "simulation" / "roboframenet_sim" / "config" / "home.yaml"
SMALL_WORLD = """
places: {kitchen: , office: , garage: , hall: , lab: }
persons: {alice: , bob: , anna: }
"""
SETTINGS = DialogueSettings()
MINUTE_S = 60.0
TELEVISION_VOICES = (*VOICES, ("espeak-ng", "en-gb-x-rp"), ("espeak-ng", "en-us+m3"), ("espeak-ng", "en-gb-scotland"))


@dataclass
class Robot:
    """Who is spoken to."""

    ears: Union[Ears, WhisperEars]
    reader: CommandReader


@dataclass(frozen=True)
class Room:
    """How it is said, and where.

    Attributes:
        speed: words a minute of espeak-ng
        snr_db: signal-to-noise ratio; None without noise
        has_echo: whether the room has an echo
        session: of the voice detector; None for pocketsphinx
    """

    speed: int
    snr_db: Optional[float]
    has_echo: bool
    session: Any


@dataclass
class Score:
    """What came of some wordings."""

    outcomes: CounterType[str] = field(default_factory=Counter)
    seconds: List[float] = field(default_factory=list)

    def line(self, name: str) -> str:
        """Return a row of the table."""
        total = max(1, sum(self.outcomes.values()))
        shares = " ".join(f"{one} {self.outcomes[one]:4}" for one in OUTCOMES)
        late = sorted(self.seconds) or [0.0]
        right = (self.outcomes["done"] + self.outcomes["asked"]) / total
        return (
            f"{name:24} {total:4} right {right:6.1%} | {shares} | "
            f"{late[len(late) // 2]:.2f}, {late[int(len(late) * 0.95)]:.2f} s"
        )


#: Done or asked about: right. Then what is harmless, and what is not.
OUTCOMES = ("done", "asked", "again", "asked wrongly", "harmless wrong", "false stop", "wrong motion")


def home_world() -> World:
    """Return the things, places and persons of the simulated home, as a robot knows them that has seen all of it."""
    home = yaml.safe_load(HOME.read_text(encoding="utf-8"))
    rooms = set(home["rooms"])
    made: Dict[str, Dict[str, Dict[str, object]]] = {
        "places": {name: {"names": one["names"]} for name, one in home["rooms"].items()},
        "doors": {name: {"names": one["names"]} for name, one in home["doors"].items()},
        "things": {
            name: {"names": one["names"], "category": one["category"], "in": one["room"]}
            for name, one in home["furniture"].items()
        },
        "persons": {name: {} for name in home["persons"]},
    }
    for name, one in home["things"].items():
        where = {("in" if one[key] in rooms else key): one[key] for key in ("on", "in") if key in one}
        colour = {"attributes": [one["color"]]} if "color" in one else {}
        made["things"][name] = {"names": one["names"], "category": one["category"], **where, **colour}
    return _world(yaml.safe_dump(made))


def _world(text: str) -> World:
    return snapshot("1", {one.id: one for one in load_world_file(text, "world.yaml")})


def robots(engine: str, whisper: Optional[WhisperProcess]) -> Dict[str, Robot]:
    """Return the robots that are spoken to.

    Args:
        engine: `whisper` or `pocketsphinx`
        whisper: loaded; None for pocketsphinx
    """
    knowledge = load_knowledge([shipped_domains()])
    pretend_servers(knowledge.graph)
    pipeline = Pipeline(knowledge)
    small = grounded_frames(knowledge.frames, SERVED)
    found: Dict[str, Robot] = {}
    for name, world, grounded in (
        ("turtlebot", _world(SMALL_WORLD), small),
        ("home", home_world(), frozenset(knowledge.frames)),
    ):
        language = make_language(
            knowledge.frames, knowledge.lexicon.units, grounded, dict(known_names(world)), knowledge.types
        )
        ears = make_shipped_ears(language)
        reader = make_reader(pipeline, ears.finder, world)
        found[name] = Robot(make_whisper_ears(ears, whisper, reader, world) if whisper is not None else ears, reader)
    return found


def wordings(path: Path) -> Iterator[Tuple[str, str]]:
    """Yield to whom something is said, and what."""
    for line in path.read_text(encoding="utf-8").splitlines():
        robot, tab, text = line.partition("\t")
        if tab and not line.startswith("#"):
            yield robot, text


def said(text: str, voice: Tuple[str, str], room: Room, seed: int) -> Optional[bytes]:
    """Return the utterance that the node would hear."""
    pcm = with_silence(speech(text, voice, speed=room.speed), before_s=0.8, after_s=0.7)
    pcm = with_echo(pcm, seed) if room.has_echo else pcm
    pcm = pcm if room.snr_db is None else with_noise(pcm, room.snr_db, seed)
    return utterance_in(pcm, SpeechStream(room.session).feed if room.session is not None else None)


def outcome_of(heard: Heard, text: str, meant: Meaning) -> str:
    """Return what comes of it, one of `OUTCOMES`.

    Args:
        heard: what the engine heard
        text: what was said
        meant: what the written pipeline makes of it
    """
    state, _ = step(begin(SETTINGS), Pushed(), 0.0, SETTINGS)
    state, _ = step(state, SpeechEnded(), 0.0, SETTINGS)
    state, actions = step(state, Understood(heard), 0.0, SETTINGS)
    if any(isinstance(one, Stop) for one in actions):
        return "done" if meant.sense is Sense.STOP else "false stop"
    done = [one for one in actions if isinstance(one, Command)]
    if done:
        if _is_meant(heard.offers[0], text, meant):
            return "done"
        moves = SETTINGS.asks(heard.offers[0], heard.verdict) or done[0].frame not in SETTINGS.frames_without_motion
        return "wrong motion" if moves and not heard.offers[0].is_question else "harmless wrong"
    if isinstance(state, Confirming):
        return "asked" if any(_is_meant(one, text, meant) for one in state.offers) else "asked wrongly"
    if meant.sense < Sense.ASKED and heard.by_ngram == spoken_words(text):
        return "done"  # heard rightly, and nothing that the robot can do
    return "again"


def _is_meant(offer: Offer, text: str, meant: Meaning) -> bool:
    if spoken_words(offer.text) == spoken_words(text):
        return True
    return meant.offer is not None and offer.means_the_same(meant.offer)


def stops(
    hearing: StopHearing, phrases: Sequence[str], voice: Tuple[str, str], room: Room, arguments: argparse.Namespace
) -> int:
    """Return how many phrases of one voice stop the robot."""
    found = 0
    for number, text in enumerate(phrases):
        pcm = said(text, voice, room, seed=number)
        stops_it = pcm is not None and bool(hearing.stop_in(pcm))
        found += stops_it
        if arguments.show and stops_it != is_stop(text):
            print(f"  {'stops' if stops_it else 'does not stop'}: {text}", flush=True)
    return found


def main(argv: Optional[Sequence[str]] = None) -> int:
    """Print the table; return 0."""
    parser = argparse.ArgumentParser(description="How well an engine hears wordings.")
    parser.add_argument("--engine", choices=["whisper", "pocketsphinx"], default="whisper")
    parser.add_argument("--voices", default="flite:slt,flite:rms", help="program:voice, separated by commas")
    parser.add_argument("--speed", type=int, default=150, help="words a minute of espeak-ng")
    parser.add_argument("--noise", type=float, help="signal-to-noise ratio, dB")
    parser.add_argument("--echo", action="store_true", help="in a room with an echo")
    parser.add_argument("--alarms", default="", help="count what is done unasked: of silence,noise,talk,television")
    parser.add_argument("--seconds", type=float, default=3600.0, help="of each of these")
    parser.add_argument("--wordings", type=Path, default=WORDINGS)
    parser.add_argument("--every", type=int, default=1, help="only each so many-th wording")
    parser.add_argument("--stops", action="store_true", help="count stops, and false stops of the wordings")
    parser.add_argument("--show", action="store_true", help="print what is not right")
    arguments = parser.parse_args(argv)
    whisper = WhisperProcess() if arguments.engine == "whisper" else None
    try:
        if whisper is not None:
            whisper.start()
            if not whisper.wait_until_ready():
                print(f"heard.py: {whisper.problem}", file=sys.stderr)
                return 2
        spoken_to = robots(arguments.engine, whisper)
        if arguments.alarms:
            _count_alarms(arguments, spoken_to["home"].ears)
            return 0
        room = Room(arguments.speed, arguments.noise, arguments.echo, load_session() if whisper is not None else None)
        for name in arguments.voices.split(","):
            program, _, voice = name.partition(":")
            if arguments.stops:
                _count_stops(arguments, spoken_to["turtlebot"].ears, (program, voice), room)
            else:
                print(_score(arguments, spoken_to, (program, voice), room).line(name), flush=True)
    finally:
        if whisper is not None:
            whisper.close()
    return 0


def _score(arguments: argparse.Namespace, spoken_to: Dict[str, Robot], voice: Tuple[str, str], room: Room) -> Score:
    score = Score()
    for number, (name, text) in enumerate(list(wordings(arguments.wordings))[:: arguments.every]):
        robot = spoken_to[name]
        pcm = said(text, voice, room, seed=number)
        began = time.monotonic()
        heard = robot.ears.hear(pcm) if pcm is not None else None
        score.seconds.append(time.monotonic() - began)
        outcome = outcome_of(heard, text, robot.reader.read(text)) if heard is not None else "again"
        score.outcomes[outcome] += 1
        if arguments.show and outcome not in ("done", "asked") and heard is not None:
            offers = " / ".join(offer.text for offer in heard.offers)
            print(f"  {outcome}: {text} | {heard.verdict.value} | {offers} | {' '.join(heard.by_ngram)}", flush=True)
    return score


def _stop_hearing(ears: Union[Ears, WhisperEars]) -> StopHearing:
    return StopHearing(StopSpotter(model_dictionary()), ears.hear_stop if isinstance(ears, WhisperEars) else None)


def _count_stops(
    arguments: argparse.Namespace, ears: Union[Ears, WhisperEars], voice: Tuple[str, str], room: Room
) -> None:
    hearing = _stop_hearing(ears)
    try:
        phrases = STOPS.read_text(encoding="utf-8").split("\n")[:-1]
        heard = stops(hearing, phrases, voice, room, arguments)
        others = [text for _, text in wordings(arguments.wordings) if not is_stop(text)][:: arguments.every]
        false = stops(hearing, others, voice, room, arguments)
        print(f"{':'.join(voice):24} stops {heard} of {len(phrases)}; false stops {false} of {len(others)}", flush=True)
    finally:
        hearing.close()


def noises(seconds: float) -> Iterator[bytes]:
    """Yield the noise of a room that becomes louder and quieter, with bangs, a minute at a time."""
    for minute in range(int(seconds / MINUTE_S)):
        chance = np.random.default_rng(minute)
        samples = noise_like_a_room(MINUTE_S, minute)[: int(MINUTE_S * RATE)]
        samples *= np.repeat(10.0 ** chance.uniform(1.5, 3.5, 12), len(samples) // 12)
        for at in chance.integers(0, len(samples) - RATE, 10):
            bang = chance.normal(0.0, 8000.0, RATE // 2) * np.exp(-np.arange(RATE // 2) / (0.05 * RATE))
            samples[at : at + len(bang)] += bang
        yield to_pcm(samples)


def television(seconds: float) -> Iterator[bytes]:
    """Yield what a television says, in one voice after the other."""
    lines = [line for line in TELEVISION.read_text(encoding="utf-8").splitlines() if line and line[0] != "#"]
    passed_s = 0.0
    for voice, line in ((voice, line) for voice in itertools.cycle(TELEVISION_VOICES) for line in lines):
        if passed_s >= seconds:
            return
        yield (pcm := with_silence(speech(line, voice), before_s=0.2, after_s=0.8))
        passed_s += duration_s(pcm)


def _count_alarms(arguments: argparse.Namespace, ears: Union[Ears, WhisperEars]) -> None:
    hearing = _stop_hearing(ears)
    sources = {"silence": quiet, "noise": noises, "talk": lambda s: talk(s, REPOSITORY), "television": television}
    try:
        for name in arguments.alarms.split(","):
            counts: CounterType[str] = Counter()
            for number, counts in enumerate(false_alarms(ears, hearing.stop_in, sources[name](arguments.seconds))):
                if arguments.show and number % 50 == 49:
                    print(f"  {name} so far: {dict(counts)}", flush=True)
            print(f"{name}: {dict(counts)}", flush=True)
    finally:
        hearing.close()


if __name__ == "__main__":
    sys.exit(main())
