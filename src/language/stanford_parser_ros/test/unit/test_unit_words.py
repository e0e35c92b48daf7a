"""What the parser learns from lexical units and their frames, each file once."""

import pytest

from semantic_frames import load_frame, load_lexical_units
from stanford_parser_ros import unit_words
from stanford_parser_ros.joint.lexicon_hints import Hint, Use
from stanford_parser_ros.unit_words import UnitWords

FRAME = load_frame("name: crawling\nframenet: Self_motion\nframe_elements:\n  - name: path\n", "crawling.yaml")
CRAWL = load_lexical_units("frame_name: crawling\nverb: crawl over", "crawl.yaml")
VACUUM = load_lexical_units("frame_name: vacuuming\nverb: vacuum", "vacuum.yaml")
THROUGH = Hint("crawl over", Use.PREPOSITION, "through")


def test_words_come_from_units_and_from_the_roles_of_their_frames() -> None:
    words = UnitWords()
    assert THROUGH not in words.of([CRAWL, VACUUM], {}).hints
    known = words.of([CRAWL, VACUUM], {"crawling": FRAME})
    assert known.verbs == {"crawl", "vacuum"} and {"crawl", "vacuum"} <= known.spellings
    assert THROUGH in known.hints


def test_a_file_that_is_gone_is_forgotten() -> None:
    words = UnitWords()
    assert words.of([CRAWL, VACUUM], {}).verbs == {"crawl", "vacuum"}
    assert words.of([VACUUM], {}).verbs == {"vacuum"}


def test_only_what_is_new_is_learned(monkeypatch: pytest.MonkeyPatch) -> None:
    learned = []
    learn = unit_words._words_of
    monkeypatch.setattr(unit_words, "_words_of", lambda units, frames: learned.append(units) or learn(units, frames))
    words = UnitWords()
    words.of([CRAWL], {})
    words.of([CRAWL, VACUUM], {})
    words.of([CRAWL, VACUUM], {"crawling": FRAME})
    words.of([CRAWL, VACUUM], {"crawling": FRAME})
    assert learned == [CRAWL, VACUUM, CRAWL]
