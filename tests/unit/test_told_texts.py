"""Each text that persons read or hear stands in docs/texts/english.yaml, and keeps the rules that a program can see."""

import re
from typing import Iterator, List, Tuple

import pytest
import yaml
from told_texts import KINDS, texts_of_module, texts_of_page, told_texts

from roboframenet_testing.workspace import REPOSITORY

LISTED = yaml.safe_load((REPOSITORY / "docs/texts/english.yaml").read_text(encoding="utf-8"))
#: Log lines and errors in files may have the words of engineers.
FOR_PERSONS = ("said", "asked", "page")
#: Rules of CONTRIBUTING.md, "What the robot says": what must not be found.
RULES = {
    "a contraction": re.compile(r"\b\w+n't\b|\b(I|you|we|they)'(m|re|ve|ll|d)\b|\bit's\b", re.IGNORECASE),
    "bookish, or of engineers": re.compile(r"\bheed|\bthe (user|system)\b|\bevoke", re.IGNORECASE),
    "a word twice": re.compile(r"\b(?!that\b|had\b)([a-z]+) \1\b", re.IGNORECASE),
    "'a' before a vowel": re.compile(r"\ba [aeio]\w(?<!a on)(?<!a us)", re.IGNORECASE),
    "'an' before a consonant": re.compile(r"\ban (?!hour|honest|SD|SHA|HTTP|XML|RFN|NaN)[bcdfgjklmnpqrstvwxyz]"),
    "two blanks": re.compile(r"\S {2,}\S"),
    "a blank before a mark": re.compile(r"\w [,;.!?](?!\.)(\s|$)"),
}


def listed(*kinds: str) -> Iterator[Tuple[str, str]]:
    return ((place, text) for kind in kinds for place, texts in LISTED[kind].items() for text in texts)


def test_the_list_is_that_of_the_code() -> None:
    """If this fails: run scripts/texts, and read what has changed."""
    told = told_texts()
    assert set(LISTED) == set(KINDS) == set(told)
    for kind in KINDS:
        assert LISTED[kind] == told[kind], f"run scripts/texts: {kind}"


def test_it_lists_what_all_packages_that_reply_say() -> None:
    """The list is made by a program, which must not lose a kind of text."""
    texts = {text for _, text in listed(*KINDS)}
    for known in (
        "A newer command took its place.",
        'I know "{verb}", but not used like this.',
        "What should I point at?",
        "I have no open question.",
        "no data on %s yet; answers omit it",
        "No connection to the robot. Trying again ... Until then this page cannot stop it.",
        "Tell the robot what to do",
        "did not end within {execution_s} s",
    ):
        assert known in texts


@pytest.mark.parametrize("rule", RULES)
def test_texts_for_persons_keep_the_rule(rule: str) -> None:
    wrong = [text for _, text in listed(*FOR_PERSONS) if RULES[rule].search(text)]
    assert not wrong


@pytest.mark.parametrize(
    ("rule", "text"),
    [
        ("a contraction", "I don't know."),
        ("a contraction", "I'm here."),
        ("bookish, or of engineers", "No server heeds it."),
        ("a word twice", "I hold the the cup."),
        ("'a' before a vowel", "I see a apple."),
        ("'an' before a consonant", "I see an pear."),
        ("two blanks", "I see  it."),
        ("a blank before a mark", "I see it , there."),
    ],
)
def test_rules_find_what_breaks_them(rule: str, text: str) -> None:
    assert RULES[rule].search(text)


@pytest.mark.parametrize(
    ("code", "told"),
    [
        ('reply = "I am stuck."', [("said", "I am stuck.")]),
        ("reply = f\"I see {one.name}: {', '.join(found)}.\"", [("said", "I see {name}: {found}.")]),
        ("reply = f\"There {'is' if one else 'are'} {count} of them.\"", [("said", "There {is/are} {count} of them.")]),
        ('reply = "I cannot do " + "that."', [("said", "I cannot do")]),
        ('rospy.logwarn("the network is %s", state)', [("logged", "the network is %s")]),
        ('raise ValueError("the joints must be two")', [("parts", "the joints must be two")]),
        ('def f():\n    """I am a docstring."""', []),
        ('add_argument("file", help="A file of sentences.")', []),
        ('if text == "I am stuck.":\n    pass', []),
        ('WORDS = "left right ahead".split()', []),
    ],
)
def test_texts_of_a_module(code: str, told: List[Tuple[str, str]]) -> None:
    assert list(texts_of_module(code)) == told


def test_texts_of_a_page() -> None:
    assert list(texts_of_page('<p title="Holds on">Not <b>sent</b></p><!-- <p>No</p> -->', ".html")) == [
        "Not",
        "sent",
        "Holds on",
    ]
    assert list(texts_of_page('say("Not sent.", `In ${n} s`, "x.y"); // "No."\n', ".js")) == ["Not sent.", "In {} s"]
