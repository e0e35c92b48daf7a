"""Lists what the robot, its page and its programs tell persons: each text of the code and of the data, by its place.

    python tests/unit/told_texts.py > docs/texts/english.yaml

Something in braces stands for what is put there when the text is told.
"""

import ast
import re
import sys
from pathlib import Path
from typing import Any, Dict, Iterator, List, Set, Tuple

import yaml
from word_lists import documentation

from roboframenet_testing.workspace import packages

#: By kind and place; each list in the order of the alphabet.
Texts = Dict[str, Dict[str, List[str]]]

KINDS = {
    "said": "Replies, questions and notes: whole sentences.",
    "parts": "Reasons, and other parts of sentences; errors that name a place.",
    "asked": "What frames ask and small talk answers, from their YAML files.",
    "page": "What stands on the page.",
    "logged": "Log lines, for engineers.",
}
_EXCEPTIONS = yaml.safe_load((Path(__file__).parent / "words_in_modules.yaml").read_text(encoding="utf-8"))
#: These hold what persons say to the robot, and tests.
_NOT_TOLD = frozenset(("mood_matrix", "roboframenet_testing", "roboframenet_rostest", "roboframenet_cmake"))
_HEARD = frozenset(_EXCEPTIONS["exempt_modules"])
_LOGS = re.compile(
    r"log(debug|info|warn|err|fatal)(_once|_throttle|_throttle_identical)?|debug|info|warning|error|exception"
)
#: Keyword arguments for `rfn --help`, and of examples of rules.
_HELP = frozenset(("help", "description", "epilog", "metavar", "usage", "formatter_class"))
#: Trees, patterns, programs and lists of names are no prose.
_NO_PROSE = re.compile(r"->|%[YmdHM]|\w\[|[|\\<>=_;\n]|[A-Z]{5,}|\(\?|^rfn ")
_WORD = re.compile(r"[A-Za-z][a-z']*")
_HOLE = re.compile(r"\{[^{}]*\}")
_SENTENCE_END = re.compile(r"[.?!…][\"')]*\s*$")
_CAPITAL = re.compile(r"^[\"'(“]*[A-Z]")
_YAML_KEYS = frozenset(("question", "reply"))
_PAGE_TEXT = re.compile(r">([^<>]*[A-Za-z][^<>]*)<")
_PAGE_ATTRIBUTE = re.compile(r'(?:aria-label|placeholder|title)="([^"]*[a-z][^"]*)"')
_SCRIPT_TEXT = re.compile(r'"((?:[^"\\\n]|\\.)*)"|`((?:[^`\\]|\\.)*)`')


def told_texts() -> Texts:
    """Return all texts of the shipped packages."""
    found: Dict[str, Dict[str, Set[str]]] = {kind: {} for kind in KINDS}
    for name, folder in packages().items():
        if name in _NOT_TOLD:
            continue
        for kind, place, text in _of_package(name, folder):
            found[kind].setdefault(place, set()).add(text)
    return {kind: {place: sorted(places[place]) for place in sorted(places)} for kind, places in found.items()}


def _of_package(name: str, folder: Path) -> Iterator[Tuple[str, str, str]]:
    for path in sorted(folder.rglob("*")):
        inside = path.relative_to(folder)
        if "test" in inside.parts or not path.is_file():
            continue
        place = str(inside.relative_to("src") if inside.parts[0] == "src" else Path(name) / inside)
        if path.suffix == ".py" or inside.parts[0] == "nodes":
            if place not in _HEARD:
                yield from ((kind, place, text) for kind, text in texts_of_module(path.read_text(encoding="utf-8")))
        elif path.suffix == ".yaml":
            yield from (("asked", place, text) for text in _of_yaml(path))
        elif path.suffix in (".js", ".html"):
            yield from (("page", place, text) for text in texts_of_page(path.read_text(encoding="utf-8"), path.suffix))


