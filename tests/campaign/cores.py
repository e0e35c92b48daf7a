"""Demands on the cores, without ROS: odd words, odd files, amounts, policies."""

import random
import time
from contextlib import AbstractContextManager, nullcontext
from pathlib import Path
from typing import Any, Dict, List, Sequence

from .demand import Demand, Figure, Trial, at_most, none_of, values
from .words import malformed, odd_text, yaml_texts


class OddWords(Demand):
    """R1 in one process."""

    name, title = "R1", "odd utterances, through parser, framer and registrar"
    counts = (300, 10000, 10000)

    def running(self) -> "AbstractContextManager[object]":
        """Load the models and the shipped domains."""
        from offline_pipeline.knowledge import load_knowledge, pretend_servers, shipped_domains
        from offline_pipeline.pipeline import Pipeline

        knowledge = load_knowledge([shipped_domains()])
        pretend_servers(knowledge.graph)
        self._pipeline = Pipeline(knowledge)
        self._examples = [example.text for unit in knowledge.lexicon.units for example in unit.examples]
        return nullcontext()

    def trial(self, number: int, chance: random.Random) -> Dict[str, Any]:
        """Understand one."""
        text = odd_text(self._examples, chance)
        begin_s = time.perf_counter()
        understood = self._pipeline.understand(text)
        return {
            "text": text[:200],
            "code": understood.reply.code,
            "silent": int(not understood.reply.sentence),
            "s": time.perf_counter() - begin_s,
        }

    def figures(self, trials: Sequence[Trial]) -> List[Figure]:
        """A reply each; what breaks has a line of its own."""
        return [none_of("without a sentence", trials, "silent"), at_most("time", trials, "s", 10.0)]


class WrongFiles(Demand):
    """R3."""

    name, title = "R3", "malformed frame and lexical unit files"
    counts = (200, 2000, 10000)

    def running(self) -> "AbstractContextManager[object]":
        """Read the shipped files."""
        from offline_pipeline.knowledge import shipped_domains

        self._frames, self._units = yaml_texts(Path(shipped_domains()))
        return nullcontext()

    def trial(self, number: int, chance: random.Random) -> Dict[str, Any]:
        """Read one file, as the nodes do."""
        import tempfile

        from checked_files.source_files import read_text
        from semantic_frames import FileRefused, load_frame, load_lexical_units

        is_frame = chance.random() < 0.5
        content = malformed(chance.choice(self._frames if is_frame else self._units), chance)
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "odd.yaml"
            path.write_bytes(content)
            begin_s = time.perf_counter()
            try:
                text = read_text(str(path))
                if is_frame:
                    load_frame(text, str(path))
                else:
                    load_lexical_units(text, str(path))
                problems: Sequence[Any] = ()
            except FileRefused as refused:
                problems = refused.problems
            took_s = time.perf_counter() - begin_s
        return {
            "refused": int(bool(problems)),
            "vague": sum(not (problem.code and problem.path and problem.expected) for problem in problems),
            "many": int(len(problems) > 50),
            "s": took_s,
        }

    def figures(self, trials: Sequence[Trial]) -> List[Figure]:
        """Refused with file and expectation, quickly; a traceback has a line of its own."""
        return [
            Figure("refused", f"{int(sum(values(trials, 'refused')))} of {len(trials)}"),
            none_of("problems without code, file or expectation", trials, "vague"),
            none_of("files with more than 50 problems told", trials, "many"),
            at_most("time", trials, "s", 1.0),
        ]


class Amounts(Demand):
    """R15."""

    name, title = "R15", "numbers, units and spellings: what the base would do"
    counts = (500, 10000, 10000)

    def running(self) -> "AbstractContextManager[object]":
        """Load the judge."""
        from spoken_amounts.judging import Judge

        self._judge = Judge()
        return nullcontext()

    def trial(self, number: int, chance: random.Random) -> Dict[str, Any]:
        """Judge one sentence."""
        from spoken_amounts.phrases import generate

        (phrase,) = generate(1, chance.randrange(10**9))
        verdict = self._judge.verdict(phrase, "strict")
        is_plain = phrase.motions is not None and phrase.is_within_limits
        return {
            "text": phrase.text,
            "wrong": int(verdict.outcome == "wrong"),
            "plain": int(is_plain),
            "right": int(is_plain and verdict.outcome == "right"),
        }

    def figures(self, trials: Sequence[Trial]) -> List[Figure]:
        """Never wrong."""
        plain, right = sum(values(trials, "plain")), sum(values(trials, "right"))
        wrong = [str(trial["text"]) for trial in trials if trial["wrong"]]
        return [
            none_of("wrong", trials, "wrong"),
            Figure("right, of those that can be read", f"{int(right)} of {int(plain)}"),
            *([Figure("wrong ones", "; ".join(wrong[:5]), "none", False)] if wrong else []),
        ]


class Policies(Demand):
    """R16."""

    name, title = "R16", "policies: the same seed, the same order; random is fair"
    counts = (200, 1000, 10000)
    #: Quantile 0.999 of chi-square with three degrees of freedom.
    _CHI_SQUARE = 16.27

    def trial(self, number: int, chance: random.Random) -> Dict[str, Any]:
        """Order four candidates twice by each policy."""
        from arbitrator.plan import Candidate
        from arbitrator.policy import POLICIES, load_policy, order
        from typed_arguments import FilledFrame

        candidates = [Candidate((FilledFrame(f"way_{way}", server="server"),)) for way in range(4)]
        seed = chance.randrange(10**9)
        different, first = 0, 0
        for name in POLICIES:
            orders = [order(candidates, load_policy(name, seed=seed)) for _ in range(2)]
            different += int(orders[0] != orders[1])
            if name == "random":
                first = candidates.index(orders[0][0])
        return {"different": different, "first": first}

    def figures(self, trials: Sequence[Trial]) -> List[Figure]:
        """Chi-square of which candidate came first."""
        expected = len(trials) / 4.0
        counts = [sum(trial["first"] == way for trial in trials) for way in range(4)]
        chi_square = sum((count - expected) ** 2 / expected for count in counts)
        return [
            none_of("different orders for one seed", trials, "different"),
            Figure(
                "first of four, random",
                f"{counts}, chi-square {chi_square:.1f}",
                f"< {self._CHI_SQUARE} (p > 0.001)",
                chi_square < self._CHI_SQUARE,
            ),
        ]
