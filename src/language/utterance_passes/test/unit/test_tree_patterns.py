"""Words for trees: governors, phrases, prepositions, subjects, and patterns of words that stand to each other."""

from typing import List

import pytest

from utterance_passes.trees.conllu import from_short
from utterance_passes.trees.tree_patterns import OPERATORS, Rehang, Sought, TreePattern, rehung

#: "The robot brings cups from under tables quickly".
TREE = from_short(
    "The|DET|2|det robot|NOUN|3|nsubj brings|VERB|0|root|bring cups|NOUN|3|obj from|ADP|7|case under|ADP|7|case "
    "tables|NOUN|4|nmod quickly|ADV|3|advmod"
)
BRINGS, CUPS, TABLES = 3, 4, 7


def test_words_for_trees() -> None:
    assert TREE.word(1).said == "the"
    assert TREE.governor(TREE.word(CUPS)).said == "brings"
    assert TREE.governor(TREE.word(BRINGS)).said == "brings"
    assert (TREE.phrase_start(CUPS), TREE.phrase_end(CUPS)) == (4, 7)
    assert TREE.said_prepositions(TABLES) == ["from", "under"]
    assert (TREE.preposition(TABLES), TREE.preposition(CUPS)) == ("from", "")
    subject = TREE.subject(BRINGS)
    assert subject is not None and subject.said == "robot"
    assert TREE.subject(CUPS) is None
    assert TREE.verb_above(TREE.word(TABLES)).said == "brings"


@pytest.mark.parametrize(
    "operator, index, expected",
    [
        ("<", CUPS, "brings"),
        ("<", BRINGS, ""),
        ("<--", CUPS, "brings"),
        ("<--", 2, ""),
        ("<++", 2, "brings"),
        (">", BRINGS, "robot cups quickly"),
        (">--", BRINGS, "robot"),
        (">++", BRINGS, "cups quickly"),
        (">>", CUPS, "from under tables"),
        (".", BRINGS, "cups"),
        (".", 8, ""),
        (".*", TABLES, "quickly"),
        (";", BRINGS, "robot"),
        (";", 1, ""),
        (";*", BRINGS, "The robot"),
        ("$--", CUPS, "robot"),
        ("$++", CUPS, "quickly"),
        ("$++", BRINGS, ""),
        ("<<v", TABLES, "brings"),
        (">|", CUPS, "tables"),
        (">|", BRINGS, "quickly"),
    ],
)
def test_operators(operator: str, index: int, expected: str) -> None:
    assert " ".join(word.form for word in OPERATORS[operator](TREE, TREE.word(index))) == expected


def found(*others: Sought) -> List[List[str]]:
    pattern = TreePattern(Sought("verb", upos={"VERB"}), *others)
    return [[word.form for word in match.values()] for match in pattern.matches(TREE)]


def test_each_place_is_found() -> None:
    assert found(Sought("one", "verb", ">", deprel={"nsubj:*", "obj"})) == [["brings", "robot"], ["brings", "cups"]]
    assert found(Sought("one", "verb", ">", deprel={"obl"})) == []


def test_a_word_is_described() -> None:
    place = Sought("place", "verb", ">>", preposition={"from"})
    assert found(place) == [["brings", "tables"]]
    assert found(place, Sought("case", "place", ">", said={"under"})) == [["brings", "tables", "under"]]
    assert found(Sought("one", "verb", ">", lemma={"robot"})) == [["brings", "robot"]]


def test_a_word_may_have_to_be_alone_or_absent() -> None:
    place = Sought("place", "verb", ">>", deprel={"nmod"})
    assert found(place, Sought("case", "place", ">", deprel={"case"}, said={"from"}, is_only=True)) == []
    assert found(place, Sought("case", "place", ">", deprel={"nmod"}, is_absent=True)) == [["brings", "tables"]]
    assert found(place, Sought("case", "place", ">", deprel={"case"}, is_absent=True)) == []


def test_words_are_rehung() -> None:
    pattern = TreePattern(Sought("place", deprel={"nmod"}), Sought("verb", "place", "<<v"))
    made = rehung(TREE, pattern, Rehang("place", "obl", "verb"))
    assert (made.word(TABLES).head, made.word(TABLES).deprel) == (BRINGS, "obl")
    assert rehung(TREE, pattern, Rehang("place", "acl")).word(TABLES).head == CUPS
    assert rehung(TREE, TreePattern(Sought("place", deprel={"obl"})), Rehang("place", "nmod")) is TREE


@pytest.mark.parametrize(
    "second, fault",
    [
        (Sought("two", "one", "<>"), 'operator that does not exist: "<>"'),
        (Sought("one", "one", ">"), 'called "one"'),
        (Sought("two", "three", ">"), "beside no earlier word"),
        (Sought("two"), "beside no earlier word"),
    ],
)
def test_a_wrong_pattern_is_refused(second: Sought, fault: str) -> None:
    with pytest.raises(ValueError, match=fault):
        TreePattern(Sought("one"), second)
    with pytest.raises(ValueError, match="first word"):
        TreePattern(Sought("one", is_absent=True))
