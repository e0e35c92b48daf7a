"""Judges whether an utterance of the generated set acts, and whether it should."""

from collections import Counter
from dataclasses import dataclass
from typing import Dict, Iterable, Iterator, List, Tuple

from offline_pipeline.knowledge import load_knowledge, pretend_servers, shipped_domains
from offline_pipeline.pipeline import Parameters, Pipeline, Understanding
from semantic_framer.queries.deed_questions import QUESTION_OF_EVENT
from semantic_framer.values.outcome import MEANING_ONLY
from semantic_framer.values.reading import Reading

from .utterances import Utterance

#: The frames that would be started, in order, each with its arguments.
Meaning = Tuple[Tuple[str, Tuple[Tuple[str, str], ...]], ...]


@dataclass(frozen=True)
class Verdict:
    """The result of one utterance.

    Attributes:
        utterance: the generated utterance
        text: its words
        outcome: outcome of the reply, as in ``roboframenet_msgs/Reply``
        code: code of the reply
        meaning: what would be done; empty for nothing
        expected: what the plain command would do; empty if the utterance must not act
    """

    utterance: Utterance
    text: str
    outcome: str
    code: str
    meaning: Meaning
    expected: Meaning

    @property
    def acted(self) -> bool:
        """Whether the robot would act."""
        return self.outcome == "DONE" and bool(self.meaning)

    @property
    def is_right(self) -> bool:
        """Whether the robot would do what it should; an internal error is never right."""
        return self.outcome != "FAILED" and self.meaning == self.expected

    def to_json(self) -> Dict[str, object]:
        """Return the values for a JSON file."""
        template = self.utterance.template
        return {
            "kind": template.kind,
            "template": template.template,
            "text": self.text,
            "outcome": self.outcome,
            "code": self.code,
            "meaning": self.meaning,
            "expected": self.expected,
        }


class Judge:
    """Understands utterances by the shipped domains, with a server for every frame."""

    def __init__(self) -> None:
        knowledge = load_knowledge([shipped_domains()])
        pretend_servers(knowledge.graph)
        self._pipeline = Pipeline(knowledge, parameters=Parameters(policy=MEANING_ONLY))
        self._plain: Dict[str, Meaning] = {}

    def verdicts(self, utterances: Iterable[Utterance]) -> Iterator[Verdict]:
        """Judge utterances; leave out requests whose plain command does nothing in their style."""
        for utterance in utterances:
            expected = self._meaning_of_plain(utterance.plain_command) if utterance.template.acts else ()
            if utterance.template.acts and not expected:
                continue
            text = utterance.text
            understood = self._pipeline.understand_safely(text)
            yield Verdict(
                utterance, text, understood.reply.outcome, understood.reply.code, _meaning(understood), expected
            )

    def _meaning_of_plain(self, command: str) -> Meaning:
        if command not in self._plain:
            self._plain[command] = _meaning(self._pipeline.understand_safely(command))
        return self._plain[command]


def _is_question(reading: Reading) -> bool:
    return bool(reading.unit.questions or reading.unit.asks) or reading.unit.frame_name == QUESTION_OF_EVENT


def _meaning(understood: Understanding) -> Meaning:
    """Return what would be done, without the performer, which only a request names: "could *you* ...".

    A question that is answered does nothing.
    """
    if understood.reply.outcome != "DONE" or all(map(_is_question, understood.readings)):
        return ()
    return tuple(
        (
            reading.unit.frame_name,
            tuple(
                sorted(
                    (value.name, value.text.lower())
                    for value in reading.arguments
                    if value.text.lower() not in ("you", "ya", "u")
                )
            ),
        )
        for reading in understood.readings
    )


def table_by_kind(verdicts: Iterable[Verdict]) -> List[str]:
    """Return a line for each kind: how many utterances are right, and the share of wrong ones."""
    total: Dict[str, int] = Counter()
    wrong: Dict[str, int] = Counter()
    for verdict in verdicts:
        kind = verdict.utterance.template.kind
        total[kind] += 1
        wrong[kind] += not verdict.is_right
    return [
        f"{kind:<16} {count - wrong[kind]:>5} of {count:>5} right, {100 * wrong[kind] / count:5.1f} % wrong"
        for kind, count in total.items()
    ]


def table_by_template(verdicts: Iterable[Verdict]) -> List[str]:
    """Return a line for each template, the worst first: how often it acted, did not act, and was wrong."""
    rows: Dict[Tuple[str, str, bool], List[int]] = {}
    for verdict in verdicts:
        template = verdict.utterance.template
        counts = rows.setdefault((template.kind, template.template, template.acts), [0, 0, 0])
        counts[0] += verdict.acted
        counts[1] += not verdict.acted
        counts[2] += not verdict.is_right
    lines = [f"{'wrong':>5} {'acted':>5} {'did not':>7}  {'kind':<16} template"]
    for (kind, text, _), (acted, idle, wrong) in sorted(rows.items(), key=lambda row: (row[0][2], -row[1][2])):
        lines.append(f"{wrong:>5} {acted:>5} {idle:>7}  {kind:<16} {text}")
    return lines
