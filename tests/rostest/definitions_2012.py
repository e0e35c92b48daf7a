"""The action and the services as a program of 2012 has them, generated from their text alone."""

from typing import Any

from genpy.dynamic import generate_dynamic

LINE = "=" * 80
ACTION_NAME = "roboframenet_msgs/FilledSemanticFrameAction"
#: The MD5 sum that was published in 2012.
ACTION_SUM = "155f2082a80e8d33020a74c63f2ac0f6"
FRAME = """string name
FilledFrameElement[] frame_elements
string[] action_server_topics
"""
ACTION = f"""FilledSemanticFrameActionGoal action_goal
FilledSemanticFrameActionResult action_result
FilledSemanticFrameActionFeedback action_feedback
{LINE}
MSG: roboframenet_msgs/FilledSemanticFrameActionGoal
Header header
actionlib_msgs/GoalID goal_id
FilledSemanticFrameGoal goal
{LINE}
MSG: roboframenet_msgs/FilledSemanticFrameActionResult
Header header
actionlib_msgs/GoalStatus status
FilledSemanticFrameResult result
{LINE}
MSG: roboframenet_msgs/FilledSemanticFrameActionFeedback
Header header
actionlib_msgs/GoalStatus status
FilledSemanticFrameFeedback feedback
{LINE}
MSG: roboframenet_msgs/FilledSemanticFrameGoal
FilledSemanticFrame frame
{LINE}
MSG: roboframenet_msgs/FilledSemanticFrameResult
bool success
{LINE}
MSG: roboframenet_msgs/FilledSemanticFrameFeedback
bool is_succeeding
{LINE}
MSG: roboframenet_msgs/FilledSemanticFrame
{FRAME}{LINE}
MSG: roboframenet_msgs/FilledFrameElement
string name
string argument
{LINE}
MSG: actionlib_msgs/GoalID
time stamp
string id
{LINE}
MSG: actionlib_msgs/GoalStatus
GoalID goal_id
uint8 status
uint8 PENDING=0
uint8 ACTIVE=1
uint8 PREEMPTED=2
uint8 SUCCEEDED=3
uint8 ABORTED=4
uint8 REJECTED=5
uint8 PREEMPTING=6
uint8 RECALLING=7
uint8 RECALLED=8
uint8 LOST=9
string text
{LINE}
MSG: std_msgs/Header
uint32 seq
time stamp
string frame_id
"""
EMPTY_FRAME = f"""EmptySemanticFrame frame
{LINE}
MSG: roboframenet_msgs/EmptySemanticFrame
string name
EmptyFrameElement[] frame_elements
{LINE}
MSG: roboframenet_msgs/EmptyFrameElement
string name
string default
bool is_core
"""
MESSAGES = {name.split("/")[1]: message for name, message in generate_dynamic(ACTION_NAME, ACTION).items()}
FilledSemanticFrameAction = MESSAGES["FilledSemanticFrameAction"]
FilledSemanticFrameActionGoal = MESSAGES["FilledSemanticFrameActionGoal"]
FilledSemanticFrameGoal = MESSAGES["FilledSemanticFrameGoal"]
FilledSemanticFrameFeedback = MESSAGES["FilledSemanticFrameFeedback"]
FilledSemanticFrameResult = MESSAGES["FilledSemanticFrameResult"]
FilledSemanticFrame = MESSAGES["FilledSemanticFrame"]
FilledFrameElement = MESSAGES["FilledFrameElement"]


def _service(name: str, md5sum: str, request: str, response: str) -> Any:
    parts = {
        part: generate_dynamic(f"roboframenet_msgs/{name}{part}", text)[f"roboframenet_msgs/{name}{part}"]
        for part, text in (("Request", request), ("Response", response))
    }
    members = {
        "_type": f"roboframenet_msgs/{name}",
        "_md5sum": md5sum,
        "_request_class": parts["Request"],
        "_response_class": parts["Response"],
    }
    return type(name, (), members)


AddFrame = _service("AddFrame", "cb6a241b274ea486767393c609cdf1cb", "string absolute_file_path\n", "bool success\n")
AddLexicalUnit = _service(
    "AddLexicalUnit", "cb6a241b274ea486767393c609cdf1cb", "string absolute_file_path\n", "bool success\n"
)
GetEmptyFrame = _service("GetEmptyFrame", "04219de4717ce8422705fc0a0c034202", "string frame_name\n", EMPTY_FRAME)
RegisterWithFrame = _service(
    "RegisterWithFrame",
    "d8348aca95ebc2a23cee1717f1fa3def",
    "string frame_name\nstring callback_topic\n",
    "bool success\nstring[] error\n",
)
