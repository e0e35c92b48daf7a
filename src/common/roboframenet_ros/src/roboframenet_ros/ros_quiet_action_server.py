"""Action servers that cost nothing while they have no goal."""

import contextlib
import queue
import traceback
from typing import Any, Callable, Optional

import actionlib
import rospy
from actionlib_msgs.msg import GoalID, GoalStatus
from roboframenet_msgs.msg import FilledSemanticFrameActionGoal

from roboframenet_ros.orphaned_goals import OrphanWatch
from roboframenet_ros.replays import AGAIN, Taken, is_old
from roboframenet_ros.ros_connection_threads import accept_in_threads
from roboframenet_ros.ros_log import log_from_threads
from roboframenet_ros.ros_missed_publishers import connect_missed_publishers
from roboframenet_ros.ros_publishing import is_shutting_down
from roboframenet_ros.status_thread import StatusThread

#: The waiting thread wakes up at this period without a notification, seconds; it is only a safeguard.
WAKE_UP_S = 5.0
#: Stamps further in the future are from before the clock was set back, even where nobody saw that happen; less is a
#: difference between hosts. Seconds.
CLOCK_RESET_S = 1.0
#: Goals in these states are over.
_OVER = (
    GoalStatus.PREEMPTED,
    GoalStatus.SUCCEEDED,
    GoalStatus.ABORTED,
    GoalStatus.REJECTED,
    GoalStatus.RECALLED,
    GoalStatus.LOST,
)
#: Goals in these states are cancelled when their client is gone.
_CANCELLABLE = (GoalStatus.PENDING, GoalStatus.ACTIVE)
#: Changes of the status within this time are published in one message, seconds.
STATUS_PAUSE_S = 0.02
#: Of the goals that are over, so many are in a status. actionlib tells of all those of the last 5 s: where hundreds end
#: in a second, everybody reads them all for each new goal.
MOST_OVER = 50


def _is_later(stamp: rospy.Time, than: rospy.Time) -> bool:
    """Compare two times; rospy's comparison takes ten times as long, and each goal is compared for each new one."""
    return bool(stamp.secs >= than.secs and stamp > than)


