"""Waits for the pipeline and the servers of a test, and says sentences."""

import os
from types import TracebackType
from typing import Iterable, List, Optional, Set, Type

import actionlib
import rospy
from roboframenet_msgs.msg import ExecuteCommandAction, ExecuteCommandGoal, FrameServers, Lexicon, Reply

from roboframenet_demo.ros_pipeline import is_pipeline_complete
from roboframenet_ros.ros_missed_publishers import connect_missed_publishers
from roboframenet_ros.ros_waiting import wait_for_action_server
from roboframenet_testing import comes_true


class _Known:
    """What the running graph can do and has read, as its latched topics say.

    Subscribes:
        frame_servers (FrameServers), lexicon (Lexicon)
    """

    def __init__(self) -> None:
        self.frames: Set[str] = set()
        self.unit_files: Set[str] = set()
        self._subscribers = (
            rospy.Subscriber("frame_servers", FrameServers, self._on_servers),
            rospy.Subscriber("lexicon", Lexicon, self._on_lexicon),
        )

    def __enter__(self) -> "_Known":
        return self

    def __exit__(
        self, _kind: Optional[Type[BaseException]], _error: Optional[BaseException], _trace: Optional[TracebackType]
    ) -> None:
        for subscriber in self._subscribers:
            subscriber.unregister()

    def _on_servers(self, message: FrameServers) -> None:
        self.frames.update(callback.frame_name for callback in message.callbacks if callback.is_alive)

    def _on_lexicon(self, lexicon: Lexicon) -> None:
        self.unit_files.update(os.path.basename(file.path) for file in lexicon.files)


def can_do(frames: Iterable[str], *, unit_files: Iterable[str] = (), timeout_s: float = 60.0) -> bool:
    """Wait until a living server has registered for each frame; a server may start later than the pipeline.

    Args:
        frames: names of frames
        unit_files: names, without folders, of lexical unit files that must have been read
        timeout_s: how long to wait
    Returns:
        whether all of it is there
    """
    with _Known() as known:
        return comes_true(
            lambda: known.frames.issuperset(frames) and known.unit_files.issuperset(unit_files), timeout_s
        )


def wait_for_pipeline(frames: Iterable[str] = (), *, unit_files: Iterable[str] = (), timeout_s: float = 120.0) -> None:
    """Wait until every stage of the pipeline hears the others, servers have registered, and files have been read.

    Args:
        frames: names of the frames that a living server must have registered for
        unit_files: names, without folders, of the lexical unit files that the framer must have read
        timeout_s: how long to wait
    Raises:
        AssertionError: something is missing at the deadline; the message says what
    """
    wanted, files = tuple(frames), tuple(unit_files)
    connect_missed_publishers()
    with _Known() as known:

        def missing() -> List[str]:
            absent = [f"no living server for the frame {name}" for name in wanted if name not in known.frames]
            absent += [f"no lexical unit file {name}" for name in files if name not in known.unit_files]
            return absent or ([] if is_pipeline_complete() else ["a stage of the pipeline is not connected"])

        if not comes_true(lambda: not missing(), timeout_s):
            raise AssertionError(f"after {timeout_s:g} s: {'; '.join(missing())}")


def say(text: str, *, timeout_s: float = 60.0, robot: str = "") -> Reply:
    """Say a sentence and return the reply to it.

    Args:
        text: the sentence
        timeout_s: how long to wait for the command server, and again for the reply
        robot: the namespace of its command server; empty for that of this node
    Raises:
        AssertionError: no command server, or no reply, within the time
    """
    # A SimpleActionClient drops a result that arrives before its send_goal() has returned.
    client = actionlib.ActionClient(f"{robot}/command" if robot else "command", ExecuteCommandAction)
    assert wait_for_action_server(client, timeout_s), f"no command server within {timeout_s:g} s"
    goal = client.send_goal(ExecuteCommandGoal(text=text))
    if not comes_true(lambda: goal.get_comm_state() == actionlib.CommState.DONE, timeout_s):
        goal.cancel()
        raise AssertionError(f'no reply to "{text}" within {timeout_s:g} s')
    return goal.get_result().reply
