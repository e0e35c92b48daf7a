"""The names of relations and quantifiers, as the architecture documents them."""

import re
from pathlib import Path
from typing import FrozenSet

import pytest

from typed_arguments.attribute_names import QUANTIFIERS, RELATIONS

REPOSITORY = next(one for one in Path(__file__).resolve().parents if (one / "pytest.ini").is_file())
ARCHITECTURE = REPOSITORY / "docs" / "architecture.md"


@pytest.mark.parametrize("attribute, names", [("relation", RELATIONS), ("quantifier", QUANTIFIERS)])
def test_documented_names_may_be_declared(attribute: str, names: FrozenSet[str]) -> None:
    row = re.search(rf"^\| `{attribute}` \| ([^|]*)\|$", ARCHITECTURE.read_text(encoding="utf-8"), re.MULTILINE)
    assert row is not None
    documented = {word.strip() for word in row[1].partition(";")[0].split(",")}
    assert documented <= names
