"""Judges whether a base would do what was said, through parser, framer, registrar and the reading of arguments."""

import math
from collections import Counter
from dataclasses import dataclass
from itertools import product
from typing import Dict, Iterable, Iterator, List, Tuple

from move_action_server.spoken_motion import NotUnderstood, backward_goal, forward_goal, turn_goal
from offline_pipeline.knowledge import load_knowledge, shipped_domains
from offline_pipeline.pipeline import Parameters, Pipeline, Understanding
from semantic_framer.values.outcome import LeftOverWords, Policy

from .phrases import Motion, Phrase

_GOALS = {"moving_forward": forward_goal, "moving_backward": backward_goal, "turning": turn_goal}
#: Frames that do not move the base by themselves.
_WITHOUT_SERVER = frozenset(["moving", "turning_around"])
_TOLERANCE = 1e-9


@dataclass(frozen=True)
class Verdict:
    """The result of one sentence.

    Attributes:
        phrase: what was said
        outcome: "right", "asked", "refused", "wrong", or, where left-over words are ignored, "no motion": the result
            is no motion by an amount ("go to the west")
        said: the reply
        done: what would be done, for each candidate
    """

    phrase: Phrase
    outcome: str
    said: str
    done: Tuple[Tuple[Motion, ...], ...]


class Judge:
    """Understands sentences by the shipped domains, with the servers of the base and one for every other frame."""

    def __init__(self) -> None:
        knowledge = load_knowledge([shipped_domains()])
        for name in knowledge.graph.frames:
            if name not in _WITHOUT_SERVER:
                knowledge.graph.register(name, name)
        strict = Pipeline(knowledge)
        ignore = Parameters(policy=Policy(left_over_words=LeftOverWords.IGNORE))
        ignoring = Pipeline(knowledge, strict.parser, parameters=ignore)
        self._pipelines = {"strict": strict, "ignore": ignoring}

    def verdicts(self, phrases: Iterable[Phrase], policy: str) -> Iterator[Verdict]:
        """Judge sentences under a policy for left-over words: "strict" or "ignore"."""
        for phrase in phrases:
            yield self.verdict(phrase, policy)

    def verdict(self, phrase: Phrase, policy: str) -> Verdict:
        """Judge one sentence."""
        understood = self._pipelines[policy].understand_safely(phrase.text)
        if understood.reply.outcome in ("REFUSED", "NEEDS_INFORMATION"):
            outcome = "asked" if understood.reply.outcome == "NEEDS_INFORMATION" else "refused"
            return Verdict(phrase, outcome, f"{understood.reply.code}: {understood.reply.sentence}", ())
        done = _done(understood)
        ways = [way for way in done if policy == "strict" or any(not math.isnan(value) for _, value in way)]
        if not ways and policy != "strict":
            return Verdict(phrase, "no motion", understood.reply.sentence, done)
        is_right = bool(ways) and phrase.is_within_limits and all(_is_same(way, phrase.motions or ()) for way in ways)
        return Verdict(phrase, "right" if is_right else "wrong", understood.reply.sentence, done)


def _done(understood: Understanding) -> Tuple[Tuple[Motion, ...], ...]:
    ways: List[Tuple[Motion, ...]] = []
    for candidates in product(*understood.candidates):
        motions: List[Motion] = []
        for frame in (frame for candidate in candidates for frame in candidate.frames):
            try:
                goal = _GOALS[frame.name]({argument.name: argument for argument in frame.arguments})
            except (KeyError, NotUnderstood):
                motions.append((frame.name, math.nan))
                continue
            motions.append((goal.kind.value, goal.amount))
        ways.append(tuple(motions))
    return tuple(ways)


def _is_same(done: Tuple[Motion, ...], meant: Tuple[Motion, ...]) -> bool:
    return len(done) == len(meant) > 0 and all(
        kind == expected and math.isclose(value, amount, rel_tol=_TOLERANCE)
        for (kind, value), (expected, amount) in zip(done, meant)
    )


def table(verdicts: Iterable[Verdict]) -> List[str]:
    """Return a line for each family of amounts, one for all unambiguous amounts, and one for all."""
    counts: Dict[str, Counter[str]] = {}
    for verdict in verdicts:
        is_open = verdict.phrase.motions is None or not verdict.phrase.is_within_limits
        of_all = "all that must ask or refuse" if is_open else "all that can be read"
        limit = "" if verdict.phrase.is_within_limits else " beyond the limit"
        for family in (("open: " if is_open else "") + verdict.phrase.family + limit, of_all, "all"):
            counts.setdefault(family, Counter())[verdict.outcome] += 1
    names = ("right", "asked", "refused", "no motion", "wrong")
    lines = [f"{'':<48}" + "".join(f"{name:>10}" for name in names)]
    for family in sorted(counts, key=lambda name: (name.startswith("all"), name)):
        lines.append(f"{family:<48}" + "".join(f"{counts[family][name]:>10}" for name in names))
    return lines
