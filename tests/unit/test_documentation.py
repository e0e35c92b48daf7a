"""The tables in READMEs and docs/architecture.md agree with the code."""

import ast
import re
from functools import lru_cache
from pathlib import Path
from typing import Dict, List, Set, Tuple

import pytest
from catkin_pkg.changelog import get_changelog_from_path

from roboframenet_testing.workspace import REPOSITORY, module_and_rest, module_name, modules, package, packages

PACKAGES = list(packages().values())
WITH_CODE = [package for package in PACKAGES if list(package.glob("src/*/*.py"))]


@lru_cache(maxsize=None)
def tree_of(path: Path) -> ast.Module:
    """Return the syntax tree of a module. Several tests walk through it."""
    return ast.parse(path.read_text(encoding="utf-8"))


def holds(path: Path, *words: str) -> bool:
    """Return whether a module holds one of some words: only such a module is parsed."""
    text = path.read_text(encoding="utf-8")
    return any(word in text for word in words)


def declared_parameters() -> Dict[str, Set[str]]:
    """Return the parameters that each module declares as fields of a class of `Parameters`, by module and class."""
    found: Dict[str, Set[str]] = {}
    for module, path in modules().items():
        for node in ast.walk(tree_of(path)) if holds(path, "Parameters)") else ():
            if isinstance(node, ast.ClassDef) and any(getattr(base, "id", "") == "Parameters" for base in node.bases):
                found[f"{module}.{node.name}"] = {
                    f"~{field.target.id}"
                    for field in node.body
                    if isinstance(field, ast.AnnAssign)
                    and isinstance(field.target, ast.Name)
                    and isinstance(field.value, ast.Call)
                    and getattr(field.value.func, "id", "") == "parameter"
                }
    return found


DECLARED = declared_parameters()


def parameters_read_by_class(path: Path) -> Set[str]:
    """Return the parameters of the classes that a module passes to `read_parameters`."""
    tree = tree_of(path)
    origins = {
        alias.asname or alias.name: f"{node.module}.{alias.name}"
        for node in ast.walk(tree)
        if isinstance(node, ast.ImportFrom)
        for alias in node.names
    }
    names: Set[str] = set()
    for node in ast.walk(tree):
        if (
            isinstance(node, ast.Call)
            and getattr(node.func, "id", "") == "read_parameters"
            and not any(is_prefix_of_another_node(keyword) for keyword in node.keywords)
        ):
            kind = getattr(node.args[0], "id", "")
            names |= DECLARED[origins.get(kind, f"{module_name(path)}.{kind}")]
    return names


def is_prefix_of_another_node(keyword: ast.keyword) -> bool:
    """Whether an argument says that the parameters are those of another node."""
    return keyword.arg == "prefix" and isinstance(keyword.value, ast.Constant) and keyword.value.value != "~"


def parameters_in_code(package: Path) -> Set[str]:
    """Return the private parameters that a package reads, by a class or by a literal that begins with '~'."""
    names: Set[str] = set()
    for path in package.glob("src/**/*.py"):
        names |= parameters_read_by_class(path) if holds(path, "read_parameters") else set()
        for node in ast.walk(tree_of(path)) if holds(path, '"~') else ():
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
    """Return the names that begin with '~' in the first column of the README's tables."""
    text = (package / "README.md").read_text(encoding="utf-8")
    return set(re.findall(r"^\| `(~\w+)`", text, re.MULTILINE))


@pytest.mark.parametrize("package", WITH_CODE, ids=lambda package: package.name)
def test_readme_lists_every_parameter(package: Path) -> None:
    undocumented = {name for name in parameters_in_code(package) if not is_internal(name)} - parameters_in_readme(
        package
    )
    assert not undocumented


@pytest.mark.parametrize("package", WITH_CODE, ids=lambda package: package.name)
def test_readme_lists_no_removed_parameter(package: Path) -> None:
    sources = list(package.glob("src/**/*.py")) + list(package.glob("cfg/*"))
    code = "\n".join(path.read_text(encoding="utf-8") for path in sources)
    read = parameters_in_code(package)
    assert not {
        name
        for name in parameters_in_readme(package)
        if name not in read and name not in code and f'"{name[1:]}"' not in code
    }


def test_parameters_of_a_class_are_found() -> None:
    found = parameters_in_code(package("executor"))
    assert {"~acceptance_timeout_s", "~max_clients", "~introspection"} <= found
    assert "~zero_velocity_rate_hz" in parameters_in_code(package("stop_server"))


#: Calls that open a topic, a service or an action; their first literal argument is its name.
OPENERS = {"Publisher", "Subscriber", "Service", "ServiceProxy", "ActionClient", "RFNServer"}


def names_in_code(package: Path) -> Set[str]:
    """Return the topics, services and actions that a package opens by a literal name."""
    names: Set[str] = set()
    for path in package.glob("src/**/*.py"):
        for node in ast.walk(tree_of(path)) if holds(path, *OPENERS) else ():
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
    """Whether a node writes the parameter itself, to keep values across restarts."""
    return name.startswith("~_")


@pytest.mark.parametrize("package", PACKAGES, ids=lambda package: package.name)
def test_table_of_packages_names_the_package(package: Path) -> None:
    assert f"(../{package.relative_to(REPOSITORY)})" in (REPOSITORY / "docs" / "packages.md").read_text(
        encoding="utf-8"
    )


def test_metapackage_depends_on_all_packages() -> None:
    text = (package("roboframenet") / "package.xml").read_text(encoding="utf-8")
    wanted = {package.name for package in PACKAGES} - {"roboframenet", "roboframenet_testing"}
    assert set(re.findall(r"<exec_depend>(\w+)<", text)) == wanted


