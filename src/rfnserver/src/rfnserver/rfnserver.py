"""``RFNServer``: an action server that registers for semantic frames."""

import traceback
from typing import Any, Callable, Optional

import actionlib
import rospy
from roboframenet_msgs.msg import (
    FilledSemanticFrame,
    FilledSemanticFrameAction,
    FilledSemanticFrameGoal,
    FilledSemanticFrameResult,
)

from rfnserver.ros_quiet_action_server import QuietActionServer
from rfnserver.ros_registration import Registration
from rfnserver.wishes import WishKind

#: The waiting thread wakes up so often although nobody notified it, seconds: a guard, not a rhythm.
WAKE_UP_S = 5.0

FrameCallback = Callable[[FilledSemanticFrame], Any]


class RFNServer(actionlib.SimpleActionServer):
    """A ``SimpleActionServer`` for frames: what it can do, people can ask for.

    As in 2012::

        server = RFNServer("waving", wave)          # wave(filled_semantic_frame)
        server.register_with_frame("waving")
        server.start()

    The callback gets the filled frame. If it returns without having ended the goal, the goal succeeds (or is preempted,
    when that
    was asked for); if it raises, the goal is aborted with the reason. ``set_aborted(text=...)`` tells the person why.

    Files and registrations may be added before and after ``start()``; they are given again by themselves to a registrar
    or framer
    that restarts. In contrast to the stock server there is no lost wake-up between two goals, no traceback at shutdown,
    and nothing to do
    while there is no goal.
    """

    def __init__(self, name: str, callback: FrameCallback) -> None:
        """
        Args:
            name: of the action server
            callback: called with the filled frame, in a thread of its own, one goal at a time
        """
        self._frame_callback = callback
        self._registration = Registration(name)
        super().__init__(name, FilledSemanticFrameAction, execute_cb=self._execute_frame, auto_start=False)
        # The one that the base class made was never started: it has no topics yet.
        self.action_server = QuietActionServer(
            name, FilledSemanticFrameAction, self.internal_goal_callback, self.internal_preempt_callback, False
        )
        rospy.on_shutdown(self._wake_up)

    @property
    def last_error(self) -> str:
        """Why the last call to registrar or framer failed; empty when it did not."""
        return self._registration.last_error

    def register_with_frame(self, frame_name: str) -> bool:
        """Carry out a frame from now on.

        Args:
            frame_name: of a frame, also one whose file is added later
        Returns:
            True when the registrar agreed; False when it did not or is not there, logged, and tried again when it
            appears
        """
        return self._registration.want(WishKind.REGISTRATION, frame_name)

    def add_semantic_frame(self, path: str) -> bool:
        """Add a frame file.

        Args:
            path: of the file; the registrar reads it, so both share a file system
        Returns:
            True when it was accepted; False when not, logged, and tried again when a registrar appears
        """
        return self._registration.want(WishKind.FRAME_FILE, path)

    def add_lexical_unit(self, path: str) -> bool:
        """Add a lexical unit file; see :meth:`add_semantic_frame`."""
        return self._registration.want(WishKind.LEXICAL_UNIT_FILE, path)

    def _execute_frame(self, goal: FilledSemanticFrameGoal) -> None:
        self._frame_callback(goal.frame)
        if not self.is_active():
            return
        if self.is_preempt_requested():
            self.set_preempted(FilledSemanticFrameResult(success=False), "preempted")
        else:
            self.set_succeeded(FilledSemanticFrameResult(success=True))

    def executeLoop(self) -> None:  # the name is the base class's
        """Wait for goals and run the callback, until shutdown.

        The stock loop looks for a goal before it takes the lock and then sleeps a tenth of a second: a goal that comes
            in between
        waits as long. Here both happen under the lock.
        """
        while not rospy.is_shutdown():
            with self.terminate_mutex:
                if self.need_to_terminate:
                    return
            with self.execute_condition:
                if not self.is_new_goal_available():
                    self.execute_condition.wait(WAKE_UP_S)
            if self.is_new_goal_available() and not rospy.is_shutdown():
                self._run_callback(self.accept_new_goal())

    def _run_callback(self, goal: Optional[Any]) -> None:
        if goal is None:
            return
        try:
            self.execute_callback(goal)
            if self.is_active():
                self.set_aborted(None, "No terminal state was set.")
        except Exception as error:  # boundary: the user's callback may raise anything
            rospy.logerr("the callback failed: %s\n%s", error, traceback.format_exc())
            if self.is_active():
                self.set_aborted(None, f"{type(error).__name__}: {error}")

    def _wake_up(self) -> None:
        with self.execute_condition:
            self.execute_condition.notify_all()
