"""The kind of each clause, by the words in front of its verb, and the file of these words."""

from typing import Any, Tuple

import pytest

from checked_files import FileRefused
from semantic_framer.kinds.mood_file import MoodRule, UtteranceKind, load_moods, shipped_moods
from semantic_framer.kinds.utterance_kind import kind_without_clause, kinds_of_clauses
from utterance_passes.phrases.clauses import find_clauses
from utterance_passes.trees.conllu import from_short
from utterance_passes.trees.vocabulary import Verbs

TIRED = "i|PRON|3|nsubj am|AUX|3|cop|be tired|ADJ|0|root"
VERBS = Verbs(frozenset(["turn", "open", "bring"]))
RULES = [(table, rule) for table in ("acting", "telling") for rule in getattr(shipped_moods(), table)]


@pytest.mark.parametrize("table, rule", RULES, ids=lambda value: getattr(value, "name", value))
def test_the_example_of_a_rule_is_its_own(table: str, rule: MoodRule) -> None:
    rules: Tuple[MoodRule, ...] = getattr(shipped_moods(), table)
    assert next(other for other in rules if other.pattern.fullmatch(rule.example)) is rule


def test_rules_are_told_apart() -> None:
    for table in ("acting", "telling"):
        names = [rule.name for of, rule in RULES if of == table]
        assert len(set(names)) == len(names)


@pytest.mark.parametrize(
    "tree, kinds",
    [
        ("turn|VERB|0|root left|ADV|1|advmod", ["command: imperative"]),
        ("could|AUX|3|aux you|PRON|3|nsubj turn|VERB|0|root", ["request: modal_to_addressee"]),
        ("did|AUX|3|aux you|PRON|3|nsubj turn|VERB|0|root", ["question: inversion"]),
        ("i|PRON|2|nsubj turned|VERB|0|root", ["report: statement"]),
        ("do|AUX|3|aux n't|PART|3|advmod turn|VERB|0|root", ["prohibition: imperative"]),
        ("i|PRON|2|nsubj want|VERB|0|root to|PART|4|mark turn|VERB|2|xcomp", ["wish: speaker_acts"]),
        ("the|DET|2|det lamp|NOUN|4|nsubj is|AUX|4|cop|be big|ADJ|0|root", ["report: fact"]),
        ("i|PRON|3|nsubj am|AUX|3|cop|be tired|ADJ|0|root", ["talk: state"]),
        (
            "i|PRON|3|nsubj am|AUX|3|cop|be tired|ADJ|0|root so|ADV|5|advmod open|VERB|3|conj it|PRON|5|obj",
            ["talk: state", "command: imperative"],
        ),
        (
            f"{TIRED} could|AUX|6|aux you|PRON|6|nsubj turn|VERB|3|conj ?|PUNCT|3|punct",
            ["talk: state", "request: modal_to_addressee"],
        ),
        (
            f"{TIRED} and|CCONJ|6|cc you|PRON|6|nsubj turn|VERB|3|conj ?|PUNCT|3|punct",
            ["question: question_mark", "command: imperative_with_subject"],
        ),
        ("the|DET|2|det lamp|NOUN|4|nsubj was|AUX|4|cop|be|VBD big|ADJ|0|root", ["report: statement"]),
        (
            "turn|VERB|0|root ,|PUNCT|1|punct are|AUX|1|parataxis|be you|PRON|3|nsubj",
            ["command: imperative", "question: inversion"],
        ),
    ],
)
def test_kinds(tree: str, kinds: Tuple[str, ...]) -> None:
    sentence = from_short(tree)
    found = kinds_of_clauses(sentence, find_clauses(sentence, VERBS), VERBS)
    assert [f"{kind.kind.value}: {kind.reason}" for kind in found] == list(kinds)


@pytest.mark.parametrize(
    "tree, kind",
    [
        ("thanks|NOUN|0|root robot|NOUN|1|vocative", UtteranceKind.TALK),
        ("hello|INTJ|0|root", UtteranceKind.TALK),
        ("where|ADV|0|root", UtteranceKind.QUESTION),
        ("two|NUM|2|nummod feet|NOUN|0|root", UtteranceKind.ANSWER),
    ],
)
def test_kind_of_what_has_no_verb(tree: str, kind: UtteranceKind) -> None:
    assert kind_without_clause(from_short(tree)).kind is kind


FILE = """\
spellings: {{not: [n't]}}
parts: {{i: (i|we)}}
acting: [{{name: imperative, kind: command, pattern: BASE, example: BASE}}]
telling:
  - {{name: wish, {entry}}}
"""


def test_parts_and_classes_stand_in_patterns() -> None:
    text = FILE.format(entry="kind: wish, pattern: <i> <modals> BASE, example: i can BASE")
    rule = load_moods(text, "moods.yaml").telling[0]
    assert rule.pattern.fullmatch("we must BASE") and not rule.pattern.fullmatch("you must BASE")


@pytest.mark.parametrize(
    "entry, code, key",
    [
        ("kind: wich, pattern: BASE, example: BASE", "UNKNOWN_VALUE", "telling[0].kind"),
        ("kind: wish, pattern: <nobody>, example: BASE", "UNKNOWN_CLASS", "telling[0].pattern"),
        ('kind: wish, pattern: "(BASE", example: BASE', "BAD_PATTERN", "telling[0].pattern"),
        ("kind: wish, example: BASE", "MISSING_KEY", "telling[0].pattern"),
    ],
)
def test_what_is_wrong_is_named_with_its_line(entry: str, code: str, key: str) -> None:
    with pytest.raises(FileRefused) as refused:
        load_moods(FILE.format(entry=entry), "moods.yaml")
    problem = refused.value.problems[0]
    assert (problem.line, problem.key) == (5, key), problem
    assert problem.code == code


@pytest.mark.parametrize(
    "text, code",
    [
        ("Make sure not to open the door.", "NEGATED"),
        ("Make sure to open the door.", ""),
        ("Make sure that the door is open.", ""),
    ],
)
def test_what_somebody_makes_sure_to_do_is_the_command(understand: Any, text: str, code: str) -> None:
    outcome, _ = understand(text)
    assert getattr(outcome, "code", "") == code
