"""``rfn score mood``: how many sentences of the mood matrix get the right answer, by row and by domain.

The rows 4, 9, 11, 13, 16, 19, 21 and 24 are for scoring, and frozen: nobody looks at their sentences while writing
rules of understanding. Their score is printed; their failing sentences are not, unless ``--open-frozen`` is given. That
is for whoever checks that their English and their answers are right.
"""

import argparse
import hashlib
import json
import sys
from collections import Counter
from pathlib import Path
from typing import Callable, Dict, Iterable, List, Optional, Sequence, Tuple
from typing import Counter as CounterOf

from mood_matrix.constructions import FROZEN, ROWS, Sentence, sentences_of
from mood_matrix.judging import Judge, Judged, Verdict
from mood_matrix.units import load_frames, load_served, load_units
from offline_pipeline.pipeline import Pipeline

NAME = "mood"
TITLE = "the mood matrix: each verb of the domains in 24 constructions"
#: Verdicts that are counted as failures in their order, the worst first.
_FAILURES = (Verdict.ACTED, Verdict.ANSWERED, Verdict.ASKED, Verdict.REFUSED)


def add_mood_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments that only the mood matrix has."""
    parser.add_argument(
        "--row", type=int, action="append", default=[], metavar="N", help=f"{NAME}: only this row (may be repeated)"
    )
    parser.add_argument(
        "--domain", action="append", default=[], metavar="D", help=f"{NAME}: only this domain (may be repeated)"
    )
    parser.add_argument(
        "--open-frozen",
        action="store_true",
        help=f"{NAME}: show sentences of the frozen rows too; not for whoever writes rules",
    )


def matrix(folder: Path, *, rows: Iterable[int] = (), domains: Iterable[str] = ()) -> Tuple[Sentence, ...]:
    """Return the sentences of the matrix.

    Args:
        folder: of the domains
        rows: numbers of rows; none for all
        domains: names of domains; none for all
    """
    wanted = frozenset(domains)
    served = load_served(load_frames(folder))
    units = [unit for unit in load_units(folder) if not wanted or unit.domain in wanted]
    return tuple(sentences_of(units, served, rows))


def sample_of(sentences: Sequence[Sentence], count: int, seed: int) -> Tuple[Sentence, ...]:
    """Draw sentences, in their order. With the same seed nearly the same ones are drawn when a unit comes or goes.

    Args:
        sentences: of the matrix
        count: number of sentences; 0 for all
        seed: of the choice
    """
    if not count:
        return tuple(sentences)
    drawn = sorted(sentences, key=lambda one: hashlib.sha256(f"{seed} {one.text}".encode()).digest())[:count]
    chosen = frozenset(one.text for one in drawn)
    return tuple(one for one in sentences if one.text in chosen)


def run_mood(arguments: argparse.Namespace, pipeline: Pipeline, folder: Path) -> int:
    """Score the matrix; return the exit status."""
    numbers = {row.number for row in ROWS}
    if unknown := [row for row in arguments.row if row not in numbers]:
        print(f"rfn score: the matrix has rows 1 to {max(numbers)}, not {unknown[0]}", file=sys.stderr)
        return 2
    sentences = matrix(folder, rows=arguments.row, domains=arguments.domain)
    if not sentences:
        print("rfn score: no sentence of the matrix is in these rows and domains", file=sys.stderr)
        return 2
    judge = Judge(pipeline, load_served(load_frames(folder)))
    judged = [judge.judge(sentence) for sentence in sample_of(sentences, arguments.sample, arguments.seed)]
    shown = [one for one in judged if arguments.open_frozen or not one.sentence.is_frozen]
    if arguments.wrong:
        with open(arguments.wrong, "w", encoding="utf-8") as file:
            file.writelines(f"{_line(one)}\n" for one in _failing(shown))
    if arguments.json:
        print(json.dumps({"sentences": len(judged), "rows": to_json(judged, lambda one: str(one.sentence.row))}))
        return 0
    print("\n".join([*row_table(judged), "", *domain_table(judged), "", *total_table(judged)]))
    if arguments.failures:
        print("\n".join(["", *cause_table(shown), "", *map(_line, _failing(shown))]))
        if len(shown) < len(judged):
            print("(rows for scoring are not shown)")
    return 0


def _failing(judged: Iterable[Judged]) -> List[Judged]:
    failing = [one for one in judged if one.verdict is not Verdict.RIGHT]
    return sorted(failing, key=lambda one: (one.sentence.row, _FAILURES.index(one.verdict)))


def _line(judged: Judged) -> str:
    said = judged.sentence
    wanted = f"{said.expected.outcome.value}: {said.expected.deed.frame}"
    return f"{said.row}\t{judged.verdict.value}\t{said.text}\t{wanted}\t{judged.cause}\t{judged.reply}"


def counts_by(judged: Iterable[Judged], key: Callable[[Judged], str]) -> Dict[str, CounterOf[Verdict]]:
    """Count the verdicts of each group."""
    found: Dict[str, CounterOf[Verdict]] = {}
    for one in judged:
        found.setdefault(key(one), Counter())[one.verdict] += 1
    return found


def to_json(judged: Iterable[Judged], key: Callable[[Judged], str]) -> Dict[str, Dict[str, int]]:
    """Return the counts of each group under the names of the verdicts."""
    return {
        name: {verdict.value: counts[verdict] for verdict in Verdict} for name, counts in counts_by(judged, key).items()
    }


def share_right(judged: Sequence[Judged]) -> float:
    """Return the share of right answers in percent."""
    return 100.0 * sum(one.verdict is Verdict.RIGHT for one in judged) / max(1, len(judged))


def row_table(judged: Sequence[Judged]) -> List[str]:
    """Return the table by row; frozen rows are marked."""
    counts = counts_by(judged, lambda one: str(one.sentence.row))
    lines = [_head("row")]
    for row in ROWS:
        if str(row.number) in counts:
            mark = "*" if row.number in FROZEN else " "
            lines.append(_counts(f"{row.number:>2}{mark} {row.title}", counts[str(row.number)]))
    return [*lines, "* for scoring: nobody reads the sentences of these rows while writing rules"]


def domain_table(judged: Sequence[Judged]) -> List[str]:
    """Return the table by domain."""
    counts = counts_by(judged, lambda one: one.sentence.domain)
    return [_head("domain"), *(_counts(name, counts[name]) for name in sorted(counts))]


def total_table(judged: Sequence[Judged]) -> List[str]:
    """Return the totals: all rows, those that rules are written for, and the frozen third."""
    lines = [_head("rows")]
    groups: Tuple[Tuple[str, Optional[bool]], ...] = (("all", None), ("open", False), ("frozen third", True))
    for name, is_frozen in groups:
        chosen = [one for one in judged if is_frozen in (None, one.sentence.is_frozen)]
        if chosen:
            lines.append(_counts(name, Counter(one.verdict for one in chosen)))
    return lines


def cause_table(judged: Iterable[Judged], most: int = 3) -> List[str]:
    """Return the most frequent causes of failure of each row."""
    causes: Dict[int, CounterOf[Tuple[str, str]]] = {}
    for one in judged:
        if one.verdict is not Verdict.RIGHT:
            causes.setdefault(one.sentence.row, Counter())[(one.verdict.value, one.cause)] += 1
    return [
        f"{row:>3} {count:>5}  {verdict}: {cause}"
        for row in sorted(causes)
        for (verdict, cause), count in causes[row].most_common(most)
    ]


def _head(name: str) -> str:
    return f"{name:<54}{'sentences':>10}{'right':>7}{'%':>7}{'asked':>7}{'refused':>9}{'answered':>10}{'acted':>7}"


def _counts(name: str, counts: CounterOf[Verdict]) -> str:
    total = sum(counts.values())
    right = counts[Verdict.RIGHT]
    others = (counts[Verdict.ASKED], counts[Verdict.REFUSED], counts[Verdict.ANSWERED], counts[Verdict.ACTED])
    asked, refused, answered, acted = others
    share = f"{100.0 * right / total:.1f}"
    return f"{name:<54}{total:>10}{right:>7}{share:>7}{asked:>7}{refused:>9}{answered:>10}{acted:>7}"
