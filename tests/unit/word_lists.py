"""Finds lists of English words in Python modules; they belong in ``words.yaml`` or ``formulas.yaml``."""

import ast
import re
from dataclasses import dataclass
from typing import FrozenSet, Iterator, List, Set

#: Number of words from which on they count as a list.
FEWEST = 3
#: A phrase of up to three words. A string with a capital, a digit, an underscore or a slash is a name or a code.
_WORD = re.compile(r"'?[a-z][a-z'’.-]*( [a-z'’.-]+){0,2}")
#: Alternatives of a regular expression, with optional parts.
_ALTERNATIVE = r"[a-z'’][a-z'’ ]*\??(?:\([a-z' ]+\)\?)?"
_ALTERNATIVES = re.compile(rf"(?<![|A-Za-z0-9]){_ALTERNATIVE}(?:\|{_ALTERNATIVE})+(?![|A-Za-z0-9])")


@dataclass(frozen=True)
class WordList:
    """Words that form a list in a module: their line, and the words."""

    line: int
    words: FrozenSet[str]


def word_lists(code: str, names: FrozenSet[str] = frozenset()) -> List[WordList]:
    """Find the lists of words of a module.

    Sets, lists, tuples, keys of mappings, strings that are split, comparisons joined by "or" or "and", and alternatives
    of regular expressions count; nested tuples and lists count as one.

    Args:
        code: source code of the module
        names: words that do not count if a list has no others: names of grammatical relations
    """
    tree = ast.parse(code)
    strings_of_no_data = set(documentation(tree))
    found: List[WordList] = []
    inner: Set[ast.AST] = set()
    for node in ast.walk(tree):
        if node in inner:
            continue
        words = frozenset(_words(node, inner) if node not in strings_of_no_data else ())
        if len(words) >= FEWEST and not words <= names:
            found.append(WordList(getattr(node, "lineno", 0), words))
    return sorted(found, key=lambda one: one.line)


def documentation(tree: ast.AST) -> Iterator[ast.AST]:
    """Return the strings that are no data: docstrings, and names that a module exports."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            yield node.value
        if isinstance(node, ast.Assign) and any(getattr(target, "id", "") == "__all__" for target in node.targets):
            yield from ast.walk(node.value)


def _words(node: ast.AST, inner: Set[ast.AST]) -> Iterator[str]:
    """Return the words of a node; add nested nodes of the same list to ``inner``."""
    if isinstance(node, (ast.Set, ast.List, ast.Tuple, ast.Dict)):
        items = [key for key in node.keys if key] if isinstance(node, ast.Dict) else node.elts
        for item in items:
            if isinstance(item, (ast.Tuple, ast.List)) and all(_is_text(part) for part in item.elts):
                inner.add(item)
                yield from (word for part in item.elts for word in _of_text(part))
            else:
                yield from _of_text(item)
    elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
        if node.func.attr in ("split", "splitlines") and _is_text(node.func.value):
            inner.add(node.func.value)
            text = getattr(node.func.value, "value", "")
            yield from (word for word in re.split(r"[\s,;|]+", text) if _WORD.fullmatch(word))
    elif isinstance(node, ast.BoolOp):
        for value in node.values:
            if isinstance(value, ast.Compare) and isinstance(value.ops[0], (ast.Eq, ast.NotEq)):
                yield from _of_text(value.comparators[0])
    elif _is_text(node):
        for match in _ALTERNATIVES.finditer(getattr(node, "value", "")):
            yield from (word.strip() for word in match[0].split("|"))


def _is_text(node: ast.AST) -> bool:
    return isinstance(node, ast.Constant) and isinstance(node.value, str)


def _of_text(node: ast.AST) -> Iterator[str]:
    if _is_text(node) and _WORD.fullmatch(getattr(node, "value", "")):
        yield getattr(node, "value", "")
