"""The reference that ``make docs`` makes has every module, definition and parameter, and READMEs agree with it."""

import re
import runpy
from pathlib import Path
from typing import Dict, List, Tuple

import pytest

from roboframenet_ros.parameters import DeclaredParameter
from roboframenet_testing.workspace import REPOSITORY, modules, packages

FOLDER = REPOSITORY / "docs" / "reference"
PAGES = runpy.run_path(str(FOLDER / "sources.py"))["pages"]()
REFERENCE = runpy.run_path(str(FOLDER / "parameters.py"))
PACKAGES = list(packages().values())
PARAMETERS: Dict[str, List[Tuple[DeclaredParameter, str]]] = {
    package.name: [row for kind in REFERENCE["classes_of"](package) for row in REFERENCE["rows_of"](kind)]
    for package in PACKAGES
}
#: How READMEs call a type.
TYPES = {"list": "list of strings", "list of strings, or one": "list of strings"}


def test_every_module_is_on_the_page_of_its_package() -> None:
    for name, path in modules().items():
        if path.name != "__init__.py" or "." not in name:
            assert f".. automodule:: {name}\n" in PAGES[name.partition(".")[0]]


def test_every_definition_is_there_as_it_is() -> None:
    for suffix in ("msg", "srv", "action"):
        for package, path in [(one.name, path) for one in PACKAGES for path in one.glob(f"{suffix}/*.{suffix}")]:
            page = PAGES[package]
            assert f"\n{path.stem}\n" in page
            assert all(f"   {line}" in page for line in path.read_text(encoding="utf-8").splitlines() if line)


def test_every_parameter_is_there_with_its_meaning() -> None:
    assert sum(map(len, PARAMETERS.values())) > 100
    for package, rows in PARAMETERS.items():
        assert not [row.name for row, meaning in rows if not meaning], package
        assert all(f"``~{row.name}``" in PAGES[package] for row, _ in rows)


def readme_rows(package: Path) -> Dict[str, Tuple[str, str]]:
    """Return the type and the default of each parameter in the tables of a README."""
    text = (package / "README.md").read_text(encoding="utf-8")
    rows = [[cell.strip(" `") for cell in line.split("|")[1:-1]] for line in re.findall(r"(?m)^\| `~\w+`.*\|$", text)]
    return {row[0][1:]: (TYPES.get(row[1], row[1]), row[2]) for row in rows}


_NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e-?\d+)?")


def is_said(said: str, default: object) -> bool:
    """Whether a README says a default; of lists and texts it may describe what stands for an empty one."""
    if isinstance(default, bool):
        return said == str(default).lower()
    if isinstance(default, (int, float)):
        # Nodes of one package may have defaults of their own: "0.3, tags 0.2".
        return any(float(one) == pytest.approx(default, rel=0.01) for one in _NUMBER.findall(said))
    if isinstance(default, tuple):
        names = said.strip("[]").split(", ")
        return bool(said) and (names == list(default) or " " in said or said in ("empty", "all", *default))
    return said == default or (not default and (said in ("", "empty") or " " in said))


@pytest.mark.parametrize("package", [one for one in PACKAGES if PARAMETERS[one.name]], ids=lambda one: one.name)
def test_readme_says_types_and_defaults_as_they_are(package: Path) -> None:
    said = readme_rows(package)
    rows = [(row, *said[row.name]) for row, _ in PARAMETERS[package.name] if row.name in said]
    assert not [(row.name, row.type, type_) for row, type_, _ in rows if type_ != row.type]
    assert not [(row.name, row.default, text) for row, _, text in rows if not is_said(text, row.default)]
