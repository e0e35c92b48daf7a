"""The bindings that ``rfn bind`` writes."""

from frame_bindings.binding_file import load_bindings
from rfnserver.goal_binding import BoundElement
from rfnserver.goal_types import GoalField
from roboframenet_tools.binding_text import binding_text, frames_that_fit

ORDER = GoalField("order", "int32", {})
POSE = GoalField("target_pose", "geometry_msgs/PoseStamped", {})
PATH = GoalField("path", "nav_msgs/Path", {})
GOING = (BoundElement("goal", is_core=True), BoundElement("manner", is_core=False))


def text_of(fields, elements, target="server"):
    return binding_text(
        frame_name="going", elements=elements, kind="action", target=target, type_name="pkg/GoAction", fields=fields
    )


def test_place_is_guessed():
    text, fault = text_of((POSE, PATH), GOING)
    (binding,) = load_bindings(text, "bindings.yaml").bindings
    assert fault is None
    assert (binding.frame_name, binding.target, binding.fields) == ("going", "server", {"target_pose": "goal"})


def test_same_names_and_what_keeps_its_default():
    text, fault = text_of((ORDER, GoalField("speed", "float64", {})), (BoundElement("order", is_core=True),))
    (binding,) = load_bindings(text, "bindings.yaml").bindings
    assert (fault, binding.fields) == (None, {"order": "order"})
    assert "# speed: float64, keeps its default" in text


def test_only_a_string_takes_any_words():
    element = (BoundElement("device", is_core=True),)
    assert text_of((GoalField("name", "string", {}),), element)[1] is None
    assert "'device' fills no field" in text_of((GoalField("data", "bool", {}),), element)[1]


def test_what_cannot_be_guessed_is_said():
    text, fault = text_of((PATH,), GOING)
    assert "'goal' fills no field" in fault
    assert f"# {fault}" in text
    load_bindings(text, "bindings.yaml")


def test_server_with_the_name_of_its_frame_gets_another_name():
    text, _ = text_of((POSE,), GOING, target="/going")
    (binding,) = load_bindings(text, "bindings.yaml").bindings
    assert (binding.name, binding.target) == ("going_binding", "/going")


def test_frames_that_fit_are_offered():
    frames = {"going": GOING, "counting": (BoundElement("order", is_core=True),), "waiting": ()}
    assert frames_that_fit((POSE,), frames) == ("going",)
