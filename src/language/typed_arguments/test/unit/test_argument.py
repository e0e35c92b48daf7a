"""The values refuse what cannot be."""

import math
import re

import pytest
from generated_arguments import Maker

from typed_arguments import EmbeddedFrame, Measure, Modifier, TimeExpression, TypedArgument
from typed_arguments.argument import MOST_LEVELS, MOST_PHRASES
from typed_arguments.attribute_names import RELATIONS_TO_ALL
from typed_arguments.positions import with_moved_positions, without_any_position


def nested(levels):
    argument = TypedArgument(text="robot")
    for _ in range(levels - 1):
        argument = TypedArgument(text="brother", possessor=argument)
    return argument


@pytest.mark.parametrize(
    "make,part",
    [
        (lambda: Modifier(""), "no kind"),
        (lambda: Modifier("adjective", position=-1), "position"),
        (lambda: Modifier("ordinal", number=2**31), "number does not fit in 32 bits"),
        (lambda: Measure(""), "no kind"),
        (lambda: Measure("length", amount=math.nan), "amount is nan"),
        (lambda: Measure("length", si=math.inf), "si is inf"),
        (lambda: TimeExpression(""), "no kind"),
        (lambda: TimeExpression("time", begin_s=5.0), "a begin and an end, or neither"),
        (lambda: TimeExpression("time", begin_s=5.0, end_s=4.0), "no time begins at 5.0 s and ends at 4.0 s"),
        (lambda: TimeExpression("time", begin_s=0.0, end_s=4.0), "no time begins"),
        (lambda: TimeExpression("time", begin_s=1.0, end_s=2.0**32), "no time begins"),
        (lambda: TimeExpression("time", begin_s=1.0, end_s=math.nan), "end_s is nan"),
        (lambda: TimeExpression("time", offset_s=0.0), "offset"),
        (lambda: TimeExpression("time", offset_s=-(2.0**31)), "offset"),
        (lambda: TimeExpression("duration", length_s=-1.0), "takes -1.0 s"),
        (lambda: TimeExpression("set", period_s=2.0**31), "takes 2147483648.0 s"),
        (lambda: EmbeddedFrame(""), "no role"),
        (lambda: EmbeddedFrame("describes", frame_elements=(TypedArgument(text="x"),)), "no name"),
        (lambda: EmbeddedFrame("describes", positions=(3, 2)), "do not ascend"),
        (lambda: TypedArgument(positions=(0, 1)), "do not ascend from 1"),
        (lambda: TypedArgument(positions=(2, 2)), "do not ascend"),
        (lambda: TypedArgument(head_position=-1), "head position"),
        (lambda: TypedArgument(count=-1), "the count -1 is less than 0"),
        (lambda: TypedArgument(count=2**31), "count does not fit"),
        (lambda: TypedArgument(referent_count=-2), "count of referents"),
        (lambda: TypedArgument(members=(TypedArgument(),)), "a list has one member"),
        (lambda: TypedArgument(possessor=TypedArgument("owner", "Roger")), "a part fills the frame element 'owner'"),
        (lambda: TypedArgument(exceptions=(TypedArgument(),) * MOST_PHRASES), f"more than {MOST_PHRASES} phrases"),
        (lambda: nested(MOST_LEVELS + 1), f"more than {MOST_LEVELS} levels"),
    ],
)
def test_what_cannot_be_is_refused_with_the_reason(make, part):
    with pytest.raises(ValueError, match=part):
        make()


def test_largest_argument_that_may_be():
    assert TypedArgument(exceptions=(TypedArgument(),) * (MOST_PHRASES - 1)).size == MOST_PHRASES
    assert nested(MOST_LEVELS).levels == MOST_LEVELS


def test_argument_of_which_only_the_string_is_known():
    argument = TypedArgument("goal", "the table")
    assert (argument.relation, argument.count, argument.si, argument.parts) == ("", None, None, ())


def test_box_near_the_lamp_on_the_table():
    on_table = EmbeddedFrame(
        "describes",
        frame_name="being_located",
        head_element="theme",
        frame_elements=(TypedArgument("location", "the table", relation="on"),),
    )
    lamp = TypedArgument("location", "the lamp on the table", relation="near", head="lamp", frames=(on_table,))
    near_lamp = EmbeddedFrame("describes", frame_name="being_located", head_element="theme", frame_elements=(lamp,))
    box = TypedArgument("theme", "the box near the lamp on the table", head="box", frames=(near_lamp,))
    assert (box.size, box.levels) == (3, 3)
    assert box.frames[0].frame_elements[0].frames[0].frame_elements[0].relation == "on"


@pytest.mark.parametrize("seed", range(20))
def test_positions_move_with_all_parts(seed: int) -> None:
    argument = Maker(seed).argument(name="theme")
    assert with_moved_positions(argument, lambda position: position) == argument
    there = with_moved_positions(argument, lambda position: position + 3)
    assert with_moved_positions(there, lambda position: position - 3) == argument
    bare = without_any_position(argument)
    assert bare == without_any_position(there)
    assert "positions=()" in repr(bare) and not re.search(r"position(s=\([^)]|=[1-9])", repr(bare))


def test_members_that_are_meant_one_by_one_keep_what_was_said_once() -> None:
    members = (TypedArgument(text="the table"), TypedArgument(text="the bed", relation="beside"))
    listed = TypedArgument("place", "the table or beside the bed", relation="under", members=members, conjunction="or")
    assert [(one.name, one.text, one.relation) for one in listed.separate_members] == [
        ("place", "the table", "under"),
        ("place", "the bed", "beside"),
    ]


@pytest.mark.parametrize("relation", sorted(RELATIONS_TO_ALL))
def test_what_lies_between_things_has_no_separate_members(relation: str) -> None:
    members = (TypedArgument(text="the lamp"), TypedArgument(text="the vase"))
    listed = TypedArgument("goal", "the lamp and the vase", relation=relation, members=members, conjunction="and")
    assert not listed.separate_members
    assert not TypedArgument("goal", "the lamp", relation="on").separate_members
