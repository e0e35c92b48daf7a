"""Commands and what their verb governs: 97 of 100 must be right."""

from pathlib import Path
from typing import List, Tuple

import pytest

from stanford_parser_ros.model import Parser, shipped_model_dir
from stanford_parser_ros.stanford_dependencies import arcs

NEEDED = 0.97
Row = Tuple[str, str, Tuple[Tuple[str, str], ...]]


def rows() -> List[Row]:
    """Text, lemma of the verb, and (relation, word) pairs, each row in its three spellings."""
    found: List[Row] = []
    for line in (Path(__file__).parent / "commands.tsv").read_text(encoding="utf-8").splitlines():
        if line.startswith("#") or not line:
            continue
        text, verb, *rest = line.split("\t")
        pairs = tuple((pair.split(":")[0], pair.split(":")[1]) for pair in (rest[0].split() if rest else []))
        for spelling in (text, text.lower(), text.lower().rstrip(".?").replace(",", "")):
            found.append((spelling, verb, pairs))
    return found


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser(model_dir=shipped_model_dir())


def fault(parser: Parser, row: Row) -> str:
    """Return what is wrong with the parse of a row, empty for nothing."""
    text, verb, pairs = row
    tree = parser.parse(text, frozenset([verb]))
    (root, *_) = tree.children(0)
    if root.form.lower() != verb and root.lemma.lower() != verb:
        return f"{text!r}: the verb is {root.form!r}"
    found = {
        (name, tree.word(arc.dependent).form.lower())
        for arc in arcs(tree)
        if arc.governor == root.index
        for name in arc.relations
    }
    missing = [f"{relation}:{word}" for relation, word in pairs if (relation, word.lower()) not in found]
    return f"{text!r}: misses {', '.join(missing)}" if missing else ""


def test_commands_are_right(parser: Parser, capsys: pytest.CaptureFixture) -> None:
    table = rows()
    assert len(table) >= 300
    faults = [found for found in (fault(parser, row) for row in table) if found]
    with capsys.disabled():
        print(
            f"\n{len(table) - len(faults)} of {len(table)} commands right" + "".join(f"\n  {found}" for found in faults)
        )
    assert len(faults) <= (1.0 - NEEDED) * len(table), "\n".join(faults)
