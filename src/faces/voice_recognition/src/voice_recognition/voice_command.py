"""``rfn voice``: shows what is heard in a WAV file, and why."""

import argparse
import json
import sys
from contextlib import contextmanager
from typing import Dict, FrozenSet, Iterator, List, Tuple, Union

from offline_pipeline.knowledge import Knowledge, load_knowledge, shipped_domains, with_names
from offline_pipeline.pipeline import Pipeline
from stanford_parser_ros.inference import ModelError
from voice_recognition.agreement import Heard
from voice_recognition.command_reading import make_reader
from voice_recognition.dialogue import Confirm, DialogueSettings
from voice_recognition.ears import Ears, make_shipped_ears
from voice_recognition.endpointing import Endpointer, Utterance
from voice_recognition.engines import Engine, chosen
from voice_recognition.recogniser import NoRecogniser
from voice_recognition.sound import UnreadableSound, duration_s, read_wav
from voice_recognition.spoken_language import grounded_frames, make_language
from voice_recognition.whisper_client import WhisperProcess
from voice_recognition.whisper_ears import WhisperEars, make_whisper_ears
from world_model import World

EXAMPLES = """examples:
  espeak-ng -w said.wav "Turn left ninety degrees." && rfn voice said.wav
  rfn voice said.wav --frames turning,moving,stopping
  rfn voice said.wav --json

exit status: 0 heard a command, 1 heard none, 2 wrong usage, a file that cannot be read, or no recogniser
"""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn voice``."""
    parser.epilog = EXAMPLES
    parser.add_argument("file", metavar="FILE.wav", help="of any rate, 8 or 16 bit")
    parser.add_argument("--domains", action="append", metavar="FOLDER", help="frames and units (default: shipped)")
    parser.add_argument("--names", action="append", default=[], metavar="FILE", help="names that the robot knows")
    parser.add_argument("--frames", default="", metavar="NAMES", help="frames with a server (default: every frame)")
    parser.add_argument("--confirm", choices=[one.value for one in Confirm], default=Confirm.MOTION.value)
    parser.add_argument(
        "--engine",
        choices=[one.value for one in Engine],
        default=Engine.AUTO.value,
        help="what hears (default: Whisper where it is installed, otherwise pocketsphinx)",
    )
    parser.add_argument("--json", action="store_true", help="one JSON object")


def run(arguments: argparse.Namespace) -> int:
    """Hear a file; return the exit status."""
    try:
        pcm = read_wav(arguments.file)
        knowledge = with_names(load_knowledge(arguments.domains or [shipped_domains()]), arguments.names)
        served = frozenset(arguments.frames.split(",")) if arguments.frames else frozenset(knowledge.frames)
        unknown = sorted(served - set(knowledge.frames))
        if unknown:
            print(f"rfn voice: unknown frames: {', '.join(unknown)}", file=sys.stderr)
            return 2
        by_pocketsphinx = ears_of(knowledge, served)
        engine, reason = chosen(Engine(arguments.engine))
        if reason and arguments.engine == Engine.WHISPER.value:
            raise NoRecogniser(reason)
        with _ears(engine, knowledge, served, by_pocketsphinx) as ears:
            heard = [(utterance, ears.hear(utterance.pcm)) for utterance in utterances_of(pcm)]
    except (UnreadableSound, NoRecogniser, ModelError) as problem:
        print(f"rfn voice: {problem}", file=sys.stderr)
        return 2
    settings = DialogueSettings(confirm=Confirm(arguments.confirm))
    if arguments.json:
        json.dump([as_data(utterance, what, settings) for utterance, what in heard], sys.stdout, indent=2)
        print()
    else:
        print("\n".join(report(by_pocketsphinx, engine, duration_s(pcm), heard, settings)))
    return 0 if any(what.offers or what.is_stop for _, what in heard) else 1


@contextmanager
def _ears(
    engine: Engine, knowledge: Knowledge, served: FrozenSet[str], by_pocketsphinx: Ears
) -> Iterator[Union[Ears, WhisperEars]]:
    """Have the ears of an engine; Whisper's process ends with the context."""
    if engine is not Engine.WHISPER:
        yield by_pocketsphinx
        return
    for frame in served:
        knowledge.graph.register(frame, frame)
    whisper = WhisperProcess()
    try:
        if not whisper.wait_until_ready():
            raise NoRecogniser(whisper.problem)
        reader = make_reader(Pipeline(knowledge), by_pocketsphinx.finder, World())
        yield make_whisper_ears(by_pocketsphinx, whisper, reader, World())
    finally:
        whisper.close()


def ears_of(knowledge: Knowledge, served: FrozenSet[str]) -> Ears:
    """Make ears for files of frames and units.

    Args:
        knowledge: frames, units and names
        served: names of the frames with a server
    Raises:
        NoRecogniser: it is not installed
    """
    grounded = grounded_frames(knowledge.frames, served)
    names = knowledge.types.names
    return make_shipped_ears(make_language(knowledge.frames, knowledge.lexicon.units, grounded, names, knowledge.types))


def utterances_of(pcm: bytes) -> Tuple[Utterance, ...]:
    """Return the utterances in a whole sound, which need not begin with quiet."""
    first = Endpointer()
    first.feed(pcm)
    endpointer = Endpointer(noise_db=first.noise_db)
    return endpointer.feed(pcm) + endpointer.finish()


def report(
    ears: Ears, engine: Engine, seconds: float, heard: List[Tuple[Utterance, Heard]], settings: DialogueSettings
) -> List[str]:
    """Return the lines about what was heard."""
    language = ears.language
    known = f"{len(language.templates)} commands, {len(language.vocabulary())} words"
    is_whisper = engine is Engine.WHISPER
    lines = [f"{seconds:.1f} s of sound; {'heard by Whisper' if is_whisper else known}"]
    if not is_whisper and ears.unpronounceable:
        lines.append(f"words that cannot be heard: {', '.join(sorted(ears.unpronounceable))}")
    if not heard:
        lines.append("nobody speaks")
    for utterance, what in heard:
        cut = ", cut off" if utterance.is_cut else ""
        lines += [
            "",
            f"{utterance.begin_s:.2f} to {utterance.end_s:.2f} s{cut}",
            f"  {'chosen    ' if is_whisper else 'by grammar'}   {' '.join(what.by_grammar) or '(nothing)'}",
            f"  {'heard    ' if is_whisper else 'by n-gram'}    {' '.join(what.by_ngram) or '(nothing)'}",
            f"  verdict      {what.verdict.value}",
        ]
        if what.is_stop:
            lines.append("  stops the robot, without a question")
        for offer in what.offers:
            elements = ", ".join(f"{name}={value}" for name, value in offer.elements)
            lines += [f"  frame        {offer.frame}({elements})", f"  text         {offer.text}"]
            asks = settings.asks(offer, what.verdict)
            lines.append(f"  the robot    {'asks: ' + offer.question if asks else 'does it without a question'}")
    return lines


def as_data(utterance: Utterance, heard: Heard, settings: DialogueSettings) -> Dict[str, object]:
    """Return what was heard as a JSON object."""
    return {
        "begin": round(utterance.begin_s, 2),
        "end": round(utterance.end_s, 2),
        "by_grammar": " ".join(heard.by_grammar),
        "by_ngram": " ".join(heard.by_ngram),
        "verdict": heard.verdict.value,
        "is_stop": heard.is_stop,
        "offers": [
            {
                "frame": offer.frame,
                "elements": dict(offer.elements),
                "text": offer.text,
                "question": offer.question if settings.asks(offer, heard.verdict) else "",
            }
            for offer in heard.offers
        ],
    }
