#!/usr/bin/python3
"""A server with its own frame and lexical unit; the tests kill it at any time. Greeting somebody takes a second."""

import os
import tempfile

import rospy

from rfnserver import RFNServer, TypedFrame

FRAME = "name: greeting\ndescription: The robot greets.\nframe_elements:\n  - name: addressee\n"
UNIT = """frame_name: greeting
verb: [greet, salute]
frame_element_grammatical_relations:
  - name: addressee
    relation: dobj
"""
LONG_S = 1.0


def main() -> None:
    """Run the node."""
    rospy.init_node("greeting_server")
    folder = os.path.join(tempfile.gettempdir(), "roboframenet_greeting")
    os.makedirs(folder, exist_ok=True)
    for name, text in (("frame.yaml", FRAME), ("unit.yaml", UNIT)):
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(text)

    def greet(frame: TypedFrame) -> None:
        end = rospy.Time.now() + rospy.Duration(LONG_S if "addressee" in frame else 0.0)
        while rospy.Time.now() < end and not server.is_preempt_requested():
            rospy.sleep(0.02)

    server = RFNServer("greeting", greet)
    server.add_semantic_frame(os.path.join(folder, "frame.yaml"))
    server.add_lexical_unit(os.path.join(folder, "unit.yaml"))
    server.register_with_frame("greeting")
    server.start()
    rospy.spin()


main()
