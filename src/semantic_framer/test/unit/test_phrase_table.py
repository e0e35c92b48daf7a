"""The longest phrase wins, and its first word finds it."""

from typing import Dict, List, Optional, Tuple

from hypothesis import given
from hypothesis import strategies as st

from semantic_framer.values.phrase_table import Phrase, PhraseTable

WORDS = st.sampled_from(["at", "the", "most", "moment"])
PHRASES = st.dictionaries(st.lists(WORDS, min_size=1, max_size=3).map(tuple), st.integers())


def longest(meanings: Dict[Phrase, int], said: List[str]) -> Tuple[Optional[int], int]:
    """Return what the table shall return, found by trying every phrase."""
    fitting = [phrase for phrase in meanings if tuple(said[: len(phrase)]) == phrase]
    best = max(fitting, key=len, default=())
    return (meanings[best], len(best)) if best else (None, 0)


@given(PHRASES, st.lists(WORDS, max_size=4))
def test_the_longest_phrase_at_the_front_is_found(meanings: Dict[Phrase, int], said: List[str]) -> None:
    assert PhraseTable(meanings).at(said) == longest(meanings, said)


def test_phrases_of_a_first_word_come_longest_first() -> None:
    table = PhraseTable({("at",): 1, ("at", "the", "moment"): 3, ("at", "most"): 2})
    assert table.begins_with("at") == [(("at", "the", "moment"), 3), (("at", "most"), 2), (("at",), 1)]
    assert not table.begins_with("moment")
