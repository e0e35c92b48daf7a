"""The node ``ping``: answers "Ping." with the servers that are alive."""

import threading
from typing import Optional

import rospy
from roboframenet_msgs.msg import FilledSemanticFrame, FilledSemanticFrameResult, FrameServers
from std_msgs.msg import String

from rfnserver.pinging import living_and_dead, ping_sentence
from rfnserver.rfnserver import RFNServer
from roboframenet_ros.ros_node import run_node


class PingServer:
    """Tests whether the system is alive.

    Actions:
        pinging (roboframenet_msgs/FilledSemanticFrameAction)
    Subscribes:
        frame_servers (FrameServers)
    Publishes:
        said (std_msgs/String, latched)
    """

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._servers: Optional[FrameServers] = None
        self._said = rospy.Publisher("said", String, queue_size=1, latch=True)
        self._subscriber = rospy.Subscriber("frame_servers", FrameServers, self._on_servers, queue_size=1)
        self._server = RFNServer("pinging", self._on_frame)
        self._server.register_with_frame("pinging")
        self._server.start()

    def _on_servers(self, message: FrameServers) -> None:
        with self._lock:
            self._servers = message

    def _on_frame(self, _frame: FilledSemanticFrame) -> None:
        with self._lock:
            callbacks = self._servers.callbacks if self._servers else []
        alive, dead = living_and_dead((each.frame_name, each.callback_topic, each.is_alive) for each in callbacks)
        rospy.loginfo("servers that run: %s; that do not: %s", ", ".join(alive) or "none", ", ".join(dead) or "none")
        sentence = ping_sentence(alive, dead)
        rospy.loginfo(sentence)
        self._said.publish(String(data=sentence))
        self._server.set_succeeded(FilledSemanticFrameResult(success=True), sentence)


def main() -> None:
    """Run the node until ROS shuts down."""
    run_node("ping", PingServer)
