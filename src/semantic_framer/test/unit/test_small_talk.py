"""Small talk gets a short answer, and is against nothing that runs."""

import pytest

from checked_files import FileRefused
from semantic_framer.framer import Refusal
from semantic_framer.sentences.small_talk import load_small_talk, shipped_small_talk, small_talk_of
from utterance_passes.trees.conllu import from_short
from utterance_passes.trees.formula_file import Formula

PATTERNS = [(kind.name, formula) for kind in shipped_small_talk() for formula in kind.formulas]
FILE = "thanks:\n  reply: You are welcome.\n  patterns: [{pattern: thanks, example: thanks}]\n"


@pytest.mark.parametrize("name, formula", PATTERNS, ids=lambda value: getattr(value, "example", value))
def test_the_example_of_a_pattern_is_its_own(name: str, formula: Formula) -> None:
    first = next(other for _, other in PATTERNS if other.pattern.fullmatch(formula.example))
    assert first is formula
    assert formula.example == formula.example.lower()


@pytest.mark.parametrize("kind", shipped_small_talk(), ids=lambda kind: kind.name)
def test_a_reply_is_one_short_text(kind) -> None:
    assert kind.reply.endswith(".") and len(kind.reply) <= 40


@pytest.mark.parametrize(
    "words, name",
    [
        ("thanks|NOUN|0|root", "thanks"),
        ("uh|INTJ|2|discourse thanks|NOUN|0|root", "thanks"),
        ("hello|INTJ|3|discourse ,|PUNCT|3|punct thanks|NOUN|0|root", "thanks"),
        ("hello|INTJ|0|root kitchen|NOUN|1|dep", ""),
        (",|PUNCT|0|root", ""),
    ],
)
def test_all_parts_are_small_talk(words: str, name: str) -> None:
    kind = small_talk_of(from_short(words))
    assert (kind.name if kind is not None else "") == name


@pytest.mark.parametrize(
    "text, code",
    [
        (FILE.replace("reply", "answer"), "UNKNOWN_KEY"),
        (FILE.replace("pattern: thanks", "pattern: '<thx>'"), "UNKNOWN_CLASS"),
        (FILE.replace("pattern: thanks", "pattern: 'thanks('"), "BAD_PATTERN"),
    ],
)
def test_mistakes_are_reported(text: str, code: str) -> None:
    assert load_small_talk(FILE, "talk.yaml")[0].reply == "You are welcome."
    with pytest.raises(FileRefused) as refused:
        load_small_talk(text, "talk.yaml")
    assert code in [problem.code for problem in refused.value.problems]


@pytest.mark.parametrize(
    "text, code, sentence",
    [
        ("Thank you for your help.", "TALK", "You are welcome."),
        ("Sorry about that.", "TALK", "That is all right."),
        ("Yes.", "TALK", "I have no open question."),
        ("Help me.", "TALK", 'Ask me: "What can you do?".'),
        ("No.", "CORRECTION", "All right, I do nothing."),
    ],
)
def test_replies(understand, text: str, code: str, sentence: str) -> None:
    outcome, _ = understand(text)
    assert outcome == Refusal(code, sentence)


def test_yes_still_answers_a_question(understand) -> None:
    question, context = understand("Move forward.")
    outcome, _ = understand("ten feet", context)
    assert not isinstance(outcome, Refusal), (question, outcome)
