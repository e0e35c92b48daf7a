"""The names of relations, as the message documents them."""

import re
from pathlib import Path

from typed_arguments.relation_names import RELATIONS

ARCHITECTURE = Path(__file__).resolve().parents[4] / "docs" / "architecture.md"


def test_documented_relations_may_be_declared() -> None:
    row = re.search(r"^\| `relation` \| ([^|]*)\|$", ARCHITECTURE.read_text(encoding="utf-8"), re.MULTILINE)
    assert row is not None
    documented = {word.strip() for word in row[1].partition(";")[0].split(",")}
    assert documented <= RELATIONS
