"""Frame files: what loads, and what is said of those that do not."""

import pytest

from semantic_frames import FileRefused, load_frame
from semantic_frames.frame import ConstantArgument, ElementMapping, ListPolicy, Quantity, ValueCondition

MOVING_2012 = """\
name: moving
description: The robot moves.
frame_elements:
  - name: direction
    is_core: True
  - name: distance
    is_core: True
  - name: distance_unit
    is_core: True
children:
  - name: moving_forward
    frame_element_relations:
      - parent_name: distance
        child_name: distance
      - parent_name: direction
        child_value: [forward, forwards]
  - name: moving_backward
    frame_element_relations:
      - parent_name: direction
        child_value: backward
"""


def test_file_of_2012_loads_unchanged() -> None:
    frame = load_frame(MOVING_2012, "moving.yaml")
    assert [element.is_core for element in frame.frame_elements] == [True, True, True]
    (forward,), (backward,) = frame.children
    assert forward.frame_element_relations == (
        ElementMapping("distance", "distance"),
        ValueCondition("direction", ("forward", "forwards")),
    )
    assert backward.frame_element_relations == (ValueCondition("direction", ("backward",)),)


def test_frame_with_name_and_description_only() -> None:
    assert load_frame("name: mooing\ndescription: Moo.\n", "moo.yaml").frame_elements == ()


def test_list_among_children_is_a_sequence() -> None:
    frame = load_frame(
        "name: a\nframe_elements: [{name: x}]\nchildren:\n  - - name: b\n    - name: c\n"
        "      frame_element_relations:\n        - {parent_value: fast, child_name: speed}\n  - name: d\n",
        "a.yaml",
    )
    assert [[child.name for child in sequence] for sequence in frame.children] == [["b", "c"], ["d"]]
    assert frame.children[0][1].frame_element_relations == (ConstantArgument("fast", "speed"),)


def test_additions_are_read() -> None:
    frame = load_frame(
        "name: a\non_list: together\nconfirm: yes\nframenet: Motion\nframe_elements:\n  - name: d\n"
        "    quantity: length\n    unit_element: u\n    minimum: -1\n    maximum: 20 metres\n"
        "  - name: u\n    values: [on, off]\n    confirm: ['off']\n",
        "a.yaml",
    )
    element = frame.frame_elements[0]
    assert frame.frame_elements[1].confirmed_values == ("off",)
    assert (element.quantity, element.minimum, element.maximum) == (Quantity.LENGTH, -1.0, 20.0)
    assert frame.frame_elements[1].values == ("on", "off")
    assert (frame.on_list, frame.is_confirmed, frame.framenet) == (ListPolicy.TOGETHER, True, "Motion")


@pytest.mark.parametrize(
    "text, code, line, key",
    [
        ("", "EMPTY", 1, "file"),
        ("name: [", "NOT_YAML", 1, "file"),
        ("- a", "WRONG_TYPE", 1, "file"),
        ("description: x", "MISSING_KEY", 1, "name"),
        ("name: a\nname: b", "DUPLICATE_KEY", 2, "name"),
        ("name: a\nframe_elemnts: []", "UNKNOWN_KEY", 2, "frame_elemnts"),
        (
            "name: a\nframe_elements:\n  - name: x\n    is_core: perhaps",
            "NOT_A_BOOLEAN",
            4,
            "frame_elements[0].is_core",
        ),
        ("name: a\nframe_elements:\n  - is_core: True", "MISSING_KEY", 3, "frame_elements[0].name"),
        ("name: a\nframe_elements:\n  - name: x\n  - name: x", "DUPLICATE_ELEMENT", 4, "frame_elements[1].name"),
        (
            "name: a\nframe_elements:\n  - name: x\n    quantity: lenght",
            "UNKNOWN_VALUE",
            4,
            "frame_elements[0].quantity",
        ),
        ("name: a\nframe_elements:\n  - name: x\n    minimum: 3", "NO_QUANTITY", 4, "frame_elements[0].minimum"),
        (
            "name: a\nframe_elements:\n  - name: x\n    quantity: length\n    minimum: 3 degrees",
            "NOT_A_MEASURE",
            5,
            "frame_elements[0].minimum",
        ),
        (
            "name: a\nframe_elements:\n  - name: x\n    quantity: length\n    minimum: 3\n    maximum: 2",
            "LIMITS",
            5,
            "frame_elements[0].minimum",
        ),
        (
            "name: a\nframe_elements:\n  - name: x\n    unit_element: u",
            "UNKNOWN_ELEMENT",
            4,
            "frame_elements[0].unit_element",
        ),
        (
            "name: a\nchildren:\n  - name: b\n    frame_element_relations:\n      - {parent_name: x, child_name: y}",
            "UNKNOWN_ELEMENT",
            5,
            "children[0].frame_element_relations[0].parent_name",
        ),
        (
            "name: a\nchildren:\n  - name: b\n    frame_element_relations:\n      - {child_value: y}",
            "RELATION_FORM",
            5,
            "children[0].frame_element_relations[0]",
        ),
        (
            "name: a\nframe_elements:\n  - name: x\n    semantic_type: Contaner",
            "UNKNOWN_TYPE",
            4,
            "frame_elements[0].semantic_type",
        ),
        (
            "name: a\nframe_elements:\n  - name: x\n    semantic_type: [Human, Contaner]",
            "UNKNOWN_TYPE",
            4,
            "frame_elements[0].semantic_type[1]",
        ),
        (
            "name: a\nframe_elements:\n  - name: x\n    quantity: length\n    semantic_type: Human",
            "TYPED_QUANTITY",
            5,
            "frame_elements[0].semantic_type",
        ),
        ("name: a\nchildren:\n  - []", "EMPTY", 3, "children[0]"),
        ("name: &x a\ndescription: *x", "ALIAS", 1, "file"),
        ("name: " + "[" * 3000, "TOO_DEEP", 1, "file"),
        ("".join(" " * depth + "name:\n" for depth in range(40)), "TOO_DEEP", 21, "file"),
        ("#" * 1000001, "TOO_LARGE", 1, "file"),
        ("name: a\n---\nname: b", "NOT_YAML", 2, "file"),
    ],
)
def test_bad_file_names_code_line_and_key(text: str, code: str, line: int, key: str) -> None:
    with pytest.raises(FileRefused) as refused:
        load_frame(text, "x.yaml")
    problem = refused.value.problems[0]
    assert (problem.code, problem.line, problem.key, problem.path) == (code, line, key, "x.yaml")