class QuietActionServer(actionlib.ActionServer):
    """``actionlib.ActionServer`` that publishes its status at actionlib's rate only while it tracks a goal.

    The status topic is latched, so a client that connects to an idle server still receives its status, which is all
    that ``wait_for_server`` needs. The stock server wakes up five times a second for ever.
    """

    #: Of a server whose goals end with their clients; None for actionlib's way, in which they go on.
    _orphan_watch: Optional[OrphanWatch] = None
    #: Publishes the status; None before the server is started, and when it is stopped.
    _status: Optional[StatusThread] = None
    #: Called without the lock when a goal has come: it wakes who accepts it, which publishes the status. None where the
    #: callback of the goal accepts it.
    on_taken: Optional[Callable[[], None]] = None
    #: ROS time at the last goal, cancel or check of the clock; an earlier time later means that the clock was set back.
    _seen = rospy.Time()

    def initialize(self) -> None:
        """Set up the topics, without the status timer, and a log that never delays a goal."""
        self._taken = Taken()
        log_from_threads()
        accept_in_threads()
        connect_missed_publishers()
        super().initialize()
        if self.status_timer is not None:
            self.status_timer.shutdown()
            self.status_timer = None
        period_s = 1.0 / self.status_frequency if self.status_frequency > 0.0 else None
        self._status = StatusThread(self._publish_or_say_why_not, pause_s=STATUS_PAUSE_S, period_s=period_s)
        rospy.on_shutdown(self._status.close)

    def start(self) -> None:
        """Take goals from now on; the first status is there when it returns."""
        with self.lock:
            self.initialize()
            self.started = True
            self._publish_status_now()

    def cancel_orphans(self) -> None:
        """From now on, cancel a goal when the process that sent it dies or leaves; see :class:`OrphanWatch`.

        A robot whose commander is gone must not go on. Clients that only publish goals are left alone.
        """
        self._orphan_watch = OrphanWatch(self._is_listening)

    def publish_status(self) -> None:
        """Have the status of all goals published soon, and repeatedly while there are goals.

        Each message holds every goal of the last seconds: when goals come in quick succession, publishing each
        change takes longer than carrying them out. Results are not delayed.
        """
        if self._status is not None:
            self._status.ask()

    def _publish_or_say_why_not(self) -> bool:
        """Publish the status of all goals; returns whether it must be repeated."""
        try:
            return self._publish_status_now()
        except Exception as error:  # boundary: a goal may have any text, and the thread must tell of the others, too
            rospy.logerr_throttle(10.0, f"{self.ns}: the status cannot be published: {type(error).__name__}: {error}")
            return True

    def _publish_status_now(self) -> bool:
        """Publish the status of all goals; returns whether there are any."""
        self._look_for_orphans()
        with self.lock:
            # Publishing to a topic that rospy has closed would print a useless traceback.
            if is_shutting_down() or self.status_pub is None:
                return False
            self._forget_oldest()
            super().publish_status()
            return bool(self.status_list)

    def _forget_oldest(self) -> None:
        """Forget the goals that were over first, if many are. Called with the lock."""
        over = [tracker for tracker in self.status_list if tracker.status.status in _OVER]
        if len(over) > MOST_OVER:
            forgotten = {id(tracker) for tracker in over[:-MOST_OVER]}
            self.status_list[:] = [tracker for tracker in self.status_list if id(tracker) not in forgotten]

    def internal_goal_callback(self, goal: Any) -> None:
        """Take a goal; its status is published soon after it changes, and repeatedly."""
        self.follow_clock()
        if self._refuses(goal):
            return
        if self._orphan_watch is not None:
            with self.lock:
                client = (getattr(goal, "_connection_header", None) or {}).get("callerid", "")
                self._orphan_watch.note(goal.goal_id.id, client)
        super().internal_goal_callback(goal)
        if self.on_taken is not None:
            self.on_taken()
        else:
            self.publish_status()

    def _refuses(self, goal: Any) -> bool:
        """Take a goal of the executor, or reject one that a recording repeats; returns whether it is rejected.

        Other goals come from ordinary clients, whose clocks and ids are their own business.
        """
        if not isinstance(goal, FilledSemanticFrameActionGoal):
            return False
        with self.lock:
            stamp_ns, now_ns = goal.goal_id.stamp.to_nsec(), rospy.Time.now().to_nsec()
            if goal.goal_id.id not in self._taken and not is_old(stamp_ns, now_ns):
                self._taken.add(goal.goal_id.id)
                return False
            rospy.logwarn("%s: rejected an old goal that a recording repeats", self.ns)
            take, self.goal_callback = self.goal_callback, lambda handle: handle.set_rejected(None, AGAIN)
            try:
                super().internal_goal_callback(goal)
            finally:
                self.goal_callback = take
        return True

    def internal_cancel_callback(self, goal_id: GoalID) -> None:
        """Cancel goals by id, or those up to a stamp."""
        self.follow_clock()
        super().internal_cancel_callback(goal_id)

    def follow_clock(self) -> None:
        """Forget stamps of the future: the clock was set back, as simulators do.

        actionlib compares stamps: new goals would be refused, and goals would not be cancelled by stamp, until the
        clock has reached the old time again.
        """
        with self.lock:
            now = rospy.Time.now()
            latest = now if now < self._seen else now + rospy.Duration.from_sec(CLOCK_RESET_S)
            self._seen = now
            if self.last_cancel > latest:
                self.last_cancel = rospy.Time()
            for tracker in self.status_list:
                if _is_later(tracker.status.goal_id.stamp, latest):
                    # Older than whatever is said since, even while no clock has arrived and all stamps are zero.
                    tracker.status.goal_id.stamp = rospy.Time()
                if _is_later(tracker.handle_destruction_time, latest):
                    tracker.handle_destruction_time = now

    def stop(self) -> None:
        """Stop the action server; no goal may be running."""
        with self.lock:
            self.started = False
            if self._status is not None:
                self._status.close()
                self._status = None
            for end in (self.goal_sub, self.cancel_sub, self.status_pub, self.feedback_pub, self.result_pub):
                if end is not None:
                    end.unregister()
            self.status_pub = None

    def _is_listening(self, client: str) -> bool:
        # Without this call, rospy notices that a process has died only when it writes to it.
        self.status_pub.impl.check()
        return bool(self.status_pub.impl.has_connection(client))

    def _look_for_orphans(self) -> None:
        with self.lock:
            if self._orphan_watch is None or self.status_pub is None or is_shutting_down():
                return
            states = [(tracker.status.goal_id.id, tracker.status.status) for tracker in self.status_list]
            orphans = self._orphan_watch.orphans([goal_id for goal_id, state in states if state in _CANCELLABLE])
        for goal_id in orphans:
            rospy.logwarn("%s: the client of goal %s is gone; cancelling it", self.ns, goal_id)
            self.internal_cancel_callback(GoalID(id=goal_id))


