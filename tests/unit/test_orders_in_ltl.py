"""Orders of visits that were written from LTL formulas, and what the robot would do, judged by the formulas."""

from collections import Counter

import pytest
from visit_orders.judging import FIRST, RIGHT, SECOND, WRONG, judged, rows
from visit_orders.ltl import Lasso, holds
from visit_orders.simulated_robot import Again, InAnyOrder, InOrder, NoWay, Visit, runs_of

HALL = frozenset(["hall"])


def test_all_styles_say_all_patterns():
    styles = Counter(row.style for row in rows())
    assert len(styles) == 10
    assert set(styles.values()) == {20}
    assert len({row.sentence for row in rows()}) == 200


@pytest.mark.parametrize(("table", "least_right"), [(FIRST, 163), (SECOND, 54)])
def test_orders_are_done_as_a_whole_or_not_at_all(pipeline, table, least_right):
    verdicts = {row: judged(pipeline, row) for row in rows(table)}
    counts = Counter(verdict for verdict, _ in verdicts.values())
    wrong = {row.sentence: why for row, (verdict, why) in verdicts.items() if verdict == WRONG}
    assert not wrong
    assert counts[RIGHT] >= least_right, counts


@pytest.mark.parametrize(
    ("formula", "states", "loop", "is_true"),
    [
        ("F ab", ["", "ab"], 1, True),
        ("F ab", ["", "cd"], 1, False),
        ("G F ab", ["ab", "", "ab"], 1, True),
        ("G F ab", ["ab", ""], 1, False),
        ("!cd U ab", ["", "ab", "cd"], 2, True),
        ("!cd U ab", ["", "cd", "ab"], 2, False),
        ("!cd U ab", ["", ""], 1, False),
        ("F (ab & X F ab)", ["ab", "", "ab", ""], 3, True),
        ("F (ab & X F ab)", ["", "ab", ""], 2, False),
        ("ab -> X cd | ab & cd", ["ab", "cd"], 1, True),
        ("ab -> X cd | ab & cd", ["ab", ""], 1, False),
        ("X X X ab", ["ab", ""], 0, False),
        ("X X X X ab", ["ab", ""], 0, True),
    ],
)
def test_truth_of_a_formula(formula, states, loop, is_true):
    assert holds(formula, Lasso(tuple(frozenset(state.split()) for state in states), loop)) is is_true


@pytest.mark.parametrize("formula", ["", "F", "ab )", "(ab", "ab % cd", "Z ab"])
def test_malformed_formula_is_refused(formula):
    with pytest.raises(ValueError, match=r"."):
        holds(formula, Lasso((frozenset(),), 0))


def satisfies(order, formula):
    return all(holds(formula, run) for run in runs_of(order))


def test_robot_goes_through_each_room_that_is_not_to_be_avoided():
    assert not satisfies(Visit("garage"), "!in_hall U garage")
    assert satisfies(Visit("garage", HALL), "!in_hall U garage")
    assert not satisfies(Visit("garage", HALL), "!in_kitchen U garage")


def test_robot_chooses_what_is_left_open():
    parts = (Visit("office"), Visit("garage"))
    assert satisfies(InOrder(parts), "!garage U office")
    assert not satisfies(InAnyOrder(parts), "!garage U office")


def test_repetition_ends_or_never_ends():
    assert satisfies(Again(Visit("office")), "G F office")
    assert not satisfies(Again(Visit("office"), 2), "G F office")
    assert satisfies(InOrder((Again(Visit("office")), Visit("garage"))), "G !garage")


def test_no_way_is_left():
    with pytest.raises(NoWay):
        list(runs_of(Visit("hall", HALL)))