def test_packages_have_one_version_and_an_author() -> None:
    texts = [
        (path / "package.xml").read_text(encoding="utf-8") for path in packages("src", "underlay", "tests").values()
    ]
    (version,) = {found for text in texts for found in re.findall(r"<version>(.*)</version>", text)}
    assert f"version: {version}\n" in (REPOSITORY / "CITATION.cff").read_text(encoding="utf-8")
    assert f"Version {version} " in (REPOSITORY / "README.md").read_text(encoding="utf-8")
    assert f"\n## {version} (" in (REPOSITORY / "CHANGELOG.md").read_text(encoding="utf-8")
    assert (REPOSITORY / "docs" / "releases" / f"{version}.md").exists()
    assert all("<author>" in text and "<url" in text for text in texts)


@pytest.mark.parametrize("package", list(packages("src", "underlay").values()), ids=lambda package: package.name)
def test_package_has_a_changelog(package: Path) -> None:
    text = (package / "CHANGELOG.rst").read_text(encoding="utf-8")
    assert f"Changelog for package {package.name}" in text
    log = get_changelog_from_path(str(package / "CHANGELOG.rst"))
    versions = [version for version, _, _ in log.foreach_version()]
    manifest = (package / "package.xml").read_text(encoding="utf-8")
    # REP 132: the last release stands first, below what is new; a new package has none.
    assert versions or "\nForthcoming\n-----------\n* " in text
    assert not versions or f"<version>{versions[0]}</version>" in manifest


PAGES = [path for pattern in ("*.md", "docs/**/*.md", "src/**/README.md") for path in REPOSITORY.glob(pattern)]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(REPOSITORY)))
def test_links_of_a_page_exist(page: Path) -> None:
    links = re.findall(r"\]\((?!https?:)([^)#]+)", page.read_text(encoding="utf-8"))
    assert not [link for link in links if not (page.parent / link).exists()]


MESSAGES = package("roboframenet_msgs")


def interface_files() -> Dict[str, Path]:
    """Return the files of roboframenet_msgs by their names in its README: message names; an action keeps its suffix."""
    paths = sorted(path for folder in ("msg", "srv", "action") for path in MESSAGES.glob(f"{folder}/*.*"))
    return {path.name if path.suffix == ".action" else path.stem: path for path in paths}


def interface_rows() -> List[Tuple[str, str, List[str], str]]:
    """Return name, owner, the columns in between and the meaning of each row of the README."""
    rows = []
    for line in (MESSAGES / "README.md").read_text(encoding="utf-8").splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if re.match(r"`\w+(\.action)?`$", cells[0]):
            rows.append((cells[0].strip("`"), cells[1], cells[2:-1], cells[-1]))
    return rows


def says(path: Path, name: str) -> bool:
    return re.search(rf"\b{name}\b", path.read_text(encoding="utf-8")) is not None


def test_readme_lists_every_message_service_and_action_once() -> None:
    names = [name for name, _, _, _ in interface_rows()]
    assert sorted(names) == sorted(interface_files())


@pytest.mark.parametrize("row", interface_rows(), ids=lambda row: row[0])
def test_row_of_an_interface_is_true(row: Tuple[str, str, List[str], str]) -> None:
    name, whose, columns, meaning = row
    published = (REPOSITORY / "tests" / "unit" / "test_interfaces_2012.py").read_text(encoding="utf-8")
    bare = name.split(".")[0] + ("Action" if name.endswith(".action") else "")
    assert whose == ("2012" if f'"{bare}"' in published else "ours")
    assert meaning
    for other in re.findall(r"`([\w.]+)`", " ".join(columns)):
        if other in interface_files():
            assert says(interface_files()[other], name), f"{other} has no {name}"
        else:
            saying = [path for path in package(other).glob("src/**/*.py") if says(path, bare)]
            assert saying, f"{other} does not say {name}"


#: Tables of these sections of docs/architecture.md name our modules and their definitions.
SECTIONS_WITH_MODULES = (
    "From a sentence to readings",
    "From readings to goals",
    "Where a command ends",
    "Where is X done?",
)


def modules_in_architecture() -> List[str]:
    """Return the dotted names in the tables of these sections, package first."""
    text = (REPOSITORY / "docs" / "architecture.md").read_text(encoding="utf-8")
    rows = []
    for section in re.split(r"^## ", text, flags=re.MULTILINE):
        if section.splitlines()[0] in SECTIONS_WITH_MODULES:
            rows += [line for line in section.splitlines() if line.startswith("|")]
    packages = "|".join(package.name for package in WITH_CODE)
    return sorted(set(re.findall(rf"`((?:{packages})\.\w[\w.]*)`", "\n".join(rows))))


def defined_names(path: Path) -> Set[str]:
    """Return the functions, classes and constants of a module, and the methods of its classes as ``Class.method``."""
    names: Set[str] = set()
    for node in tree_of(path).body:
        if isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            names.add(node.name)
        if isinstance(node, ast.ClassDef):
            names.update(f"{node.name}.{inner.name}" for inner in node.body if isinstance(inner, ast.FunctionDef))
        if isinstance(node, ast.Assign):
            names.update(target.id for target in node.targets if isinstance(target, ast.Name))
        if isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            names.add(node.target.id)
    return names


def test_architecture_names_many_modules() -> None:
    assert len(modules_in_architecture()) > 30


@pytest.mark.parametrize("name", modules_in_architecture())
def test_names_in_architecture_exist(name: str) -> None:
    path, inner = module_and_rest(name)
    assert not inner or inner in defined_names(path)