class QuietSimpleActionServer(actionlib.SimpleActionServer):
    """``actionlib.SimpleActionServer`` on a :class:`QuietActionServer`.

    Unlike the stock server it loses no wake-up between two goals, prints no traceback at shutdown, and does nothing
    while it has no goal.
    """

    def __init__(
        self,
        name: str,
        ActionSpec: Any,  # noqa: N803 (the name is the base class's)
        execute_cb: Optional[Callable[[Any], None]] = None,
        auto_start: bool = True,
    ) -> None:
        """See ``actionlib.SimpleActionServer``."""
        # The loop is woken by what is put here.
        self._news: queue.SimpleQueue[None] = queue.SimpleQueue()
        super().__init__(name, ActionSpec, execute_cb=execute_cb, auto_start=False)
        # The server of the base class was never started, so it has no topics.
        self.action_server = QuietActionServer(
            name, ActionSpec, self.internal_goal_callback, self.internal_preempt_callback, False
        )
        if execute_cb is not None:
            self.action_server.on_taken = lambda: self._news.put(None)
        rospy.on_shutdown(self._wake_up)
        if auto_start:
            self.start()

    def internal_goal_callback(self, goal: actionlib.ServerGoalHandle) -> None:
        """Take a goal; it preempts the current one unless it is older.

        The stock server refuses a goal that is older than the last one, even when that is long over: the clocks of two
        hosts differ.
        """
        with self.execute_condition:
            for last in (self.current_goal, self.next_goal):
                if last.goal is not None and last.status_tracker.status.status in _OVER:
                    last.status_tracker.status.goal_id.stamp = rospy.Time()
        super().internal_goal_callback(goal)

    def executeLoop(self) -> None:  # noqa: N802 (the name is the base class's)
        """Wait for goals and run the callback, until shutdown.

        The stock loop looks for a goal before it takes the lock and then sleeps a tenth of a second: a goal that
        arrives in between waits as long. And it is woken while the lock is still held. Here a goal that has been taken
        wakes it, and no lock is needed.
        """
        while not rospy.is_shutdown():
            with self.terminate_mutex:
                if self.need_to_terminate:
                    return
            with contextlib.suppress(queue.Empty):
                self._news.get(timeout=WAKE_UP_S)
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
                self.set_aborted(None, self.text_of_exception(error))

    def text_of_exception(self, error: Exception) -> str:
        """Return what clients are told of an exception in the callback: what the stock server tells them."""
        return f"Exception in execute callback: {error}"

    def _wake_up(self) -> None:
        """End the loop; called by rospy at shutdown, while is_shutdown() may still be false."""
        with self.terminate_mutex:
            self.need_to_terminate = True
        self._news.put(None)