def test_mistyped_key_gets_a_hint() -> None:
    with pytest.raises(FileRefused, match="did you mean 'frame_elements'"):
        load_frame("name: a\nframe_elemnts: []", "x.yaml")


def test_all_mistakes_of_a_file_are_told_at_once() -> None:
    with pytest.raises(FileRefused) as refused:
        load_frame("nmae: a\ndescripton: b\n", "x.yaml")
    assert [problem.code for problem in refused.value.problems] == ["UNKNOWN_KEY", "UNKNOWN_KEY", "MISSING_KEY"]


@pytest.mark.parametrize("name", ['"a\\nb"', '"\\e[2J"', "x" * 201])
def test_name_that_is_no_name_is_refused(name: str) -> None:
    with pytest.raises(FileRefused, match="NOT_A_NAME name"):
        load_frame(f"name: {name}\n", "x.yaml")


def test_an_element_has_semantic_types() -> None:
    text = "name: a\nframe_elements:\n  - {name: x, semantic_type: [Human, Animal]}\n  - {name: y, semantic_type: Food}"
    assert [element.semantic_types for element in load_frame(text, "").frame_elements] == [
        ("Human", "Animal"),
        ("Food",),
    ]


def test_an_unknown_semantic_type_gets_a_hint() -> None:
    with pytest.raises(FileRefused, match="did you mean 'Container'"):
        load_frame("name: a\nframe_elements:\n  - {name: x, semantic_type: Contaner}", "x.yaml")


def test_element_says_what_it_can_express() -> None:
    text = "name: a\nframe_elements: [{name: goal, relations: [on, next_to], counts: [1, 2], quantifiers: [the, all]}]"
    (element,) = load_frame(text, "a.yaml").frame_elements
    assert (element.relations, element.counts, element.quantifiers) == (("on", "next_to"), (1, 2), ("the", "all"))
    (element,) = load_frame("name: a\nframe_elements: [{name: goal, counts: 1}]", "a.yaml").frame_elements
    assert element.counts == (1,)


@pytest.mark.parametrize(
    "key, code, hint",
    [
        ("relations: [nextto]", "UNKNOWN_VALUE", "did you mean 'next_to'?"),
        ("quantifiers: [alle]", "UNKNOWN_VALUE", "did you mean 'all'?"),
        ("counts: [many]", "NOT_A_NUMBER", ""),
        ("counts: -1", "NOT_A_NUMBER", ""),
    ],
)
def test_what_cannot_be_expressed_at_all_is_refused(key: str, code: str, hint: str) -> None:
    with pytest.raises(FileRefused) as refused:
        load_frame(f"name: a\nframe_elements: [{{name: goal, {key}}}]", "a.yaml")
    assert [(problem.code, problem.hint) for problem in refused.value.problems] == [(code, hint)]


@pytest.mark.parametrize(
    "text, state, wants_yes",
    [
        ("name: a\nconfirm: True", "on", True),
        ("name: a\nframe_elements: [{name: state, confirm: ['off']}]", "Off", True),
        ("name: a\nframe_elements: [{name: state, confirm: ['off']}]", "on", False),
        ("name: a\nframe_elements: [{name: state, confirm: [Human]}]", "Anna", True),
        ("name: a\nframe_elements: [{name: state, confirm: [Animal]}]", "Anna", False),
        ("name: a\nframe_elements: [{name: state}]", "off", False),
    ],
)
def test_what_wants_a_yes(text, state, wants_yes):
    assert load_frame(text, "a.yaml").wants_yes({"state": (state, "Human")}) is wants_yes
