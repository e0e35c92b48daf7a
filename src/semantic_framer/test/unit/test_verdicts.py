"""The tables of verdicts: every one is named, has a reason, and stands in the README."""

from pathlib import Path

from semantic_framer.judging.sentence_verdicts import REST_VERDICTS, SENTENCE_VERDICTS
from semantic_framer.judging.verdicts import CLAUSE_VERDICTS, DOMINATED, PLAUSIBILITY, READING_VERDICTS

README = Path(__file__).resolve().parents[2] / "README.md"
IN_ORDER = (
    [(verdict, "sentence") for verdict in SENTENCE_VERDICTS]
    + [(verdict, "clause") for verdict in CLAUSE_VERDICTS]
    + [(verdict, "reading") for verdict in PLAUSIBILITY + DOMINATED + READING_VERDICTS]
    + [(verdict, "sentence") for verdict in REST_VERDICTS]
)


def test_order() -> None:
    assert [verdict.name for verdict, _ in IN_ORDER] == (
        "asks_for_nothing another_time no_verb negated condition_without_verb unknown_verb "
        "noun_of_another_verb measured_elsewhere miscounted joined_to_a_listed_word unread_elsewhere "
        "asked_about_elsewhere "
        "number_is_no_place one_place two_phrases "
        "subject_of_a_question way_is_no_place wisher_is_not_sought degree_is_no_thing "
        "side_is_no_thing side_of_the_place_before deed_is_no_thing "
        "listed_elsewhere says_less report performer nothing_fits condition verb_class "
        "incomplete less_likely_asked wrong_type leaves_more_over doubtful_type lists_less told_inside words_outside"
    ).split()


def test_readme_lists_every_verdict_in_its_order() -> None:
    rows = [line for line in README.read_text(encoding="utf-8").splitlines() if line.startswith("| `")]
    expected = [f"| `{verdict.name}` | {of} | {verdict.reason} |" for verdict, of in IN_ORDER]
    assert [row for row in rows if row in expected] == expected
