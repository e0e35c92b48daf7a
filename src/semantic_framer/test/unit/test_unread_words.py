"""The closed list of words that may go unread."""

import pytest

from checked_files import FileRefused
from semantic_framer.judging.unread_words import MOST_UNREAD_WORDS, UNREAD_WORDS_FILE, load_unread_words

_MANY = f"- {{words: [{', '.join('w' * length for length in range(1, 42))}], reason: polite}}"


def test_the_shipped_list_is_short() -> None:
    load_unread_words(UNREAD_WORDS_FILE.read_text(encoding="utf-8"), str(UNREAD_WORDS_FILE))


@pytest.mark.parametrize(
    ("text", "code"),
    [
        (_MANY, "TOO_MANY"),
        ("- {words: [please]}", "MISSING_KEY"),
        ("- {words: [please], reason: ''}", "EMPTY"),
    ],
    ids=["too many", "no reason", "an empty reason"],
)
def test_a_list_that_hides_more_is_refused(text: str, code: str) -> None:
    assert MOST_UNREAD_WORDS == 40
    with pytest.raises(FileRefused) as refused:
        load_unread_words(text, "words.yaml")
    assert [problem.code for problem in refused.value.problems] == [code]
