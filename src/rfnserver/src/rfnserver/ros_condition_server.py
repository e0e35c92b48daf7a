"""``ConditionServer``: an action server that says whether a condition holds."""

import threading
import time
from dataclasses import dataclass
from typing import Any, Callable, Dict, Optional, Union

import actionlib
import rospy
from roboframenet_msgs.msg import (
    FilledSemanticFrameAction,
    FilledSemanticFrameFeedback,
    FilledSemanticFrameResult,
)

from rfnserver.rfnserver import _Registering
from rfnserver.ros_registration import Registration
from rfnserver.ros_typed_frame import TypedFrame, typed_frame
from roboframenet_ros.ros_quiet_action_server import QuietActionServer
from semantic_frames.server_statement import stated_profile

#: What holds is said again after this time, seconds: silence means that the source is dead.
REPETITION_S = 1.0
#: How often it is said within the time after which the source is dead.
_REPETITIONS = 3.0
#: So many conditions are repeated at a time: the queues of the topics of an action hold 50 messages.
_MOST_REPEATED = 20
#: A change is told with its own stamp for so long, ROS time.
_FRESH = rospy.Duration(1)


class ConditionUnknown(Exception):
    """Nobody can tell whether the condition holds; the text says why, as a clause: "/scan is silent"."""


@dataclass(frozen=True)
class Observed:
    """Whether a condition holds, and when that was observed."""

    holds: bool
    stamp: rospy.Time

    @classmethod
    def still(cls, holds: bool, since: rospy.Time) -> "Observed":
        """Return what was observed and has not changed: from an age of a second on, it is observed now.

        Args:
            holds: whether the condition holds
            since: stamp of the message that said so; its source speaks only of changes, and is alive
        """
        now = rospy.Time.now()
        return cls(holds, since if now - since < _FRESH else now)


Holds = Callable[[TypedFrame], Union[bool, Observed, None]]
#: Called when somebody begins to watch; returns a function that is called when nobody watches any more.
WhileWatched = Callable[[], Callable[[], None]]


@dataclass
class _Watched:
    handle: actionlib.ServerGoalHandle
    frame: TypedFrame
    holds: Optional[bool] = None
    said_s: float = 0.0


class ConditionServer(_Registering, QuietActionServer):
    """Watches conditions for clauses such as "until the door is open"::

        server = ConditionServer("door_watch", lambda frame: door.is_open)
        server.register_with_frame("being_open")
        server.start()

    The function gets the filled frame and returns whether it holds now: True or False, or `Observed` with the stamp of
    the message that shows it; None while the first message is not there yet. It raises `ConditionUnknown` if nobody can
    tell. It is asked in a thread of the server while somebody watches, and at once after `changed`.
    """

    def __init__(
        self,
        name: str,
        holds: Holds,
        *,
        period_s: float = 0.05,
        while_watched: WhileWatched = lambda: lambda: None,
        **statement: Any,
    ) -> None:
        """
        Args:
            name: of the action server
            holds: whether a frame holds
            period_s: pause between two questions
            while_watched: called when somebody begins to watch, to subscribe to what costs much for example; returns a
                function that ends that
            **statement: what the server states about itself: ``heeds={"phenomenon": {"values": ["wall"]}}``,
                ``longest_silence_s=2.0``; see :mod:`semantic_frames.server_statement`
        Raises:
            ProfileError: the statement is wrong
        """
        self._holds = holds
        self._period_s = period_s
        silence_s = float(statement.get("longest_silence_s") or 0.0)
        self._repetition_s = min(REPETITION_S, silence_s / _REPETITIONS) if silence_s else REPETITION_S
        self._while_watched = while_watched
        self._watched: Dict[str, _Watched] = {}
        self._condition = threading.Condition()
        self._is_asking = False
        self._registration = Registration(name, profile=stated_profile({**statement, "purpose": "watches"}))
        super().__init__(name, FilledSemanticFrameAction, self._on_goal, self._on_cancel, False)
        self.cancel_orphans()

    def register_with_frame(self, frame_name: str, **statement: Any) -> bool:  # type: ignore[override]
        """Watch a frame from now on.

        Args:
            frame_name: of a frame, also one whose file is added later
            **statement: what the server states for this frame, instead of what it was made with
        Returns:
            True when the registrar accepted; see :meth:`RFNServer.register_with_frame`
        Raises:
            ProfileError: the statement is wrong
        """
        purpose = {"purpose": "watches"} if statement else {}
        return super().register_with_frame(frame_name, **statement, **purpose)

    def changed(self) -> None:
        """Ask the function now: its source has news."""
        with self._condition:
            self._condition.notify_all()

    def _on_goal(self, handle: actionlib.ServerGoalHandle) -> None:
        handle.set_accepted()
        with self._condition:
            self._watched[handle.get_goal_id().id] = _Watched(handle, typed_frame(handle.goal))
            if self._is_asking:
                self._condition.notify_all()
                return
            self._is_asking = True
        threading.Thread(target=self._watch, name="condition_server", daemon=True).start()

    def _on_cancel(self, handle: actionlib.ServerGoalHandle) -> None:
        with self._condition:
            self._watched.pop(handle.get_goal_id().id, None)
        handle.set_canceled(FilledSemanticFrameResult(success=False), "")

    def _watch(self) -> None:
        end = self._while_watched()
        try:
            self._ask()
        finally:
            end()

    def _ask(self) -> None:
        while not rospy.is_shutdown():
            with self._condition:
                watched = list(self._watched.items())
                if not watched:
                    self._is_asking = False
                    return
            repeated = 0
            for goal_id, one in watched:
                said_s = one.said_s
                fault = self._tell(one, may_repeat=repeated < _MOST_REPEATED)
                repeated += one.said_s != said_s
                if fault:
                    with self._condition:
                        is_mine = self._watched.pop(goal_id, None) is not None
                    if is_mine:
                        one.handle.set_aborted(FilledSemanticFrameResult(success=False), fault)
            with self._condition:
                self._condition.wait(self._period_s)

    def _is_repetition_due(self, said_s: float, now_s: float) -> bool:
        """Whether what was said is to be said again; all conditions are due together, so each process wakes up once."""
        return int(now_s / self._repetition_s) > int(said_s / self._repetition_s)

    def _tell(self, watched: _Watched, *, may_repeat: bool) -> str:
        """Publish whether a condition holds; returns why that cannot be told."""
        try:
            said = self._holds(watched.frame)
        except ConditionUnknown as unknown:
            return str(unknown)
        except Exception as error:  # boundary: the user's function may raise anything
            rospy.logerr("the function of a condition failed: %s: %s", type(error).__name__, error)
            return f"{type(error).__name__}: {error}"
        if said is None:
            return ""
        observed = said if isinstance(said, Observed) else Observed(bool(said), rospy.Time.now())
        now_s = time.monotonic()
        if observed.holds is watched.holds and not (may_repeat and self._is_repetition_due(watched.said_s, now_s)):
            return ""
        watched.holds, watched.said_s = observed.holds, now_s
        message: Any = self.ActionFeedback()
        message.header.stamp = observed.stamp
        message.status = watched.handle.get_goal_status()
        message.feedback = FilledSemanticFrameFeedback(is_succeeding=observed.holds)
        self.feedback_pub.publish(message)
        return ""
