"""``rfn score`` for a corpus without annotated frames: which utterances are acted on, asked about and refused."""

import argparse
import json
import random
from collections import Counter
from dataclasses import dataclass
from typing import Counter as CounterType
from typing import Dict, List, Sequence, Tuple

from command_server.stop_words import is_stop
from frame_learning.annotated_commands import AnnotatedCommand
from frame_learning.tables import aligned
from offline_pipeline.pipeline import Pipeline, Understanding

#: Outcomes of utterances, in the order of the table.
ACTED, STOPPED, ANSWERED, ASKED, ASKED_TO_LEAVE_OUT, REFUSED, FAILED = (
    "acted on",
    "stops",
    "talk, answered",
    "asked about what is missing",
    "asked to leave words out",
    "refused",
    "errors",
)
_LEFT_OVER = "LEFT_OVER_WORDS"
#: Thanks, greetings and the like get a short answer.
_TALK = "TALK"


@dataclass(frozen=True)
class Outcome:
    """What became of an utterance.

    Attributes:
        text: the utterance
        kind: one of the outcomes above
        code: of the reply
        said: what the robot would do, or the sentence of the reply
    """

    text: str
    kind: str
    code: str
    said: str


def add_outcome_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments for corpora without annotated frames."""
    parser.add_argument(
        "--sample",
        type=int,
        default=0,
        metavar="N",
        help="scout: show N different utterances that are acted on (--seed); mood: score N sentences",
    )


def score_outcomes(arguments: argparse.Namespace, pipeline: Pipeline, commands: Sequence[AnnotatedCommand]) -> int:
    """Count the outcomes of all utterances and of all different ones; return the exit status."""
    known: Dict[str, Outcome] = {}
    outcomes: List[Outcome] = []
    for command in commands:
        key = _key(command.text)
        if key not in known:
            known[key] = _outcome(pipeline, command.text)
        outcomes.append(known[key])
    different = [outcome for key, outcome in known.items() if any(character.isalnum() for character in key)]
    if arguments.wrong:
        with open(arguments.wrong, "w", encoding="utf-8") as file:
            file.writelines(f"{one.code}\t{one.text}\t{one.said}\n" for one in outcomes)
    sample = sample_of(different, arguments.sample, arguments.seed)
    if arguments.json:
        print(json.dumps({**_to_json(outcomes), "different": _to_json(different), "sample": _rows(sample)}))
        return 0
    print(f"{len(outcomes)} utterances, {len(different)} different ones with words\n")
    print(_table(outcomes, different))
    if sample:
        print(f"\n{len(sample)} different utterances that are acted on, seed {arguments.seed}\n")
        print("\n".join(f"{text} | {said}" for text, said in _rows(sample)))
    return 0


def sample_of(outcomes: Sequence[Outcome], count: int, seed: int) -> List[Outcome]:
    """Draw utterances that are acted on, the same for the same seed."""
    acted = sorted((one for one in outcomes if one.kind == ACTED), key=lambda one: one.text)
    return random.Random(seed).sample(acted, min(count, len(acted)))


def _key(text: str) -> str:
    """Return what makes utterances different: neither capitals nor marks at the ends."""
    return " ".join(text.lower().split()).strip(" .,!?")


def _outcome(pipeline: Pipeline, text: str) -> Outcome:
    if is_stop(text):
        return Outcome(text, STOPPED, "DONE", "stops")
    understanding = pipeline.understand_safely(text)
    reply = understanding.reply
    kind = {"DONE": ACTED, "NEEDS_INFORMATION": ASKED, "REFUSED": REFUSED}.get(reply.outcome, FAILED)
    if kind == ASKED and reply.code == _LEFT_OVER:
        kind = ASKED_TO_LEAVE_OUT
    if kind == REFUSED and reply.code == _TALK:
        kind = ANSWERED
    return Outcome(text, kind, reply.code, _deeds(understanding) if kind == ACTED else reply.sentence)


def _deeds(understanding: Understanding) -> str:
    if understanding.behind is not None:
        return f"stops; {_deeds(understanding.behind)}"
    return "; ".join(str(reading) for reading in understanding.readings) or "stops"


def _counts(outcomes: Sequence[Outcome]) -> CounterType[str]:
    return Counter(one.kind for one in outcomes)


def _to_json(outcomes: Sequence[Outcome]) -> Dict[str, object]:
    counts = _counts(outcomes)
    return {
        "lines": len(outcomes),
        "answered": counts[ACTED],
        "talk": counts[ANSWERED],
        "asked_back": counts[ASKED],
        "asked_to_leave_out": counts[ASKED_TO_LEAVE_OUT],
        "refused": counts[REFUSED],
        "stops": counts[STOPPED],
        "errors": counts[FAILED],
        "codes": dict(Counter(one.code for one in outcomes if one.kind == REFUSED).most_common()),
    }


def _rows(sample: Sequence[Outcome]) -> List[Tuple[str, str]]:
    return [(one.text, one.said) for one in sample]


def _table(outcomes: Sequence[Outcome], different: Sequence[Outcome]) -> str:
    rows: List[Tuple[str, ...]] = [("", "all", "%", "different", "%")]

    def row(name: str, first: int, second: int) -> Tuple[str, ...]:
        shares = (f"{100.0 * first / max(1, len(outcomes)):.1f}", f"{100.0 * second / max(1, len(different)):.1f}")
        return name, str(first), shares[0], str(second), shares[1]

    every, each = _counts(outcomes), _counts(different)
    for kind in (ACTED, STOPPED, ANSWERED, ASKED, ASKED_TO_LEAVE_OUT, REFUSED, FAILED):
        rows.append(row(kind, every[kind], each[kind]))
    wanted = (ACTED, STOPPED, ANSWERED, ASKED)
    rows.append(row("the first four", sum(every[kind] for kind in wanted), sum(each[kind] for kind in wanted)))
    codes = Counter(one.code for one in outcomes if one.kind == REFUSED)
    in_different = Counter(one.code for one in different if one.kind == REFUSED)
    rows += [row(f"refused: {code}", count, in_different[code]) for code, count in codes.most_common()]
    return aligned(rows)
