"""How well synthetic voices are heard: whole dialogues, faster than real time.

    python3 src/faces/voice_recognition/test/figures.py --sentences 400

The robot is a Turtlebot with some names; a simulated person answers its questions truly, by voice.
"""

import argparse
import random
import re
import sys
import time
from collections import Counter
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from typing import Callable, Dict, Iterable, Iterator, List, Optional, Sequence, Tuple, TypeVar, Union
from typing import Counter as CounterType

from synthetic_speech import silence, speech, voices, with_noise, with_silence

from command_server.stop_words import is_stop as is_cry
from offline_pipeline.knowledge import load_knowledge, pretend_servers, shipped_domains
from offline_pipeline.pipeline import Pipeline
from roboframenet_testing.workspace import REPOSITORY
from voice_recognition.agreement import Heard, Verdict
from voice_recognition.calling import Calls, understood
from voice_recognition.command_reading import make_reader
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
from voice_recognition.early_hearing import EarlyHearing
from voice_recognition.ears import Ears, make_shipped_ears
from voice_recognition.endpointing import Endpointer, Utterance, VoiceDetector
from voice_recognition.microphone import PART_BYTES
from voice_recognition.offers import Offer
from voice_recognition.recogniser import RATE, model_dictionary
from voice_recognition.sound import duration_s
from voice_recognition.spoken_language import Words, grounded_frames, make_language, sentences
from voice_recognition.spotting import LONGEST_S, StopSpotter
from voice_recognition.stop_hearing import StopHearing
from voice_recognition.whisper_client import WhisperProcess
from voice_recognition.whisper_ears import WhisperEars, make_whisper_ears
from world_model.world import snapshot
from world_model.world_file import load_world_file

What = TypeVar("What")
AnyEars = Union[Ears, WhisperEars]
Clock = Callable[[], float]

SERVED = frozenset("pinging stopping waiting following moving turning saying telling speaking".split())
ROOMS = "kitchen office garage hall lab"
PERSONS = "Alice Bob Anna"
STOPS = ("stop", "stop now", "stop stop", "halt", "stop it", "please stop", "robot stop")
SETTINGS = DialogueSettings()
CALLS = Calls(["robot"])
_STOPS = re.compile("stop|halt", re.IGNORECASE)
_WORD = re.compile(r"[A-Za-z]{2,}")
#: Seconds of talk, and sentences, after which the figures so far are printed: a run that is cut off still has some.
PART_S, PART = 60.0, 120
_MARKUP = re.compile(r"```.*?```|\|.*?\n|`[^`]*`|\[|\]\([^)]*\)|[#*_<>]", re.DOTALL)


@dataclass
class Count:
    """What came of some sentences."""

    outcomes: CounterType[str] = field(default_factory=Counter)
    wrong_motions: int = 0
    seconds: List[float] = field(default_factory=list)

    @property
    def total(self) -> int:
        return sum(self.outcomes.values())

    def share(self, *names: str) -> float:
        return sum(self.outcomes[name] for name in names) / max(1, self.total)


def turtlebot() -> Ears:
    """Return ears for what the simulated Turtlebot can do."""
    knowledge = load_knowledge([shipped_domains()])
    names: Dict[str, Tuple[str, ...]] = dict.fromkeys(ROOMS.split(), ("Room",))
    names.update(dict.fromkeys(PERSONS.split(), ("Human",)))
    grounded = grounded_frames(knowledge.frames, SERVED)
    return make_shipped_ears(make_language(knowledge.frames, knowledge.lexicon.units, grounded, names, knowledge.types))


def turtlebot_by_whisper(ears: Ears, whisper: WhisperProcess) -> Tuple[WhisperEars, Callable[[Words], Optional[Offer]]]:
    """Return ears for the same Turtlebot by Whisper, and what reads words as they do."""
    knowledge = load_knowledge([shipped_domains()])
    for frame in SERVED:
        knowledge.graph.register(frame, frame)
    text = f"places: {{{': , '.join(ROOMS.split())}: }}\npersons: {{{': , '.join(PERSONS.lower().split())}: }}\n"
    world = snapshot("1", {one.id: one for one in load_world_file(text, "world.yaml")})
    reader = make_reader(Pipeline(knowledge), ears.finder, world)
    return make_whisper_ears(ears, whisper, reader, world), lambda words: reader.read(" ".join(words)).offer


