"""``rfn port``: the one-line change that makes an actionlib server an RFNServer."""

import argparse
import ast
import difflib
import io
import os
import re
import shutil
import sys
import tempfile
import tokenize
from dataclasses import dataclass
from typing import Dict, Iterator, List, Optional, Tuple

EXAMPLES = """examples:
  rfn port scripts/fibonacci_server.py
  rfn port scripts/fibonacci_server.py --apply

It runs nothing of the file, needs no master, and keeps every other character. Exit status: 0 the change is shown (or
made), or the file has only RFNServers; 1 no server is found or the file cannot be read or written; 2 wrong usage
"""
_PORTED_NAMES = {
    "actionlib.SimpleActionServer": "RFNServer",
    "actionlib.simple_action_server.SimpleActionServer": "RFNServer",
    "actionlib.ActionServer": "RFNActionServer",
    "actionlib.action_server.ActionServer": "RFNActionServer",
}
_RFN_NAMES = {
    f"{module}.{name}" for module in ("rfnserver", "rfnserver.rfnserver") for name in ("RFNServer", "RFNActionServer")
}
#: The line ends that Python knows; ``splitlines`` would also split at form feeds and other characters.
_LINE = re.compile(r"[^\r\n]*(?:\r\n|\r|\n)|[^\r\n]+$")


class PortError(ValueError):
    """The file cannot be ported; the text says why, in one sentence."""


class AlreadyPorted(PortError):
    """The file has RFNServers and no other action servers."""


@dataclass(frozen=True)
class Site:
    """A place that names the class of an action server.

    Attributes:
        expression: the text of the place
        name: class of rfnserver that replaces it
        server: expression that holds the server in the program; empty if it is not found
    """

    expression: ast.expr
    name: str
    server: str = ""


