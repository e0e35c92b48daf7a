"""An action server that costs nothing while it has no goal."""
from typing import Optional

import actionlib
import rospy


class QuietActionServer(actionlib.ActionServer):
    """``actionlib.ActionServer`` that publishes its status at actionlib's rate only while it tracks a goal.

    The status topic is latched, so a client that connects to an idle server still hears from it: that is all that
    ``wait_for_server`` needs. The stock server wakes up five times a second for ever.
    """

    #: The timer runs while there are goals; None otherwise.
    _goal_timer: Optional[rospy.Timer] = None

    def initialize(self) -> None:
        """Set up the topics, without the status timer."""
        super().initialize()
        if self.status_timer is not None:
            self.status_timer.shutdown()
            self.status_timer = None
        rospy.on_shutdown(self._end_timer)

    def publish_status(self) -> None:
        """Publish the status of all goals; keep doing so while there are any."""
        with self.lock:
            # Publishing to a topic that rospy has closed already prints a traceback for nothing.
            if rospy.is_shutdown() or self.status_pub is None:
                return
            super().publish_status()
            if not self.status_list:
                self._end_timer()
            elif self._goal_timer is None and self.status_frequency > 0.0:
                self._goal_timer = rospy.Timer(rospy.Duration(1.0 / self.status_frequency), self.publish_status_async)

    def publish_status_async(self, event: rospy.timer.TimerEvent) -> None:
        """Publish from the timer."""
        with self.lock:
            if self._goal_timer is not None:
                super().publish_status_async(event)

    def internal_goal_callback(self, goal: object) -> None:
        """Take a goal, and publish what became of it at once."""
        super().internal_goal_callback(goal)
        if self.started:
            self.publish_status()

    def stop(self) -> None:
        """Stop the action server; no goal may be running."""
        with self.lock:
            self.started = False
            self._end_timer()
            for end in (self.goal_sub, self.cancel_sub, self.status_pub, self.feedback_pub, self.result_pub):
                if end is not None:
                    end.unregister()
            self.status_pub = None

    def _end_timer(self) -> None:
        if self._goal_timer is not None:
            self._goal_timer.shutdown()
            self._goal_timer = None
