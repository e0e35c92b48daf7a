"""Actions in the manner of public robots, whose packages are not here; generated from their text alone."""

from typing import Any, Dict

from genpy.dynamic import generate_dynamic

LINE = "=" * 80
_COMMON = f"""{LINE}
MSG: actionlib_msgs/GoalID
time stamp
string id
{LINE}
MSG: actionlib_msgs/GoalStatus
GoalID goal_id
uint8 status
string text
{LINE}
MSG: std_msgs/Header
uint32 seq
time stamp
string frame_id
"""


def action(name: str, goal: str, result: str) -> Dict[str, Any]:
    """Return the classes of an action by their last names: "PickCubeAction", "PickCubeResult".

    Args:
        name: package and name: "robot/PickCube"
        goal: the text of its goal
        result: the text of its result; feedback is empty
    """
    parts = {"Goal": ("actionlib_msgs/GoalID goal_id", goal), "Feedback": ("actionlib_msgs/GoalStatus status", "")}
    parts["Result"] = ("actionlib_msgs/GoalStatus status", result)
    base = name.split("/")[1]
    text = "".join(f"{base}Action{part} action_{part.lower()}\n" for part in ("Goal", "Result", "Feedback"))
    for part, (head, content) in parts.items():
        text += f"{LINE}\nMSG: {name}Action{part}\nHeader header\n{head}\n{base}{part} {part.lower()}\n"
        text += f"{LINE}\nMSG: {name}{part}\n{content}\n"
    generated = generate_dynamic(f"{name}Action", text + _COMMON)
    return {full.split("/")[1]: message for full, message in generated.items()}


#: A gripper of a competition robot: its result has nothing but whether it worked.
PICK_CUBE = action("cube_picker/PickCube", "string colour", "bool success")
#: A trajectory as arms follow it: an error code with its constants, and a text.
FOLLOW_JOINTS = action(
    "arm_controller/FollowJoints",
    "string[] joint_names\nfloat64[] positions",
    "int32 error_code\nint32 SUCCESSFUL = 0\nint32 INVALID_GOAL = -1\nstring error_string",
)
