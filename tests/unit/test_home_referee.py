"""The referee of commands in the home knows right from wrong, and finds our own commands right."""

from dataclasses import replace

import pytest
from home_referee.annotated import read_annotated, slots_of
from home_referee.commands import Command, draw
from home_referee.direct_run import DirectRun
from home_referee.judging import Run, Saying, Verdict, judge
from home_referee.logical_forms import Description, Form, NotInThisHome, read_form
from home_referee.walking import Walk

SPEAKER = "alice"
GRAMMAR = """
$Main = $bring | find the {object} in the {room}
$bring = carry the {object} to {name 1} at the {beacon 1}
"""
SEMANTICS = """
carry the {object} to {name 1} at the {beacon 1} = (bring (λ$1:e (is_a $1 {object})) (λ$1:e (person $1)))
find the {object} in the {room} = (find (λ$1:e (is_a $1 {object}) (at $1 {room})))
find the {object} that {gesture} = (find (λ$1:e (is_a $1 {object}) (waves $1)))
""".lstrip()


@pytest.fixture(scope="module")
def slots():
    return slots_of("", speaker=SPEAKER)


@pytest.fixture(scope="module")
def runs():
    return DirectRun(speaker=SPEAKER)


def apple_to_bob(**changes):
    command = Command(
        "Carry the apple to Bob at the sofa.",
        Form("bring", (Description(is_a="apple"), Description(name="bob", at="sofa", is_person=True))),
        "test",
        {"bob": "at sofa standing"},
    )
    before = {"apple.place": "on kitchen_table", "bathroom_door.is_open": False, "book.place": "on bookshelf"}
    before.update({"robot.room": "hall", "bob.room": "living_room", "bob.posture": "standing"})
    for person in ("anna", "alice"):
        before.update({f"{person}.room": "hall", f"{person}.posture": "standing"})
    after = {**before, "apple.place": "held bob", **changes.pop("after", {})}
    values = {"outcome": "DONE", "sentence": "Done.", **changes}
    return Run(command, before, after, (), **values)


def test_forms_are_read():
    form = read_form("(put (λ$1:e (and (is_a $1 apple) (at $1 desk))) sofa)")
    assert form == Form("put", (Description(is_a="apple", at="desk"), "sofa"))
    form = read_form('(say "the time" (λ$1:e (person $1)(name $1 bob)))')
    assert form == Form("say", ("the time", Description(name="bob", is_person=True)))
    with pytest.raises(NotInThisHome, match="leftmost"):
        read_form("(bring (λ$1:e (leftmost $1)))")


def test_commands_have_forms_with_ids_of_the_home(tmp_path, slots):
    (tmp_path / "X_grammar.txt").write_text(GRAMMAR, encoding="utf-8")
    (tmp_path / "X_semantics.txt").write_text(SEMANTICS, encoding="utf-8")
    commands, left_out = draw(str(tmp_path), slots, count=8, seed=1)
    assert len({one.text for one in commands}) == 8
    assert {one.form.predicate for one in commands} == {"bring", "find"}
    for one in commands:
        assert one.form.things[0].is_a in slots.home["things"]
    assert len(left_out) == 1
    assert commands == draw(str(tmp_path), slots, count=8, seed=1)[0]


@pytest.mark.parametrize(
    "changes, verdict",
    [
        ({}, Verdict.RIGHT),
        ({"after": {"apple.place": "held anna"}}, Verdict.WRONG),
        ({"after": {"apple.place": "on kitchen_table"}}, Verdict.WRONG),
        ({"after": {"book.place": "held robot"}}, Verdict.WRONG),
        ({"after": {"bathroom_door.is_open": True}}, Verdict.WRONG),
        ({"after": {"apple.place": "on kitchen_table"}, "outcome": "NEEDS_INFORMATION"}, Verdict.ASKED),
        (
            {
                "after": {"apple.place": "held robot"},
                "outcome": "FAILED",
                "sentence": "The kitchen door is blocked.",
                "reasons": ("The kitchen door is blocked.",),
            },
            Verdict.FAILED,
        ),
        ({"after": {"apple.place": "held robot"}, "outcome": "FAILED", "sentence": "I cannot."}, Verdict.UNTOLD),
        ({"outcome": "FAILED"}, Verdict.UNTOLD),
    ],
)
def test_verdicts(slots, changes, verdict):
    assert judge(apple_to_bob(**changes), slots).verdict is verdict


def test_what_is_said_must_be_heard_by_whom_it_is_for(slots):
    run = apple_to_bob(after={"apple.place": "on kitchen_table"})
    form = read_form('(say "the time" (λ$1:e (person $1)(name $1 bob)))')
    run = replace(run, command=replace(run.command, form=form), sayings=(Saying("It is 9:30.", ("anna",)),))
    assert judge(run, slots).verdict is Verdict.WRONG
    assert judge(replace(run, sayings=(Saying("It is 9:30.", ("bob",)),)), slots).verdict is Verdict.RIGHT


def test_who_is_followed_waits_until_the_robot_has_met_them():
    form = read_form("(follow (λ$1:e (person $1)(name $1 bob)))")
    walk = Walk(Command("Follow Bob.", form, "test"))
    truth = {"bob.is_near": True, "bob.posture": "standing", "bob.room": "kitchen", "robot.room": "hall"}
    truth["robot.looks_at"] = "bob"
    assert {walk.order(truth) for _ in range(100)} == {""}
    truth["robot.room"] = "kitchen"
    assert {walk.order({**truth, "robot.looks_at": "counter"}) for _ in range(100)} == {""}
    orders = [walk.order(truth) for _ in range(100)]
    assert [order for order in orders if order] == ["bob walk living_room"]


@pytest.mark.parametrize("command", read_annotated()[:5], ids=lambda one: one.text)
def test_some_of_our_commands(runs, slots, command):
    judged = judge(runs.run(command), slots)
    assert judged.verdict is Verdict.RIGHT, judged.reasons


@pytest.mark.acceptance
@pytest.mark.parametrize("command", read_annotated(), ids=lambda one: one.text)
def test_our_commands(runs, slots, command):
    judged = judge(runs.run(command), slots)
    assert judged.verdict is Verdict.RIGHT, judged.reasons
