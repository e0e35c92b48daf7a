"""The tests themselves: R14, those of the whole graph again and again, and R17, mutants that they must notice."""

import ast
import io
import keyword
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
import tokenize
from contextlib import AbstractContextManager, nullcontext
from pathlib import Path
from typing import Any, Dict, FrozenSet, List, Sequence, Tuple

from roboframenet_testing.workspace import packages

from .demand import SUITE, Demand, Figure, Trial, none_of

_ROOT = Path(__file__).resolve().parents[2]
_TEST_TIMEOUT_S = 900
_MUTANT_TIMEOUT_S = 600.0
_REPLACEMENTS = {
    "<": "<=",
    "<=": "<",
    ">": ">=",
    ">=": ">",
    "==": "!=",
    "!=": "==",
    "+": "-",
    "-": "+",
    "*": "/",
    "and": "or",
    "or": "and",
    "True": "False",
    "False": "True",
    "is": "is not",
    "in": "not in",
    "min": "max",
    "max": "min",
    "any": "all",
    "all": "any",
}


class Repeats(Demand):
    """R14."""

    name, title = "R14", "the tests of the whole graph, again and again"
    lane = SUITE
    #: How often each test is run; two of them in the short form.
    counts = (2, 10, 100)

    def __init__(self) -> None:
        self._tests = sorted(path.name for path in (_ROOT / "tests" / "rostest").glob("*.test"))

    def count(self, form: str) -> int:
        """See :class:`Demand`; all tests count, as often as they are run."""
        return super().count(form) if form == "short" else super().count(form) * len(self._tests)

    def trial(self, number: int, chance: random.Random) -> Dict[str, Any]:
        """Run one test program."""
        test = self._tests[number % len(self._tests)]
        name = f"^_ctest_roboframenet_tests_rostest_rostest_{re.escape(test)}$"
        command = ["ctest", "--test-dir", "build", "-R", name, "--no-tests=error", "--timeout", str(_TEST_TIMEOUT_S)]
        done = subprocess.run(command, stdout=subprocess.DEVNULL, check=False, cwd=_ROOT)
        return {"test": test, "failed": int(done.returncode != 0)}

    def figures(self, trials: Sequence[Trial]) -> List[Figure]:
        """None fails."""
        failed = sorted({str(trial["test"]) for trial in trials if trial["failed"]})
        figures = [none_of("failed", trials, "failed")]
        return figures + [Figure("these", ", ".join(failed), "none", False)] if failed else figures


class Mutants(Demand):
    """R17: one token of a module is changed; its tests must notice."""

    name, title = "R17", "mutants of the number, unit, matching and verdict modules"
    counts = (12, 200, 1000)
    #: Modules by package, and the folders of the tests that must notice.
    _MODULES: Tuple[Tuple[str, str, Tuple[str, ...]], ...] = (
        ("spoken_quantities", "numbers", ("spoken_quantities",)),
        ("spoken_quantities", "units", ("spoken_quantities",)),
        ("semantic_framer", "matching", ("semantic_framer",)),
        ("semantic_framer", "verdicts", ("semantic_framer",)),
    )

    def running(self) -> "AbstractContextManager[object]":
        """Find the modules."""
        self._modules = [
            (package, next(packages()[package].glob(f"src/**/{module}.py")), tests)
            for package, module, tests in self._MODULES
        ]
        # Each place counts alike, so that a small module does not give the same mutant again and again.
        self._weights = [len(_places(path.read_text(encoding="utf-8"))) for _, path, _ in self._modules]
        for package, path, tests in {module[0]: module for module in self._modules}.values():
            if self._is_noticed(package, path, path.read_text(encoding="utf-8"), tests):
                raise SystemExit(f"the tests of {package} fail without a mutant")
        return nullcontext()

    def trial(self, number: int, chance: random.Random) -> Dict[str, Any]:
        """Change one token, and run the tests."""
        ((package, path, tests),) = chance.choices(self._modules, self._weights)
        line, old, new, text = mutant(path.read_text(encoding="utf-8"), chance)
        is_noticed = self._is_noticed(package, path, text, tests)
        return {"where": f"{path.stem}:{line}", "change": f"{old} -> {new}", "survived": int(not is_noticed)}

    @staticmethod
    def _is_noticed(package: str, path: Path, text: str, tests: Sequence[str]) -> bool:
        """Whether tests fail when a module has this text."""
        with tempfile.TemporaryDirectory() as folder:
            copy = Path(folder) / package
            source = packages()[package] / "src" / package
            shutil.copytree(source, copy)
            (copy / path.relative_to(source)).write_text(text, encoding="utf-8")
            environment = dict(os.environ, PYTHONPATH=os.pathsep.join((folder, os.environ.get("PYTHONPATH", ""))))
            folders = [str(packages()[name] / "test" / "unit") for name in tests]
            command = [sys.executable, "-m", "pytest", "-q", "-x", "-p", "no:cacheprovider", *folders]
            try:
                status = subprocess.run(
                    command,
                    stdout=subprocess.DEVNULL,
                    stderr=subprocess.DEVNULL,
                    env=environment,
                    timeout=_MUTANT_TIMEOUT_S,
                    check=False,
                    cwd=_ROOT,
                ).returncode
            except subprocess.TimeoutExpired:
                status = -1
        return status != 0

    def figures(self, trials: Sequence[Trial]) -> List[Figure]:
        """Most are noticed; those that are not are named."""
        survived = [trial for trial in trials if trial["survived"]]
        share = 1.0 - len(survived) / len(trials)
        names = "; ".join(f"{trial['where']} {trial['change']}" for trial in survived[:20])
        return [
            Figure("noticed", f"{100 * share:.0f} % of {len(trials)}", ">= 80 %", share >= 0.8),
            Figure("not noticed", names or "none"),
        ]


def mutant(source: str, chance: random.Random) -> Tuple[int, str, str, str]:
    """Change one token of a module.

    Args:
        source: text of the module
        chance: which token
    Returns:
        line, old and new token, and the changed text
    """
    token = chance.choice(_places(source))
    new = _replacement(token)
    lines = source.splitlines(keepends=True)
    row, column = token.start
    line = lines[row - 1]
    lines[row - 1] = line[:column] + new + line[column + len(token.string) :]
    return row, token.string, new, "".join(lines)


def _places(source: str) -> List[tokenize.TokenInfo]:
    """Return the tokens that can be changed. An annotation or an import that is changed is no error of logic."""
    logic = _logic_lines(source)
    tokens = tokenize.generate_tokens(io.StringIO(source).readline)
    return [token for token in tokens if token.start[0] in logic and _replacement(token)]


def _logic_lines(source: str) -> FrozenSet[int]:
    """Return the lines in functions on which something is compared, computed or decided."""
    kinds = (ast.Compare, ast.BoolOp, ast.BinOp, ast.UnaryOp, ast.IfExp, ast.Return, ast.If, ast.While)
    functions = [node for node in ast.walk(ast.parse(source)) if isinstance(node, ast.FunctionDef)]
    statements = [statement for function in functions for statement in function.body]
    return frozenset(
        node.lineno
        for statement in statements
        for node in ast.walk(statement)
        if isinstance(node, kinds) and hasattr(node, "lineno")
    )


def _replacement(token: tokenize.TokenInfo) -> str:
    if token.type == tokenize.NUMBER and token.string.replace(".", "", 1).isdigit():
        return str(float(token.string) + 1.0) if "." in token.string else str(int(token.string) + 1)
    if token.type in (tokenize.OP, tokenize.NAME) or keyword.iskeyword(token.string):
        return _REPLACEMENTS.get(token.string, "")
    return ""
