#!/usr/bin/python3
"""A server with its own frame and lexical unit; the tests kill it at any time."""

import os
import tempfile

import rospy

from rfnserver import RFNServer

FRAME = "name: greeting\ndescription: The robot greets.\n"
UNIT = "frame_name: greeting\nverb: [greet, salute]\n"


def main() -> None:
    """Run the node."""
    rospy.init_node("greeting_server")
    folder = os.path.join(tempfile.gettempdir(), "roboframenet_greeting")
    os.makedirs(folder, exist_ok=True)
    for name, text in (("frame.yaml", FRAME), ("unit.yaml", UNIT)):
        with open(os.path.join(folder, name), "w", encoding="utf-8") as file:
            file.write(text)
    server = RFNServer("greeting", lambda _frame: None)
    server.add_semantic_frame(os.path.join(folder, "frame.yaml"))
    server.add_lexical_unit(os.path.join(folder, "unit.yaml"))
    server.register_with_frame("greeting")
    server.start()
    rospy.spin()


main()
