#!/usr/bin/python3
"""An action server with the definitions of 2012 and actionlib only.

It publishes the bytes of each goal that it carried out, in hexadecimal digits, on the topic "goals_2012".
"""

import os
import tempfile

import actionlib
import rospy
from std_msgs.msg import String

from definitions_2012 import (
    AddFrame,
    AddLexicalUnit,
    FilledSemanticFrameAction,
    FilledSemanticFrameActionGoal,
    FilledSemanticFrameFeedback,
    FilledSemanticFrameResult,
    RegisterWithFrame,
)

FRAME = """name: saluting
frame_elements:
  - {name: addressee, is_core: True}
  - {name: manner, is_core: False, default: plainly}
"""
UNIT = """frame_name: saluting
verb: salute
frame_element_grammatical_relations:
  - {name: addressee, relation: dobj}
"""


def write(folder: str, name: str, text: str) -> str:
    path = os.path.join(folder, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)
    return path


def main() -> None:
    """Run the node."""
    rospy.init_node("server_2012")
    received = []
    read = FilledSemanticFrameActionGoal.deserialize

    def note(goal: object, data: bytes) -> object:
        received.append(bytes(data))
        return read(goal, data)

    FilledSemanticFrameActionGoal.deserialize = note
    goals = rospy.Publisher("goals_2012", String, queue_size=10)

    def execute(goal: object) -> None:
        # A server of 2012 reads the name and the strings of a goal.
        arguments = {element.name: element.argument for element in goal.frame.frame_elements}
        rospy.loginfo("%s %s", goal.frame.name, arguments)
        goals.publish(String(data=received[-1].hex()))
        server.publish_feedback(FilledSemanticFrameFeedback(is_succeeding=True))
        server.set_succeeded(FilledSemanticFrameResult(success="addressee" in arguments))

    server = actionlib.SimpleActionServer("salute_2012", FilledSemanticFrameAction, execute, auto_start=False)
    server.start()
    with tempfile.TemporaryDirectory() as folder:
        for name, service, text in (("add_frame", AddFrame, FRAME), ("add_lexical_unit", AddLexicalUnit, UNIT)):
            rospy.wait_for_service(name, timeout=60.0)
            if not rospy.ServiceProxy(name, service)(write(folder, f"{name}.yaml", text)).success:
                raise SystemExit(f"{name} was refused")
        answer = rospy.ServiceProxy("register_with_frame", RegisterWithFrame)("saluting", "salute_2012")
    if not answer.success or answer.error:
        raise SystemExit(f"register_with_frame was refused: {answer.error}")
    rospy.spin()


main()
