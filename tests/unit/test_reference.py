"""The reference that ``make docs`` makes has every module and every definition."""

import os
import runpy
from pathlib import Path

REPOSITORY = Path(os.path.realpath(__file__)).parents[2]
PAGES = runpy.run_path(str(REPOSITORY / "docs" / "reference" / "sources.py"))["pages"]()


def test_every_module_is_on_the_page_of_its_package() -> None:
    for path in REPOSITORY.glob("src/*/src/*/*.py"):
        package = path.parent.name
        if path.parents[2].name == package:
            name = package if path.stem == "__init__" else f"{package}.{path.stem}"
            assert f".. automodule:: {name}\n" in PAGES[package]


def test_every_definition_is_there_as_it_is() -> None:
    for suffix in ("msg", "srv", "action"):
        for path in REPOSITORY.glob(f"src/*/{suffix}/*.{suffix}"):
            page = PAGES[path.parents[1].name]
            assert f"\n{path.stem}\n" in page
            assert all(f"   {line}" in page for line in path.read_text(encoding="utf-8").splitlines() if line)
