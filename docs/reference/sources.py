"""Writes the sources of the reference: a page for each package with its parameters, modules and messages.

python3 docs/reference/sources.py build/docs/source
"""

import re
import sys
import textwrap
from pathlib import Path
from typing import Dict, Iterator, List

sys.path.insert(0, str(Path(__file__).resolve().parent))

from parameters import classes_of, table_of

from roboframenet_testing.workspace import packages

#: Folders of definitions, and what they hold.
KINDS = {"msg": "Messages", "srv": "Services", "action": "Actions"}


def titled(title: str, mark: str) -> str:
    """Return a title of reStructuredText."""
    return f"{title}\n{mark * len(title)}\n"


def modules(package: Path) -> List[str]:
    """Return the dotted names of the modules of a package."""
    root = package / "src"
    paths = sorted(root.glob(f"{package.name}/**/*.py"))
    return [".".join(path.relative_to(root).with_suffix("").parts) for path in paths if path.name != "__init__.py"]


def description(package: Path) -> str:
    """Return the description of a package."""
    found = re.search(
        r"<description>(.*?)</description>", (package / "package.xml").read_text(encoding="utf-8"), re.DOTALL
    )
    return " ".join(found.group(1).split()) if found else ""


def page_of(package: Path) -> str:
    """Return the page of a package: parameters, modules, and definitions of messages as they are; empty without all."""
    names = modules(package)
    kinds = classes_of(package)
    parts = [titled("Parameters", "-")] if kinds else []
    for kind in kinds:
        summary = (kind.__doc__ or "").partition("\n")[0]
        parts.append(f"{titled(f'{kind.__module__}.{kind.__name__}', '~')}\n{summary}\n\n{table_of(kind)}")
    parts += [f"{titled(name, '-')}\n.. automodule:: {name}\n" for name in names]
    for folder, title in KINDS.items():
        paths = sorted(package.glob(f"{folder}/*.{folder}"))
        if paths:
            parts.append(titled(title, "-"))
        for path in paths:
            text = textwrap.indent(path.read_text(encoding="utf-8"), "   ")
            parts.append(f"{titled(path.stem, '~')}\n.. code-block:: none\n\n{text}\n")
    if not parts:
        return ""
    start = [titled(package.name, "="), description(package), ""]
    return "\n".join(start + ([f".. automodule:: {package.name}\n"] if names else []) + parts)


def pages() -> Dict[str, str]:
    """Return the text of each page by its name."""
    found = {name: page_of(folder) for name, folder in packages().items()}
    return {name: text for name, text in found.items() if text}


def index(names: Iterator[str]) -> str:
    """Return the first page."""
    lines = [titled("RoboFrameNet", "="), "Modules, messages, services and actions of each package.", ""]
    lines += [".. toctree::", "   :maxdepth: 1", "", *(f"   {name}" for name in names)]
    return "\n".join(lines) + "\n"


def main() -> None:
    """Write the pages into the folder that is given."""
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    found = pages()
    for name, text in found.items():
        (folder / f"{name}.rst").write_text(text, encoding="utf-8")
    (folder / "index.rst").write_text(index(iter(found)), encoding="utf-8")


if __name__ == "__main__":
    main()