def texts_of_module(code: str) -> Iterator[Tuple[str, str]]:
    """Return the kind and the text of each string of a module that is prose.

    Docstrings, help of command lines, and what a string is compared with are not told.
    """
    tree = ast.parse(code)
    silent = set(documentation(tree))
    logged: Set[ast.AST] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.JoinedStr):
            silent.update(node.values)
        elif isinstance(node, ast.Compare):
            silent.update((node.left, *node.comparators))
        elif isinstance(node, ast.keyword) and node.arg in _HELP:
            silent.update(ast.walk(node.value))
        elif isinstance(node, ast.Call):
            called = getattr(node.func, "attr", "")
            if _LOGS.fullmatch(called) and node.args:
                logged.add(node.args[0])
            elif called in ("split", "compile", "execute", "replace"):
                silent.update(ast.walk(node))
    for node in ast.walk(tree):
        if node in silent or not isinstance(node, (ast.Constant, ast.JoinedStr)):
            continue
        text = _text_of(node).strip()
        if node in logged and len(_WORD.findall(text)) > 1:
            yield "logged", text
            continue
        kind = _kind_of(text)
        if kind:
            yield kind, text


def _text_of(node: ast.AST) -> str:
    """Return the text of a string, with names in braces for what is put into it."""
    if isinstance(node, ast.JoinedStr):
        return "".join(_text_of(part) for part in node.values)
    if isinstance(node, ast.FormattedValue):
        return _hole(node.value)
    value = getattr(node, "value", "")
    return value if isinstance(value, str) else ""


def _hole(value: ast.AST) -> str:
    if isinstance(value, ast.IfExp):
        branches = [
            _text_of(one) if isinstance(one, (ast.Constant, ast.JoinedStr)) else _hole(one)
            for one in (value.body, value.orelse)
        ]
        return "{" + "/".join(one.strip("{}") for one in branches) + "}"
    names = [
        getattr(one, "attr", getattr(one, "id", ""))
        for one in ast.walk(value)
        if isinstance(one, (ast.Attribute, ast.Name))
    ]
    # The last name is the innermost: that of what a function makes words of.
    outer = [one for one in names if one not in ("self", "join", "map", "len", "str", "sorted", "repr", "replace")]
    return "{" + (outer[0] if isinstance(value, ast.Attribute) else outer[-1] if outer else "") + "}"


def _kind_of(text: str) -> str:
    """Return the kind of a string: said, parts, or nothing when it is no prose."""
    prose = _HOLE.sub(" ", text)
    words = _WORD.findall(prose)
    if _NO_PROSE.search(prose) or " " not in text or len(words) < 2:
        return ""
    if _SENTENCE_END.search(text) and (_CAPITAL.match(text) or text.startswith(("{", '"'))):
        return "said"
    if _CAPITAL.match(text) and not words[1][0].isupper():
        return "said"
    return "parts" if len(words) > 2 else ""


def _of_yaml(path: Path) -> Iterator[str]:
    """Return the values of the keys that are told."""
    for document in yaml.safe_load_all(path.read_text(encoding="utf-8")):
        yield from _values(document)


def _values(data: Any) -> Iterator[str]:
    if isinstance(data, dict):
        for key, value in data.items():
            if key in _YAML_KEYS and isinstance(value, str) and " " in value:
                yield value
            else:
                yield from _values(value)
    elif isinstance(data, list):
        for one in data:
            yield from _values(one)


def texts_of_page(code: str, suffix: str) -> Iterator[str]:
    """Return the texts of a page or of its scripts."""
    if suffix == ".html":
        found = [match[1] for match in _PAGE_TEXT.finditer(re.sub(r"<!--.*?-->", "", code, flags=re.DOTALL))]
        found += [match[1] for match in _PAGE_ATTRIBUTE.finditer(code)]
    else:
        lines = re.sub(r"(^|\s)//.*$", "", code, flags=re.MULTILINE)
        found = [re.sub(r"\$\{[^{}]*\}", "{}", match[1] or match[2] or "") for match in _SCRIPT_TEXT.finditer(lines)]
        found = [text for text in found if _CAPITAL.match(text) and not re.search(r"[<>=_]|^[A-Z]+$", text)]
    yield from (" ".join(text.split()) for text in found if _WORD.search(text))


def written(texts: Texts) -> str:
    """Return the file."""
    header = (
        "# Every text in English that persons read or hear, by its module. Made by scripts/texts: do not edit it,\n"
        "# change the module. 'What the robot says' in CONTRIBUTING.md tells how they are to sound.\n"
    )
    parts = [header]
    for kind, what in KINDS.items():
        body = yaml.safe_dump({kind: texts[kind]}, allow_unicode=True, width=10000, sort_keys=False)
        parts.append(f"\n# {what}\n{body}")
    return "".join(parts)


if __name__ == "__main__":
    sys.stdout.write(written(told_texts()))