def drawn(ears: Ears, count: int, seed: int) -> List[Words]:
    """Draw sentences: each example of a unit is equally likely, and each filler of its slots."""
    chance = random.Random(seed)
    by_example: Dict[str, List[Words]] = {}
    for template, _, words in sentences(ears.language):
        by_example.setdefault(template.text, []).append(words)
    examples = sorted(by_example)
    return [chance.choice(by_example[chance.choice(examples)]) for _ in range(count)]


def utterance_in(pcm: bytes, voice: Optional[VoiceDetector] = None) -> Optional[bytes]:
    """Return the longest utterance in a sound.

    Args:
        pcm: the sound
        voice: tells a voice from noise
    """
    endpointer = Endpointer(voice=voice)
    found = endpointer.feed(pcm) + endpointer.finish()
    return max((one.pcm for one in found), key=len, default=None)


def heard_in_time(
    pcm: bytes, ears: AnyEars, spotter: StopSpotter, clock: Clock = time.thread_time
) -> Optional[Tuple[Heard, float]]:
    """Return what the node hears in the longest utterance of a sound, and the seconds from its end to the question.

    As in the node, one thread searches for commands, and another one beside it for a stop.
    """
    endpointer = Endpointer()
    pauses: List[Tuple[float, Utterance]] = []
    ends: List[Tuple[float, Utterance]] = []
    for at in range(0, len(pcm), PART_BYTES):
        found = endpointer.feed(pcm[at : at + PART_BYTES])
        now_s = (at + PART_BYTES) / (2.0 * RATE)
        ends += [(now_s, one) for one in found]
        pause = endpointer.take_pause()
        pauses += [(now_s, pause)] if pause is not None else []
    ends += [(duration_s(pcm), one) for one in endpointer.finish()]
    if not ends:
        return None
    end_s, whole = max(ends, key=lambda one: len(one[1].pcm))
    pauses = [(now_s, one) for now_s, one in pauses if one.begin_s == whole.begin_s]
    with ThreadPoolExecutor(1) as beside:
        is_short = whole.end_s - whole.begin_s <= LONGEST_S
        stop = beside.submit(_search_in_time, spotter.stop_in, pauses, (end_s, whole)) if is_short else None
        heard, at_s = _search_in_time(ears.hear, pauses, (end_s, whole), clock)
        if stop is not None:
            stop.result()
    return heard, at_s - whole.end_s


def _search_in_time(
    hear: Callable[[bytes], What],
    pauses: Sequence[Tuple[float, Utterance]],
    end: Tuple[float, Utterance],
    clock: Clock = time.thread_time,
) -> Tuple[What, float]:
    """Return what a thread of searches hears, and when: when the sound comes, and the processor time of each search.

    Args:
        hear: a search
        pauses: what was said before each pause, and when it came
        end: the whole, and when it came
        clock: of the time of a search
    """
    early: EarlyHearing[None, What] = EarlyHearing()
    free_s = 0.0
    for when_s, one in pauses:
        began = clock()
        early.listen(one, None, hear)
        free_s = max(free_s, when_s) + clock() - began
    began = clock()
    heard = early.heard(end[1], None, hear)
    return heard, max(free_s, end[0]) + clock() - began


