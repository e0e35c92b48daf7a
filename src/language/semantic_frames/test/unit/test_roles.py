"""What lexical units inherit from the roles of their frames' elements."""

import pytest

from semantic_frames import FileRefused, check_lexical_unit, load_frame, load_lexical_units
from semantic_frames.lexical_unit import ArgumentForm
from semantic_frames.roles import load_roles, roles, with_inherited

DOCKING = load_frame(
    """\
name: docking
framenet: Arriving
frame_elements:
  - name: goal
    is_core: True
  - name: theme
  - name: vehicle
  - {name: direction, values: [left, right]}
  - {name: distance, quantity: length, unit_element: distance_unit}
  - name: distance_unit
""",
    "docking.yaml",
)
GRASPING = load_frame(
    "name: grasping\nframenet: Manipulation\nframe_elements:\n  - {name: entity, is_core: True}\n  - name: source\n",
    "grasping.yaml",
)


def relations(text: str, frame=DOCKING):
    """The relations of a unit with what it inherits, by the names of the elements."""
    (unit,) = load_lexical_units(text, "unit.yaml")
    assert check_lexical_unit(unit, {frame.name: frame}) == []
    found = {}
    for relation in with_inherited(unit, frame).relations:
        found.setdefault(relation.name, []).append(relation)
    return found


def names(found):
    return [str(path) for relation in found for path in relation.relations]


def test_a_unit_of_a_frame_and_a_verb_has_the_relations_of_the_roles() -> None:
    found = relations("frame_name: docking\nverb: dock")
    assert "prep_to" in names(found["goal"]) and found["goal"][0].argument is ArgumentForm.PHRASE
    assert names(found["theme"]) == ["nsubj"] and found["theme"][0].words == ("you", "u")
    assert found["direction"][0].words == ("left", "right")
    assert names(found["distance"]) == names(found["distance_unit"]) == ["measure"]
    # No role of the file, and not core: only its unit could say how it is filled.
    assert "vehicle" not in found


def test_a_core_element_without_usual_grammar_is_the_object() -> None:
    found = relations("frame_name: grasping\nverb: grasp", GRASPING)
    assert names(found["entity"]) == ["dobj"]
    assert "prep_from" in names(found["source"])


def test_a_unit_says_what_is_special() -> None:
    text = """\
frame_name: docking
verb: dock
elements:
  goal: [prep_at, prep_on]
  theme: none
  direction: {required: True}
  vehicle:
    - {relation: prep_with, semantic_type: Vehicle}
    - {relation: dobj, words: [it]}
"""
    found = relations(text)
    assert names(found["goal"]) == ["prep_at", "prep_on"]
    assert "theme" not in found
    assert found["direction"][0].is_required and "advmod" in names(found["direction"])
    assert [relation.semantic_types for relation in found["vehicle"]] == [("Vehicle",), ()]
    assert [relation.argument for relation in found["vehicle"]] == [ArgumentForm.PHRASE, ArgumentForm.HEAD]


def test_place_stands_for_all_prepositions_of_place() -> None:
    found = relations("frame_name: docking\nverb: dock\nelements:\n  goal: [prep_to, place]\n  vehicle: nsubj/place")
    assert {"prep_to", "prep_on", "prep_in_front_of", "prep_underneath"} <= set(names(found["goal"]))
    assert "nsubj/prep_on" in names(found["vehicle"])


def test_a_unit_that_lists_its_relations_inherits_nothing() -> None:
    text = "frame_name: docking\nverb: dock\nframe_element_grammatical_relations:\n  - {name: goal, relation: prep_at}"
    found = relations(text)
    assert list(found) == ["goal"] and found["goal"][0].argument is ArgumentForm.HEAD


def test_elements_are_filled_in_the_order_of_the_roles() -> None:
    # "To the left" is a direction before it is a goal.
    order = list(relations("frame_name: docking\nverb: dock"))
    assert order.index("direction") < order.index("goal")


@pytest.mark.parametrize(
    ("text", "code", "line", "key"),
    [
        ("elements:\n  speed: dobj", "UNKNOWN_ELEMENT", 4, "elements"),
        ("elements:\n  vehicle: {required: True}", "NO_USUAL_RELATION", 4, "elements.vehicle"),
        ("elements:\n  goal: none", "CORE_NOT_FILLED", 1, "frame_element_grammatical_relations"),
    ],
)
def test_what_does_not_fit_the_frame_is_a_problem(text: str, code: str, line: int, key: str) -> None:
    (unit,) = load_lexical_units(f"frame_name: docking\nverb: dock\n{text}", "unit.yaml")
    assert [(one.code, one.line, one.key) for one in check_lexical_unit(unit, {"docking": DOCKING})] == [
        (code, line, key)
    ]


@pytest.mark.parametrize(
    ("text", "code", "line"),
    [
        ("elements:\n  goal: prep_at\nframe_element_grammatical_relations: []", "INHERITS_NOTHING", 4),
        ("elements:\n  goal: prep_at\n  goal: prep_on", "DUPLICATE_KEY", 5),
        ("elements:\n  goal: {relation: prepat}", "UNKNOWN_RELATION", 4),
        ("elements:\n  goal: {relations: prep_at}", "UNKNOWN_KEY", 4),
        ("elements: [goal]", "WRONG_TYPE", 3),
        ("examples:\n  Dock.: {}\n  Dock.: {}", "DUPLICATE_KEY", 5),
    ],
)
def test_a_wrong_file_is_refused(text: str, code: str, line: int) -> None:
    with pytest.raises(FileRefused) as refused:
        load_lexical_units(f"frame_name: docking\nverb: dock\n{text}", "unit.yaml")
    assert [(problem.code, problem.line) for problem in refused.value.problems] == [(code, line)]


def test_examples_may_be_a_mapping() -> None:
    (unit,) = load_lexical_units(
        'frame_name: docking\nverb: dock\nexamples:\n  Dock at the pad.: {goal: the pad}\n  "Robo, dock": {}', "u.yaml"
    )
    assert [(one.text, dict(one.frame_elements), one.line) for one in unit.examples] == [
        ("Dock at the pad.", {"goal": "the pad"}, 4),
        ("Robo, dock", {}, 5),
    ]


def test_an_element_of_a_frame_of_framenet_has_the_role_of_its_name() -> None:
    assert DOCKING.roles >= {"Goal", "Theme"}
    old = load_frame("name: going\nframe_elements:\n  - name: goal\n", "going.yaml")
    assert old.roles == {""}


def test_an_element_takes_what_its_role_takes_if_its_frame_says_nothing() -> None:
    frame = load_frame(
        "name: a\nframenet: Giving\nframe_elements:\n  - name: recipient\n  - {name: goal, semantic_type: Room}\n"
        "  - {name: path, values: [left, right]}\n",
        "a.yaml",
    )
    assert [element.semantic_types for element in frame.frame_elements] == [("Sentient", "Organization"), ("Room",), ()]
    question = load_frame("name: a\nframenet: A\nis_question: True\nframe_elements:\n  - name: goal\n", "a.yaml")
    assert question.frame_elements[0].semantic_types == ()


def test_a_wrong_file_of_roles_is_refused() -> None:
    with pytest.raises(FileRefused) as refused:
        load_roles("- {role: Goal}\n- {role: Theme, relation: objekt}", "roles.yaml")
    assert [problem.code for problem in refused.value.problems] == ["UNKNOWN_RELATION"]


def test_roles_are_names_of_framenet() -> None:
    assert all(name[:1].isupper() for role in roles() for name in role.names)