@dataclass(frozen=True)
class Ported:
    """A ported source: its text, and the expressions of its servers, each once."""

    text: str
    servers: Tuple[str, ...]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the arguments of ``rfn port``."""
    parser.epilog = EXAMPLES
    parser.add_argument("path", help="Python file with an actionlib server")
    parser.add_argument("--apply", action="store_true", help="make the change")


def run(arguments: argparse.Namespace) -> int:
    """Show the change, and make it if asked; return the exit status."""
    path = arguments.path
    if not os.path.isfile(path):
        print(f"rfn port: there is no file {path}", file=sys.stderr)
        return 2
    try:
        with open(path, "rb") as file:
            source = file.read()
        text, encoding = _decode(source)
        ported = port(text)
        if arguments.apply:
            _replace(path, ported.text.encode(encoding))
    except AlreadyPorted as reason:
        print(f"rfn port: {path}: {reason}")
        return 0
    except (PortError, OSError) as error:
        print(f"rfn port: {path}: {error}", file=sys.stderr)
        return 1
    print(difference(text, ported.text, path), end="")
    print(f"\n{path} is changed." if arguments.apply else "\nNothing is changed yet; --apply makes the change.")
    print("Then register each server for its frames, and name the package in package.xml:")
    for server in ported.servers:
        print(f'    {server}.register_with_frame("frame_name")    # after {server}.start()')
    print("    <exec_depend>rfnserver</exec_depend>")
    print("No frame for it yet? 'rfn new NAME --from-action PACKAGE/NAME.action' writes one, with a lexical unit.")
    return 0


def port(text: str) -> Ported:
    """Return the source with RFNServers instead of its action servers.

    Raises:
        AlreadyPorted: it has only RFNServers
        PortError: it is not Python 3, has no action server, or uses the name rfnserver for something else
    """
    try:
        tree = ast.parse(text)
    except (SyntaxError, ValueError) as error:
        if isinstance(error, SyntaxError) and error.lineno is not None:
            raise PortError(f"line {error.lineno}: this is not Python 3 ({error.msg}); nothing is changed") from error
        # A null byte: an error without a line, of either kind, as Python's version will.
        raise PortError(f"this is no Python source ({error}); nothing is changed") from error
    names = _imported_names(tree)
    sites = sorted(_sites(tree, names), key=lambda site: (site.expression.lineno, site.expression.col_offset))
    if not sites:
        if any(_resolve(node, names) in _RFN_NAMES for node in ast.walk(tree) if isinstance(node, ast.expr)):
            raise AlreadyPorted("its servers are RFNServers already; there is nothing to change")
        raise PortError(
            "it does not make an action server of actionlib; there is nothing to change ('rfn bind' makes a running "
            "server follow commands as it is)"
        )
    lines = _LINE.findall(text)
    module, insert_at = _module_name(tree, sites[0].expression.lineno)
    for site in reversed(sites):
        _put(lines, site.expression, f"{module}.{site.name}")
    if insert_at is not None:
        before = lines[max(0, insert_at - 1)]
        ending = before[len(before.rstrip("\r\n")) :] or "\n"
        lines.insert(insert_at, f"import rfnserver{ending}")
    servers = tuple(dict.fromkeys(site.server for site in sites if site.server)) or ("server",)
    return Ported("".join(lines), servers)


def difference(before: str, after: str, path: str) -> str:
    """Return a unified diff that ``patch`` accepts."""
    lines = difflib.unified_diff(_LINE.findall(before), _LINE.findall(after), path, path)
    return "".join(line if line.endswith(("\n", "\r")) else f"{line}\n\\ No newline at end of file\n" for line in lines)


def _decode(source: bytes) -> Tuple[str, str]:
    """Return the text of a source file, with its own line ends, and its encoding."""
    try:
        encoding, _ = tokenize.detect_encoding(io.BytesIO(source).readline)
        return source.decode(encoding), encoding
    except (SyntaxError, UnicodeDecodeError) as error:
        raise PortError(f"this is no Python source ({error}); nothing is changed") from error


def _replace(path: str, content: bytes) -> None:
    """Write a file in one step and keep its mode; a link stays a link."""
    path = os.path.realpath(path)
    descriptor, new_path = tempfile.mkstemp(dir=os.path.dirname(path), prefix=".rfn_port_")
    try:
        with os.fdopen(descriptor, "wb") as file:
            file.write(content)
        shutil.copymode(path, new_path)
        os.replace(new_path, path)
    except OSError:
        os.unlink(new_path)
        raise


def _imported_names(tree: ast.Module) -> Dict[str, str]:
    """Return the dotted names of the names that the file imports anywhere."""
    names: Dict[str, str] = {}
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            for alias in node.names:
                first = alias.name.split(".")[0]
                names[alias.asname or first] = alias.name if alias.asname else first
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            for alias in node.names:
                if alias.name != "*":
                    names[alias.asname or alias.name] = f"{node.module}.{alias.name}"
                    continue
                for dotted in list(_PORTED_NAMES) + sorted(_RFN_NAMES):
                    if dotted.rpartition(".")[0] == node.module:
                        names[dotted.rpartition(".")[2]] = dotted
    return names


def _dotted(node: Optional[ast.AST]) -> str:
    """Return a name with its attributes, as it is written; empty for any other expression."""
    if isinstance(node, ast.Name):
        return node.id
    if isinstance(node, ast.Attribute):
        value = _dotted(node.value)
        return f"{value}.{node.attr}" if value else ""
    return ""


def _resolve(node: Optional[ast.AST], names: Dict[str, str]) -> str:
    """Return the dotted name of an expression; empty when it is not imported."""
    first, dot, rest = _dotted(node).partition(".")
    return names[first] + dot + rest if first in names else ""


def _sites(tree: ast.Module, names: Dict[str, str]) -> Iterator[Site]:
    """Return every place that uses the class of an action server of actionlib: a call, a base, a default, an alias.

    An annotation and a test of the class stay as they are: they hold for its subclasses as well.
    """
    servers: Dict[ast.AST, str] = {
        node.value: _dotted(node.target if isinstance(node, ast.AnnAssign) else node.targets[0])
        for node in ast.walk(tree)
        if isinstance(node, (ast.Assign, ast.AnnAssign)) and node.value is not None
    }
    made = {node.func: servers.get(node, "") for node in ast.walk(tree) if isinstance(node, ast.Call)}
    bases = {base: "self" for node in ast.walk(tree) if isinstance(node, ast.ClassDef) for base in node.bases}
    kept = {id(inner) for told in _class_tests(tree) for inner in ast.walk(told)}
    for node in ast.walk(tree):
        name = _PORTED_NAMES.get(_resolve(node, names))
        if name is not None and isinstance(node, ast.expr) and id(node) not in kept:
            yield Site(node, name, made.get(node) or bases.get(node, ""))


def _class_tests(tree: ast.Module) -> Iterator[ast.expr]:
    """Return the annotations, and the calls of ``isinstance`` and ``issubclass``."""
    for node in ast.walk(tree):
        if isinstance(node, (ast.AnnAssign, ast.arg)) and node.annotation is not None:
            yield node.annotation
        elif isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)) and node.returns is not None:
            yield node.returns
        elif isinstance(node, ast.Call) and _dotted(node.func) in ("isinstance", "issubclass"):
            yield node


def _module_name(tree: ast.Module, first_line: int) -> Tuple[str, Optional[int]]:
    """Return the name of the module rfnserver before a line, and the place for its import (None when it is imported).

    The place is the number of lines before it.
    """
    place = 0
    for position, node in enumerate(tree.body):
        start = min([node.lineno] + [decorator.lineno for decorator in getattr(node, "decorator_list", ())])
        if start >= first_line:
            break
        if isinstance(node, ast.Import):
            for alias in node.names:
                if alias.name == "rfnserver" or (alias.name.startswith("rfnserver.") and not alias.asname):
                    return alias.asname or "rfnserver", None
        is_docstring = position == 0 and ast.get_docstring(tree) is not None
        # Statements on the line of an import ("import roslib; roslib.load_manifest(...)") belong to the import.
        if is_docstring or isinstance(node, (ast.Import, ast.ImportFrom)) or (place and node.lineno <= place):
            place = node.end_lineno or node.lineno
    _refuse_other_meaning(tree)
    if place == 0 and tree.body:
        # After the comments at the top: one may name the interpreter, one the encoding.
        place = min([tree.body[0].lineno] + [d.lineno for d in getattr(tree.body[0], "decorator_list", ())]) - 1
    return "rfnserver", place


def _refuse_other_meaning(tree: ast.Module) -> None:
    for node in ast.walk(tree):
        bound: List[str] = []
        if isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load):
            bound = [node.id]
        elif isinstance(node, ast.arg):
            bound = [node.arg]
        elif isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef)):
            bound = [node.name]
        elif isinstance(node, ast.ImportFrom):
            bound = [alias.asname or alias.name for alias in node.names]
        elif isinstance(node, ast.Import):
            bound = [alias.asname or "" for alias in node.names if alias.name != "rfnserver"]
        if "rfnserver" in bound:
            line = getattr(node, "lineno", 0)
            raise PortError(f"line {line}: the name rfnserver stands for something else; nothing is changed")


def _put(lines: List[str], expression: ast.expr, text: str) -> None:
    """Replace an expression in the lines."""
    first, last = expression.lineno - 1, (expression.end_lineno or expression.lineno) - 1
    # Columns of ast count bytes of UTF-8.
    before = lines[first].encode("utf-8")[: expression.col_offset].decode("utf-8")
    behind = lines[last].encode("utf-8")[expression.end_col_offset :].decode("utf-8")
    replaced = "".join(lines[first : last + 1])[len(before) :]
    replaced = replaced[: len(replaced) - len(behind)]
    if not replaced.startswith(_dotted(expression).split(".")[0]):
        # Python up to 3.11 does not know the positions of expressions inside a formatted string.
        raise PortError(f"line {expression.lineno}: the server is inside a formatted string; nothing is changed")
    lines[first : last + 1] = [before + text + behind] + [""] * (last - first)