class Person:
    """Says commands in one voice after the other, and answers truly."""

    def __init__(
        self,
        ears: AnyEars,
        spotter: StopSpotter,
        snr_db: Optional[float],
        seed: int,
        *,
        is_timed: bool = True,
        read: Optional[Callable[[Words], Optional[Offer]]] = None,
    ) -> None:
        self._read = read or ears.finder.find
        self._is_timed = is_timed
        self._ears = ears
        self._spotter = spotter
        self._snr_db = snr_db
        self._seed = seed
        self._answers: Dict[Tuple[str, Tuple[str, str]], bytes] = {}

    def _sound(self, text: str, voice: Tuple[str, str]) -> bytes:
        pcm = with_silence(speech(text, voice), before_s=0.8, after_s=0.7)
        self._seed += 1
        return pcm if self._snr_db is None else with_noise(pcm, self._snr_db, self._seed)

    def _answer(self, text: str, voice: Tuple[str, str]) -> bytes:
        if (text, voice) not in self._answers:
            self._answers[text, voice] = self._sound(text, voice)
        return self._answers[text, voice]

    def _heard(self, pcm: bytes) -> Optional[Tuple[Heard, float]]:
        if self._is_timed:
            # Whisper computes in another process.
            clock = time.thread_time if isinstance(self._ears, Ears) else time.monotonic
            return heard_in_time(pcm, self._ears, self._spotter, clock)
        utterance = utterance_in(pcm)
        return None if utterance is None else (self._ears.hear(utterance), 0.0)

    def talk(self, said: Sequence[Words], count: Count) -> None:
        """Have a dialogue about each sentence, and count what comes of it."""
        for number, words in enumerate(said):
            voice = voices()[number % len(voices())]
            meant = self._read(words)
            assert meant is not None
            found = self._heard(self._sound(" ".join(words), voice))
            if found is None:
                count.outcomes["not heard"] += 1
                continue
            state, _ = step(begin(SETTINGS), Pushed(), 0.0, SETTINGS)
            state, _ = step(state, SpeechEnded(), 0.0, SETTINGS)
            heard, seconds = found
            count.seconds.append(seconds)
            state, actions = step(state, Understood(heard), 0.0, SETTINGS)
            offers = state.offers if isinstance(state, Confirming) else heard.offers
            count.outcomes[
                _outcome(offers, heard.verdict, meant, is_stop=any(isinstance(one, Stop) for one in actions))
            ] += 1
            if isinstance(state, Confirming):
                text = "yes" if len(offers) == 1 and offers[0].means_the_same(meant) else "no"
                answer = utterance_in(self._answer(text, voice))
                if answer is not None:
                    state, _ = step(state, SpeechEnded(), 0.0, SETTINGS)
                    state, actions = step(state, Understood(self._ears.hear_answer(answer)), 0.0, SETTINGS)
            for action in actions:
                if isinstance(action, Command) and action.frame not in SETTINGS.frames_without_motion:
                    done = self._read(tuple(action.text.lower().split())) or _of_text(offers, action.text)
                    count.wrong_motions += not (done is not None and done.means_the_same(meant))


def _of_text(offers: Sequence[Offer], text: str) -> Optional[Offer]:
    return next((offer for offer in offers if offer.text == text), None)


def _outcome(offers: Sequence[Offer], verdict: Verdict, meant: Offer, *, is_stop: bool) -> str:
    if is_stop:
        return "right" if is_cry(meant.text) else "wrong"
    if not offers:
        return "asked again"
    right = [offer.means_the_same(meant) for offer in offers]
    if verdict is Verdict.CHOICE:
        return "choice" if any(right) else "wrong"
    return "right" if right[0] else "wrong"


