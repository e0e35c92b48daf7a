"""The tables of parameters in the READMEs say what the code reads, no more and no less."""

import ast
import re
from pathlib import Path
from typing import Set

import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
PACKAGES = sorted(path.parent for path in REPOSITORY.glob("src/*/package.xml"))
WITH_CODE = [package for package in PACKAGES if list(package.glob("src/*/*.py"))]


def parameters_in_code(package: Path) -> Set[str]:
    """Names of the private parameters that a package reads: literals that begin with '~' and are not topics."""
    names: Set[str] = set()
    for path in package.glob("src/**/*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if (
                isinstance(node, ast.Call)
                and getattr(node.func, "attr", getattr(node.func, "id", "")) in READERS
                and node.args
            ):
                argument = node.args[0]
                if (
                    isinstance(argument, ast.Constant)
                    and isinstance(argument.value, str)
                    and argument.value.startswith("~")
                ):
                    names.add(argument.value)
    return names


#: Functions that read a parameter.
READERS = {"get_param", "has_param", "search_param"}


def parameters_in_readme(package: Path) -> Set[str]:
    """Names in the first column of the README's tables that begin with '~'."""
    text = (package / "README.md").read_text(encoding="utf-8")
    return set(re.findall(r"^\| `(~\w+)`", text, re.MULTILINE))


@pytest.mark.parametrize("package", WITH_CODE, ids=lambda package: package.name)
def test_readme_lists_every_parameter(package: Path) -> None:
    undocumented = {name for name in parameters_in_code(package) if not is_internal(name)} - parameters_in_readme(
        package
    )
    assert not undocumented


@pytest.mark.parametrize("package", WITH_CODE, ids=lambda package: package.name)
def test_readme_lists_no_parameter_that_is_gone(package: Path) -> None:
    sources = list(package.glob("src/**/*.py")) + list(package.glob("cfg/*"))
    code = "\n".join(path.read_text(encoding="utf-8") for path in sources)
    assert not {name for name in parameters_in_readme(package) if name not in code and f'"{name[1:]}"' not in code}


#: Calls that open a topic, a service or an action; their first literal argument is its name.
OPENERS = {"Publisher", "Subscriber", "Service", "ServiceProxy", "ActionClient", "RFNServer"}


def names_in_code(package: Path) -> Set[str]:
    """Names of topics, services and actions that a package opens by a literal name."""
    names: Set[str] = set()
    for path in package.glob("src/**/*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if (
                isinstance(node, ast.Call)
                and getattr(node.func, "attr", getattr(node.func, "id", "")) in OPENERS
                and node.args
            ):
                argument = node.args[0]
                if isinstance(argument, ast.Constant) and isinstance(argument.value, str):
                    names.add(argument.value)
    return names


@pytest.mark.parametrize("package", WITH_CODE, ids=lambda package: package.name)
def test_readme_lists_every_topic_service_and_action(package: Path) -> None:
    text = (package / "README.md").read_text(encoding="utf-8")
    assert not {name for name in names_in_code(package) if f"`{name}`" not in text}


def is_internal(name: str) -> bool:
    """Whether a node keeps the parameter for itself, across its own restarts."""
    return name.startswith("~_")


@pytest.mark.parametrize("package", PACKAGES, ids=lambda package: package.name)
def test_main_readme_names_the_package(package: Path) -> None:
    assert f"src/{package.name})" in (REPOSITORY / "README.md").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    "package", [path.parent for path in REPOSITORY.glob("*/*/package.xml")], ids=lambda package: package.name
)
def test_package_has_a_changelog(package: Path) -> None:
    text = (package / "CHANGELOG.rst").read_text(encoding="utf-8")
    assert "Forthcoming\n-----------" in text and f"Changelog for package {package.name}" in text


def test_links_of_the_main_readme_lead_somewhere() -> None:
    text = (REPOSITORY / "README.md").read_text(encoding="utf-8")
    links = re.findall(r"\]\((?!https?:)([^)#]+)", text)
    assert links and not [link for link in links if not (REPOSITORY / link).exists()]
