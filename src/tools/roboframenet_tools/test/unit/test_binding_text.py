"""The bindings that ``rfn bind`` writes."""

from frame_bindings.binding_file import load_bindings
from rfnserver.goal_binding import BoundElement
from rfnserver.goal_types import GoalField
from roboframenet_tools.binding_text import binding_text, frames_that_fit, guessed_fields, words_of

ORDER = GoalField("order", "int32", {})
POSE = GoalField("target_pose", "geometry_msgs/PoseStamped", {})
PATH = GoalField("path", "nav_msgs/Path", {})
GOING = (BoundElement("goal", is_core=True), BoundElement("manner", is_core=False))


def text_of(fields, elements, target="server"):
    return binding_text(
        frame_name="going", elements=elements, kind="action", target=target, type_name="pkg/GoAction", fields=fields
    )


def test_field_of_another_name_is_only_guessed():
    text, fault = text_of((POSE, PATH), GOING)
    (binding,) = load_bindings(text, "bindings.yaml").bindings
    assert "I only guess target_pose by 'goal'" in fault
    assert (binding.frame_name, binding.target, binding.fields) == ("going", "server", {})
    (binding,) = load_bindings(text.replace("# target_pose", "target_pose"), "bindings.yaml").bindings
    assert binding.fields == {"target_pose": "goal"}


def test_place_comes_before_a_string():
    looking = (BoundElement("phenomenon", is_core=True), BoundElement("duration", is_core=False))
    head = (GoalField("target", "geometry_msgs/PointStamped", {}), GoalField("pointing_frame", "string", {}))
    assert guessed_fields(head, looking) == {"target": "phenomenon"}
    assert guessed_fields((*head, POSE), looking) == {"pointing_frame": "phenomenon"}
    assert guessed_fields((*head, POSE), GOING) == {"pointing_frame": "goal"}


def test_same_names_and_what_keeps_its_default():
    text, fault = text_of((ORDER, GoalField("speed", "float64", {})), (BoundElement("order", is_core=True),))
    (binding,) = load_bindings(text, "bindings.yaml").bindings
    assert (fault, binding.fields) == (None, {"order": "order"})
    assert "# speed: float64, keeps its default" in text


def test_only_a_string_takes_any_words():
    element = (BoundElement("device", is_core=True),)
    assert "I only guess name by 'device'" in text_of((GoalField("name", "string", {}),), element)[1]
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
    assert frames_that_fit((ORDER,), frames) == ("counting",)


def test_frames_are_ranked_by_the_words_of_the_server():
    looking = (BoundElement("phenomenon", is_core=True),)
    frames = {f"condition_of_{n}": (BoundElement("target", is_core=True),) for n in range(9)}
    frames = {**frames, "pointing": GOING, "perceiving": looking, "waiting": (), "turning_head": looking}
    field = GoalField("target", "geometry_msgs/PointStamped", {})
    words = words_of("point_head_follow_action", "control_msgs/PointHeadAction", "target")
    offered = frames_that_fit((field,), frames, words=words, verbs={"perceiving": ["look", "follow"]})
    assert set(offered[:3]) == {"pointing", "perceiving", "turning_head"}
    assert len(offered) == 5


def test_words_of_names():
    assert words_of("point_head_action", "pkg_msgs/SetGripperGoal", "holdTime") == {
        *("point", "head", "pkg", "gripper", "hold", "time")
    }
    assert "wink" in words_of("winking_server")
