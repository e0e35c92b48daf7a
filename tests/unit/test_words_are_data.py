"""English words that rules compare with a sentence are in ``words.yaml`` and ``formulas.yaml``, not in modules."""

import ast
import re
from functools import lru_cache
from pathlib import Path
from typing import Dict, FrozenSet, Iterator, List, Set, Tuple

import pytest
import yaml
from word_lists import WordList, word_lists

from roboframenet_testing.workspace import packages
from semantic_frames.relation_names import STANFORD, UNIVERSAL
from typed_arguments.attribute_names import QUANTIFIERS
from typed_arguments.attribute_names import RELATIONS as RELATIONS_OF_ARGUMENTS
from word_classes import word_classes

RELATIONS = UNIVERSAL | STANFORD

EXCEPTIONS = yaml.safe_load((Path(__file__).parent / "words_in_modules.yaml").read_text(encoding="utf-8"))
#: Modules that hold words of speech on purpose.
EXEMPT: Dict[str, str] = EXCEPTIONS["exempt_modules"]
#: Words that nobody says to the robot, or that have their own treatment, by module.
NO_SPEECH: Dict[str, FrozenSet[str]] = {
    name: frozenset(entry["words"].split(", ")) for name, entry in EXCEPTIONS["exempt_lists"].items()
}
#: They are names of relations and quantifiers, not the words that are said for them.
NO_SPEECH["typed_arguments/attribute_names.py"] = frozenset(
    name for name in RELATIONS_OF_ARGUMENTS | QUANTIFIERS if "_" not in name
)


def modules() -> Iterator[Tuple[str, Path]]:
    """Return the modules by package and file, and the programs."""
    for name, folder in packages().items():
        yield from ((str(path.relative_to(folder / "src")), path) for path in sorted(folder.glob("src/**/*.py")))
        yield from ((f"{name}/nodes/{path.name}", path) for path in sorted(folder.glob("nodes/*")) if path.is_file())


MODULES = dict(modules())


def lists_of(name: str) -> List[WordList]:
    return word_lists(MODULES[name].read_text(encoding="utf-8"), RELATIONS)


@pytest.mark.parametrize("name", [name for name in MODULES if name not in EXEMPT])
def test_no_module_holds_a_list_of_english_words(name: str) -> None:
    assert not [one for one in lists_of(name) if not one.words <= NO_SPEECH.get(name, frozenset())]


@pytest.mark.parametrize("name", sorted([*EXEMPT, *NO_SPEECH]))
def test_every_exception_is_needed(name: str) -> None:
    found = frozenset().union(*(one.words for one in lists_of(name)))
    assert found and (name in EXEMPT or found == NO_SPEECH[name])


@pytest.mark.parametrize(
    "code",
    [
        'WORDS = frozenset(["left", "right", "around"])',
        'WORDS = {"left", "right", "around"}',
        'WORDS = "left right around".split()',
        'WORDS = ("left", "right", "turn around")',
        'WORDS = (("turn", "left"), ("turn", "right"))',
        'ANGLES = {"left": 1.0, "right": -1.0, "around": 2.0}',
        'ANGLES = {("turn", "left"): 1.0, ("turn", "right"): -1.0}',
        'is_turn = word.form.lower() in ("left", "right", "around")',
        'is_turn = said == "left" or said == "right" or said == "around"',
        'is_none = said != "left" and said != "right" and said != "around"',
        'TURN = re.compile(r"^(left|right|around)\\b")',
        'TURN = re.compile("turn (to the )?(left|right|all the way)( now)?")',
        'TURN = re.compile(f"turn (left|right|around) {NOW}")',
        'MIXED = ["obj", "iobj", "left"]',
        "def turn(words=('left', 'right', 'around')):\n    return words",
    ],
)
def test_a_list_of_words_is_found(code: str) -> None:
    assert word_lists(code, RELATIONS)


@pytest.mark.parametrize(
    "code",
    [
        'OBJECTS = ("obj", "iobj", "obl")',
        'TAGS = ("NOUN", "PROPN", "PRON")',
        'NAMES = ("goal_x", "goal_y", "frame_id")',
        'SIDES = ("left", "right")',
        '"""It may say left|right|around."""',
        '__all__ = ["left", "right", "around"]',
        'EXAMPLE = "turn|VERB|0|root left|ADV|1|advmod|left|RB"',
        'WORDS = word_class("left_and_right")',
    ],
)
def test_other_code_is_not_taken_for_a_list_of_words(code: str) -> None:
    assert not word_lists(code, RELATIONS)


@lru_cache(maxsize=None)
def asked_for() -> Dict[str, Set[str]]:
    """Return all strings of the modules that import word classes, and what they ask for as "word_class(NAME)"."""
    found: Dict[str, Set[str]] = {}
    for name, path in MODULES.items():
        code = path.read_text(encoding="utf-8")
        if "from word_classes import" in code:
            nodes = list(ast.walk(ast.parse(code)))
            found[name] = {n.value for n in nodes if isinstance(n, ast.Constant) and isinstance(n.value, str)}
            found[name].update(
                f"word_class({node.args[0].value})"
                for node in nodes
                if isinstance(node, ast.Call)
                and getattr(node.func, "id", "") in ("word_class", "word_list")
                and isinstance(node.args[0], ast.Constant)
            )
    return found


def test_every_requested_word_class_exists() -> None:
    requests = [
        (name, text[11:-1]) for name, texts in asked_for().items() for text in texts if text.startswith("word_class(")
    ]
    assert len(requests) > 300
    assert not [(name, word) for name, word in requests if word not in word_classes()]


def test_every_word_class_is_used() -> None:
    text = (packages()["word_classes"] / "src/word_classes/words.yaml").read_text(encoding="utf-8")
    included = set(re.findall(r"\w+", " ".join(re.findall(r"includes: \[(.*)\]", text))))
    files = {"utterance_passes": ("formulas",), "semantic_framer": ("fragments", "objections", "small_talk")}
    paths = [
        path for one, names in files.items() for path in packages()[one].glob("src/**/*.yaml") if path.stem in names
    ]
    assert len(paths) == 4
    formulas = "".join(path.read_text(encoding="utf-8") for path in paths)
    used = set().union(*asked_for().values()) | included | set(re.findall(r"<(\w+)>", formulas))
    # Used by without_determiner and by agreement; the last one is only known, as all others are.
    own = {"determiners", "agreements", "refusals", "words_of_no_rule"}
    assert not set(word_classes()) - used - own
