"""YAML nodes with their lines, read against a schema that collects all mistakes of a file at once."""

import difflib
import math
from typing import Any, Dict, Iterable, List, Optional, Sequence, Tuple

import yaml

from checked_files.problem import MOST_PROBLEMS, FileRefused, Problem

#: Characters; nobody writes a longer file by hand.
LARGEST_FILE = 1_000_000
#: Lists and mappings inside each other; the deepest key of a frame file is at 6.
DEEPEST_NESTING = 20
#: Characters of the name of a frame, an element or a server.
LONGEST_NAME = 200
NAME_EXPECTED = f"a name of at most {LONGEST_NAME} printable characters on one line"
#: libyaml is ten times as fast as Python; it is an option of PyYAML.
_QUICK_LOADER: Any = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
_BOOLEANS = {"true": True, "yes": True, "false": False, "no": False}


class Reader:
    """Reads the nodes of one file and collects its problems.

    Nothing is converted before the schema asks for it: ``on`` stays "on", ``5`` stays "5".

    Attributes:
        path: the file, for the problems
        problems: found so far
    """

    def __init__(self, path: str) -> None:
        self.path = path
        self.problems: List[Problem] = []

    def report(self, code: str, node: yaml.Node, key: str, found: str, expected: str, hint: str = "") -> None:
        """Add a problem at the line of a node.

        Raises:
            FileRefused: there are more problems than are told; the rest of the file is not read
        """
        self.problems.append(
            Problem(code=code, path=self.path, line=line_of(node), key=key, found=found, expected=expected, hint=hint)
        )
        if len(self.problems) > MOST_PROBLEMS:
            raise FileRefused(self.problems)

    def refuse_if_wrong(self) -> None:
        """
        Raises:
            FileRefused: a problem was reported
        """
        if self.problems:
            raise FileRefused(self.problems)

    def compose(self, text: str, expected: str) -> yaml.Node:
        """Parse a text to its tree of nodes.

        Args:
            text: content of the file
            expected: what the file should hold, for the problem of an empty one
        Returns:
            the root
        Raises:
            FileRefused: the text is empty, not YAML, several documents, too large or nested too deeply, or has an alias
        """
        if len(text) > LARGEST_FILE:
            raise FileRefused(
                [Problem("TOO_LARGE", self.path, 1, "file", f"{len(text)} characters", f"at most {LARGEST_FILE}")]
            )
        try:
            return self._composed(text, expected, _QUICK_LOADER)
        except yaml.YAMLError:
            # The loader in Python says more about what is wrong.
            return self._composed_or_refused(text, expected)

    def _composed_or_refused(self, text: str, expected: str) -> yaml.Node:
        try:
            return self._composed(text, expected, yaml.SafeLoader)
        except yaml.YAMLError as error:
            mark = getattr(error, "problem_mark", None)
            reason = getattr(error, "problem", None) or getattr(error, "reason", None) or str(error).split("\n")[0]
            raise FileRefused(
                [Problem("NOT_YAML", self.path, mark.line + 1 if mark else 1, "file", str(reason), "one YAML document")]
            ) from error

    def _composed(self, text: str, expected: str, loader: Any) -> yaml.Node:
        """Return the root of a text, read by a loader; see `compose`.

        Raises:
            yaml.YAMLError: the text is no YAML, or several documents
        """
        depth = 0
        for event in yaml.parse(text, Loader=loader):
            depth += isinstance(event, yaml.CollectionStartEvent) - isinstance(event, yaml.CollectionEndEvent)
            if depth > DEEPEST_NESTING:
                raise FileRefused(
                    [
                        Problem(
                            "TOO_DEEP",
                            self.path,
                            event.start_mark.line + 1,
                            "file",
                            f"more than {DEEPEST_NESTING} lists and mappings inside each other",
                            expected,
                        )
                    ]
                )
            if isinstance(event, yaml.AliasEvent) or getattr(event, "anchor", None):
                raise FileRefused(
                    [
                        Problem(
                            "ALIAS",
                            self.path,
                            event.start_mark.line + 1,
                            "file",
                            "an anchor or alias",
                            "every value written out",
                        )
                    ]
                )
        root: Optional[yaml.Node] = yaml.compose(text, Loader=loader)
        if root is None or (isinstance(root, yaml.SequenceNode) and not root.value):
            raise FileRefused([Problem("EMPTY", self.path, 1, "file", "nothing", expected)])
        return root

    def mapping(
        self, node: yaml.Node, key: str, known: Sequence[str], required: Sequence[str] = ()
    ) -> Dict[str, yaml.Node]:
        """Return the entries of a mapping; report unknown, duplicate and missing keys."""
        if not isinstance(node, yaml.MappingNode):
            self.report(
                "WRONG_TYPE", node, key or "file", describe(node), f"a mapping with {', '.join(required or known)}"
            )
            return {}
        entries: Dict[str, yaml.Node] = {}
        prefix = f"{key}." if key else ""
        for key_node, value in node.value:
            name = key_node.value if isinstance(key_node, yaml.ScalarNode) else describe(key_node)
            if name not in known:
                self.report(
                    "UNKNOWN_KEY",
                    key_node,
                    prefix + str(name),
                    f"'{name}'",
                    f"one of {', '.join(known)}",
                    did_you_mean(str(name), known),
                )
            elif name in entries:
                self.report(
                    "DUPLICATE_KEY",
                    key_node,
                    prefix + name,
                    f"a second '{name}'",
                    f"one, the first is in line {line_of(entries[name])}",
                )
            else:
                entries[name] = value
        for name in required:
            if name not in entries:
                self.report("MISSING_KEY", node, prefix + name, "nothing", f"the key '{name}'")
        return entries

    def free_mapping(self, node: Optional[yaml.Node], key: str) -> List[Tuple[yaml.Node, yaml.Node]]:
        """Return the keys and values of a mapping whose keys may be anything; nothing for no node."""
        if node is None:
            return []
        if not isinstance(node, yaml.MappingNode):
            self.report("WRONG_TYPE", node, key, describe(node), "a mapping")
            return []
        return list(node.value)

    def sequence(self, node: Optional[yaml.Node], key: str) -> List[Tuple[str, yaml.Node]]:
        """Return the items of a list, each with its key ("children[2]"); nothing for an empty value."""
        if node is None or is_empty(node):
            return []
        if not isinstance(node, yaml.SequenceNode):
            self.report("WRONG_TYPE", node, key, describe(node), "a list")
            return []
        return [(f"{key}[{index}]", item) for index, item in enumerate(node.value)]

    def text(self, node: Optional[yaml.Node], key: str, default: str = "") -> str:
        """Return a scalar as it is written, without blanks at its ends."""
        if node is None:
            return default
        if not isinstance(node, yaml.ScalarNode):
            self.report("WRONG_TYPE", node, key, describe(node), "a text")
            return default
        return str(node.value).strip()

    def name(self, node: Optional[yaml.Node], key: str) -> str:
        """Return a text that must not be empty; a missing key was reported with its mapping."""
        value = self.text(node, key)
        if node is not None and not value and isinstance(node, yaml.ScalarNode):
            self.report("EMPTY", node, key, "nothing", "a name")
        return value

    def graph_name(self, node: Optional[yaml.Node], key: str) -> str:
        """Return the name of a frame or an element, which appears in logs, messages and replies."""
        value = self.name(node, key)
        if node is not None and not is_name(value):
            self.report("NOT_A_NAME", node, key, describe(node), NAME_EXPECTED)
        return value

    def boolean(self, node: Optional[yaml.Node], key: str, default: bool = False) -> bool:
        """Return a truth value: True, False, yes or no, in upper or lower case."""
        if node is None:
            return default
        value = self.text(node, key).lower()
        if value not in _BOOLEANS:
            self.report("NOT_A_BOOLEAN", node, key, describe(node), "True or False")
            return default
        return _BOOLEANS[value]

    def number(
        self, node: Optional[yaml.Node], key: str, expected: str, *, default: float = 0.0, above: float = -math.inf
    ) -> float:
        """Return a finite number above a bound; ``expected`` says what it is, for the problem of another value."""
        if node is None:
            return default
        text = self.text(node, key)
        try:
            number = float(text)
        except ValueError:
            number = math.nan
        if not above < number < math.inf:
            self.report("NOT_A_NUMBER", node, key, f"'{text}'", expected)
            return default
        return number

    def seconds(self, node: Optional[yaml.Node], key: str, default: float) -> float:
        """Return a duration: a number of seconds, more than 0 and finite."""
        return self.number(node, key, "seconds, more than 0", default=default, above=0.0)

    def texts(self, node: Optional[yaml.Node], key: str) -> Tuple[str, ...]:
        """Return a list of texts; a single text is a list of one."""
        if node is None or is_empty(node):
            return ()
        if isinstance(node, yaml.ScalarNode):
            return (self.text(node, key),)
        return tuple(self.name(item, item_key) for item_key, item in self.sequence(node, key))

    def choice(self, node: Optional[yaml.Node], key: str, choices: Sequence[str], default: str) -> str:
        """Return a text that must be one of the given ones."""
        if node is None:
            return default
        value = self.text(node, key)
        if value not in choices:
            self.report(
                "UNKNOWN_VALUE", node, key, describe(node), f"one of {', '.join(choices)}", did_you_mean(value, choices)
            )
            return default
        return value


def line_of(node: yaml.Node) -> int:
    """Return the line of a node, from 1."""
    return int(node.start_mark.line) + 1


def is_name(text: str) -> bool:
    """Whether a text may be a name: it appears in logs and in what people are told."""
    return len(text) <= LONGEST_NAME and text.isprintable()


def is_empty(node: yaml.Node) -> bool:
    """Whether the value of a key is empty."""
    return isinstance(node, yaml.ScalarNode) and node.value == "" and not node.style


def describe(node: yaml.Node) -> str:
    """Describe a node in words, for a problem."""
    if isinstance(node, yaml.MappingNode):
        return "a mapping"
    if isinstance(node, yaml.SequenceNode):
        return "a list"
    return f"'{node.value}'" if node.value else "nothing"


def did_you_mean(word: str, known: Iterable[str]) -> str:
    """Return a hint that names the nearest known word; empty when none is near."""
    near = difflib.get_close_matches(word, list(known), n=1, cutoff=0.6)
    return f"did you mean '{near[0]}'?" if near else ""
