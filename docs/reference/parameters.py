"""The parameters of the nodes, from the classes that declare them."""

import importlib
import re
import textwrap
from pathlib import Path
from typing import Dict, List, Tuple, Type

from roboframenet_ros.parameters import DeclaredParameter, Parameters, declared_parameters

_CLASS = re.compile(r"^class (\w+)\([\w, ]*\bParameters\b[\w, ]*\):", re.MULTILINE)
_ATTRIBUTE = re.compile(r"(?m)^(\w+(?:, \w+)*): ")


def classes_of(package: Path) -> List[Type[Parameters]]:
    """Return the classes of a package that declare parameters; imports their modules."""
    found: List[Type[Parameters]] = []
    for path in sorted((package / "src" / package.name).glob("**/*.py")):
        names = _CLASS.findall(path.read_text(encoding="utf-8"))
        if names:
            module = importlib.import_module(".".join(path.relative_to(package / "src").with_suffix("").parts))
            found += [getattr(module, name) for name in names]
    return found


def meanings_of(kind: Type[Parameters]) -> Dict[str, str]:
    """Return what the docstring of a class says of each attribute."""
    _, _, text = textwrap.dedent((kind.__doc__ or "").partition("\n")[2]).partition("Attributes:\n")
    block = re.split(r"\n\s*\n|\n(?=\S)", text)[0]
    parts = _ATTRIBUTE.split(textwrap.dedent(block))
    found: Dict[str, str] = {}
    for names, meaning in zip(parts[1::2], parts[2::2]):
        found.update(dict.fromkeys(names.split(", "), " ".join(meaning.split())))
    return found


def shown(value: object) -> str:
    """Return a value as a person would set it."""
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, tuple):
        return f"[{', '.join(value)}]"
    return f"{value:g}" if isinstance(value, float) else str(value) or "''"


def rows_of(kind: Type[Parameters]) -> List[Tuple[DeclaredParameter, str]]:
    """Return the parameters of a class, each with its meaning."""
    meanings = meanings_of(kind)
    return [(one, meanings.get(one.name, "")) for one in declared_parameters(kind)]


def table_of(kind: Type[Parameters]) -> str:
    """Return the parameters of a class as a table of reStructuredText."""
    lines = [".. list-table::", "   :header-rows: 1", ""]
    rows = [("parameter", "type", "default", "allowed", "meaning")]
    for one, meaning in rows_of(kind):
        live = "; can be changed while the node runs" if one.is_live else ""
        rows.append((f"``~{one.name}``", one.type, f"``{shown(one.default)}``", one.allowed, f"{meaning}{live}"))
    for row in rows:
        lines += [f"   {'* -' if number == 0 else '  -'} {cell}".rstrip() for number, cell in enumerate(row)]
    return "\n".join(lines) + "\n"