def stops_heard(spotter: StopSpotter, count: int, snr_db: float) -> Tuple[int, int]:
    """Return how many stops the node would hear, and how many were said; the noise goes on before and after."""
    heard = 0
    for number in range(count):
        voice = voices()[number % len(voices())]
        text = STOPS[number // len(voices()) % len(STOPS)]
        pcm = with_noise(with_silence(speech(text, voice), before_s=0.8, after_s=2.0), snr_db, seed=number)
        found = Endpointer().feed(pcm)
        heard += any(spotter.stop_in(one.pcm) for one in found if one.end_s - one.begin_s <= LONGEST_S)
    return heard, count


def talk(seconds: float, folder: Path, *, are_short: bool = False) -> Iterator[bytes]:
    """Yield talk that is not for the robot, a minute at a time: the project's pages without a word that stops it.

    Args:
        seconds: how long
        folder: of the pages
        are_short: phrases of at most six words with a pause behind each, in place of sentences
    """
    text = " ".join(path.read_text(encoding="utf-8") for path in sorted(folder.glob("**/*.md")))
    ends = r"(?<=[.:;?!,])\s" if are_short else r"(?<=[.:;?!])\s"
    lines = [re.sub(r"\s+", " ", line).strip() for line in re.split(ends, _MARKUP.sub(" ", text))]
    fewest, most = (1, 6) if are_short else (2, 25)
    lines = [one for one in lines if fewest <= len(_WORD.findall(one)) <= most and not _STOPS.search(one)]
    random.Random(1).shuffle(lines)
    part: List[bytes] = []
    total = 0.0
    for number, line in enumerate(lines * 20):
        part.append(with_silence(speech(line, voices()[number % len(voices())]), before_s=0.1, after_s=0.7))
        total += duration_s(part[-1])
        if total >= seconds or sum(map(len, part)) >= PART_S * RATE * 2:
            yield b"".join(part)
            part = []
        if total >= seconds:
            return


def quiet(seconds: float) -> Iterator[bytes]:
    """Yield silence, a minute at a time."""
    for number in range(int(seconds / PART_S)):
        yield silence(PART_S, seed=number)


def false_alarms(ears: AnyEars, stop_in: Callable[[bytes], str], parts: Iterable[bytes]) -> Iterator[CounterType[str]]:
    """Count what a robot that always listens does with talk; nobody answers its questions. Yields after each part."""
    endpointer = Endpointer()
    counts: CounterType[str] = Counter()
    for pcm in parts:
        counts["seconds"] += round(duration_s(pcm))
        _add_alarms(ears, stop_in, endpointer.feed(pcm), counts)
        yield counts


def _add_alarms(
    ears: AnyEars, stop_in: Callable[[bytes], str], found: Iterable[Utterance], counts: CounterType[str]
) -> None:
    settings = DialogueSettings(always_listening=True)
    for one in found:
        counts["utterances"] += 1
        if one.end_s - one.begin_s <= LONGEST_S:
            counts["short ones"] += 1
            counts["false stops"] += bool(stop_in(one.pcm))
        state, _ = step(begin(settings), SpeechEnded(), 0.0, settings)
        state, actions = step(state, understood(ears.hear(one.pcm), CALLS), 0.0, settings)
        counts["questions"] += isinstance(state, Confirming)
        moves = [a for a in actions if isinstance(a, Command) and a.frame not in settings.frames_without_motion]
        counts["motions"] += len(moves)


def read_by_pipeline(ears: Ears, count: int) -> Tuple[int, List[str]]:
    """Return how many sentences the pipeline reads as the frame that the robot would ask about, and the others.

    Sentences that stop the robot do not reach the framer; they are read.
    """
    knowledge = load_knowledge([shipped_domains()])
    pretend_servers(knowledge.graph)
    pipeline = Pipeline(knowledge)
    others: List[str] = []
    for words in drawn(ears, count, seed=3):
        offer = ears.finder.find(words)
        assert offer is not None
        frames = [reading.unit.frame_name for reading in pipeline.understand(offer.text).readings]
        if frames != [offer.frame] and not is_cry(offer.text):
            others.append(f"{offer.text}: {offer.frame}, read as {frames}")
    return count - len(others), others


def main(argv: Optional[Sequence[str]] = None) -> int:
    """Print the table; return 0."""
    parser = argparse.ArgumentParser(description="How well synthetic voices are heard.")
    parser.add_argument("--sentences", type=int, default=400, help="without noise")
    parser.add_argument("--seed", type=int, default=2026, help="which sentences")
    parser.add_argument("--untimed", action="store_true", help="no time to the question, which takes more searches")
    parser.add_argument("--noisy", type=int, default=200, help="at each of 20, 10 and 5 dB")
    parser.add_argument("--read", type=int, default=300, help="sentences that the pipeline reads")
    parser.add_argument("--stops", type=int, default=210)
    parser.add_argument("--talk-s", type=float, default=1200.0)
    parser.add_argument("--phrases-s", type=float, default=600.0, help="of talk in phrases of at most six words")
    parser.add_argument("--silence-s", type=float, default=1200.0)
    parser.add_argument("--engine", choices=["whisper", "pocketsphinx"], default="pocketsphinx")
    arguments = parser.parse_args(argv)
    if arguments.engine == "pocketsphinx":
        return table(arguments, None)
    whisper = WhisperProcess()
    try:
        whisper.start()
        if not whisper.wait_until_ready():
            print(f"figures.py: {whisper.problem}", file=sys.stderr)
            return 2
        return table(arguments, whisper)
    finally:
        whisper.close()


def table(arguments: argparse.Namespace, whisper: Optional[WhisperProcess]) -> int:
    """Print the table; return 0.

    Args:
        arguments: of the command line
        whisper: hears; None if pocketsphinx does
    """
    by_pocketsphinx, spotter = turtlebot(), StopSpotter(model_dictionary())
    ears: AnyEars = by_pocketsphinx
    read: Callable[[Words], Optional[Offer]] = by_pocketsphinx.finder.find
    if whisper is not None:
        ears, read = turtlebot_by_whisper(by_pocketsphinx, whisper)
    language = by_pocketsphinx.language
    print(f"{len(language.templates)} commands, {len(language.vocabulary())} words; voices: {voices()}", flush=True)
    print("noise   said right choice again wrong  wrong motions  question p50, p95 (s)")
    for name, snr_db, size in (("none", None, arguments.sentences),) + tuple(
        (f"{snr:g} dB", snr, arguments.noisy) for snr in (20.0, 10.0, 5.0)
    ):
        if not size:
            continue
        count, said = Count(), drawn(by_pocketsphinx, size, seed=arguments.seed)
        person = Person(ears, spotter, snr_db, seed=7, is_timed=not arguments.untimed, read=read)
        for at in range(0, size, PART):
            person.talk(said[at : at + PART], count)
            if at + PART < size:
                print(f"  so far: {dict(count.outcomes)}, {count.wrong_motions} wrong motions", flush=True)
        late = sorted(count.seconds)
        print(
            f"{name:7} {count.total:4} {count.share('right'):5.1%} {count.share('choice'):6.1%} "
            f"{count.share('asked again', 'not heard'):5.1%} {count.share('wrong'):5.1%} "
            f"{count.wrong_motions:9}       {late[len(late) // 2]:.2f}, {late[int(len(late) * 0.95)]:.2f}",
            flush=True,
        )
    if arguments.read:
        count_read, others = read_by_pipeline(by_pocketsphinx, arguments.read)
        print(f"read by the pipeline as the frame in the question: {count_read} of {arguments.read}", flush=True)
        print("".join(f"  {other}\n" for other in others), end="")
    if arguments.stops:
        heard, said = stops_heard(spotter, arguments.stops, 10.0)
        print(f"stops heard at 10 dB: {heard} of {said}", flush=True)
    folder = REPOSITORY
    hearing = StopHearing(spotter, ears.hear_stop if isinstance(ears, WhisperEars) else None)
    for what, seconds, parts in (
        ("talk", arguments.talk_s, talk(arguments.talk_s, folder)),
        ("short phrases", arguments.phrases_s, talk(arguments.phrases_s, folder, are_short=True)),
        ("silence", arguments.silence_s, quiet(arguments.silence_s)),
    ):
        counts: CounterType[str] = Counter()
        for number, counts in enumerate(false_alarms(ears, hearing.stop_in, parts if seconds else ())):
            if number % 5 == 4:
                print(f"  {what} so far: {dict(counts)}", flush=True)
        if seconds:
            print(f"{what}: {dict(counts)}", flush=True)
    hearing.close()
    return 0


if __name__ == "__main__":
    sys.exit(main())
