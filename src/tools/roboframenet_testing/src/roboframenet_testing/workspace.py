"""Where the packages of this workspace stand: found by their package.xml, whatever folders they are grouped in."""

import ast
import os
from functools import lru_cache
from pathlib import Path
from typing import Dict, FrozenSet, List, Set, Tuple

#: The folder into which this workspace was cloned.
REPOSITORY = next(one for one in Path(os.path.realpath(__file__)).parents if (one / "pytest.ini").is_file())


@lru_cache(maxsize=None)
def packages(*folders: str) -> Dict[str, Path]:
    """Return the folders of the packages below some folders of the workspace, by name; without any, those in src."""
    found: List[Path] = []
    for folder in folders or ("src",):
        for path, below, files in os.walk(REPOSITORY / folder):
            if "package.xml" in files:
                found.append(Path(path))
                below.clear()
    return {path.name: path for path in sorted(found, key=lambda path: path.name)}


def package(name: str) -> Path:
    """Return the folder of a package in src."""
    return packages()[name]


@lru_cache(maxsize=None)
def modules() -> Dict[str, Path]:
    """Return the modules of the packages in src by their dotted names, without tests; a folder is its ``__init__``."""
    found: Dict[str, Path] = {}
    for folder in packages().values():
        for path in sorted(folder.glob("src/**/*.py")):
            parts = path.relative_to(folder / "src").with_suffix("").parts
            found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    return found


def imports(path: Path) -> FrozenSet[str]:
    """Return the dotted names that a module imports, also inside functions: "os", and "typing" and "typing.Set"."""
    return _imports_in(path.read_text(encoding="utf-8"))


@lru_cache(maxsize=None)
def _imports_in(text: str) -> FrozenSet[str]:
    names: Set[str] = set()
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            names.update(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.level == 0 and node.module:
            names.update({node.module} | {f"{node.module}.{alias.name}" for alias in node.names})
    return frozenset(names)


def module_name(path: Path) -> str:
    """Return the dotted name of a module of ours, by its path."""
    return next(name for name, one in modules().items() if one == path)


def package_name(path: Path) -> str:
    """Return the name of the package that a file belongs to."""
    return next(one.name for one in path.parents if (one / "package.xml").is_file())


def module_and_rest(name: str) -> Tuple[Path, str]:
    """Return the module that a dotted name begins with, and the names inside it; "" for none.

    Raises:
        KeyError: there is no such module
    """
    parts = name.split(".")
    for end in range(len(parts), 1, -1):
        path = modules().get(".".join(parts[:end]))
        if path is not None and path.name != "__init__.py":
            return path, ".".join(parts[end:])
    raise KeyError(name)
