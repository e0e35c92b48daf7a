"""Lists of English words in Python, which should be classes in ``words.yaml`` or patterns in ``formulas.yaml``."""

import ast
import re
from dataclasses import dataclass
from typing import FrozenSet, Iterator, List, Set

#: So many words that are compared with what is said are a list.
FEWEST = 3
#: A word or a phrase of up to three; what holds a capital, a digit, an underscore or a slash is a name or a code.
_WORD = re.compile(r"'?[a-z][a-z'’.-]*( [a-z'’.-]+){0,2}")
#: Alternatives of a regular expression, with parts that may be missing.
_ALTERNATIVE = r"[a-z'’][a-z'’ ]*\??(?:\([a-z' ]+\)\?)?"
_ALTERNATIVES = re.compile(rf"(?<![|A-Za-z0-9]){_ALTERNATIVE}(?:\|{_ALTERNATIVE})+(?![|A-Za-z0-9])")


@dataclass(frozen=True)
class WordList:
    """Words that stand together in a module: their line, and what they are."""

    line: int
    words: FrozenSet[str]


def word_lists(code: str, names: FrozenSet[str] = frozenset()) -> List[WordList]:
    """Find the lists of words of a module.

    Sets, lists, tuples, keys of mappings, texts that are split, comparisons that are joined by "or" or "and", and
    alternatives of regular expressions count; tuples and lists of them are one.

    Args:
        code: of the module
        names: words that are none of speech wherever all of a list are of them: names of grammatical relations
    """
    tree = ast.parse(code)
    documentation = set(_documentation(tree))
    found: List[WordList] = []
    inner: Set[ast.AST] = set()
    for node in ast.walk(tree):
        if node in inner:
            continue
        words = frozenset(_words(node, inner) if node not in documentation else ())
        if len(words) >= FEWEST and not words <= names:
            found.append(WordList(getattr(node, "lineno", 0), words))
    return sorted(found, key=lambda one: one.line)


def _documentation(tree: ast.AST) -> Iterator[ast.AST]:
    """Texts that are no data: docstrings, and names that a module exports."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            yield node.value
        if isinstance(node, ast.Assign) and any(getattr(target, "id", "") == "__all__" for target in node.targets):
            yield from ast.walk(node.value)


def _words(node: ast.AST, inner: Set[ast.AST]) -> Iterator[str]:
    """The words of a node; nodes inside of it that are a part of the same list are added to ``inner``."""
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
