#!/usr/bin/python3
"""Action servers that behave as badly as the frame of each goal asks for.

The name of the frame is the behaviour. Each goal that begins or ends is told on `server_log` as "SERVER WHAT FRAME".
What comes on `~mark` is told there too, after what was told before.
"""

import os
import sys
import threading
import time

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus
from roboframenet_msgs.msg import (
    FilledSemanticFrameAction,
    FilledSemanticFrameActionFeedback,
    FilledSemanticFrameFeedback,
    FilledSemanticFrameResult,
)
from std_msgs.msg import String


class MisbehavingServer:
    def __init__(self, name, log):
        self._name, self._log = name, log
        self._cancelled = {}
        self._server = actionlib.ActionServer(
            name, FilledSemanticFrameAction, self._on_goal, self._on_cancel, auto_start=False
        )
        self._server.start()
        rospy.on_shutdown(self._server.status_timer.shutdown)

    def _tell(self, what, frame):
        self._log.publish(f"{self._name} {what} {frame.name}")

    def _on_goal(self, handle):
        frame = handle.get_goal().frame
        self._cancelled[handle.get_goal_id().id] = threading.Event()
        self._tell("begins", frame)
        if frame.name == "start_again":
            # Sockets are closed, and the process is another one for its clients.
            os.execv(sys.executable, [sys.executable, *sys.argv])
        if frame.name == "raise":
            raise RuntimeError("raised as asked for")
        if frame.name == "reject":
            handle.set_rejected(None, "rejected as asked for")
            return
        threading.Thread(target=self._carry_out, args=(handle, frame), daemon=True).start()

    def _on_cancel(self, handle):
        self._cancelled[handle.get_goal_id().id].set()

    def _carry_out(self, handle, frame):
        elements = {element.name: element.argument for element in frame.frame_elements}
        cancelled = self._cancelled[handle.get_goal_id().id]
        done, undone = FilledSemanticFrameResult(success=True), FilledSemanticFrameResult(success=False)
        if frame.name == "accept_late":
            cancelled.wait(float(elements["seconds"]))
            if cancelled.is_set():
                handle.set_canceled(undone)
                return
        handle.set_accepted()
        if frame.name != "watch":
            handle.publish_feedback(FilledSemanticFrameFeedback(is_succeeding=True))
        if frame.name == "succeed" or frame.name == "accept_late":
            self._tell("ends", frame)
            handle.set_succeeded(done)
        elif frame.name == "unsuccessful":
            handle.set_succeeded(undone, "succeeded without success as asked for")
        elif frame.name == "abort":
            handle.set_aborted(undone, "aborted as asked for")
        elif frame.name == "cancel_itself":
            handle.set_canceled(undone, "cancelled as asked for")
        elif frame.name == "run":
            while not cancelled.wait(0.5):
                pass
            self._tell("preempted", frame)
            handle.set_canceled(undone)
        elif frame.name == "last":
            if cancelled.wait(float(elements["seconds"])):
                self._tell("preempted", frame)
                handle.set_canceled(undone)
            else:
                self._tell("ends", frame)
                handle.set_succeeded(done)
        elif frame.name == "watch":
            self._watch(handle, cancelled, elements)
            self._tell("ends", frame)
        elif frame.name == "ignore_cancel":
            time.sleep(float(elements["seconds"]))
            self._tell("ends", frame)
            handle.set_succeeded(done)
        elif frame.name == "abort_on_cancel":
            cancelled.wait(60.0)
            handle.set_aborted(undone, "aborted instead of preempted")
        elif frame.name == "lose":
            with self._server.lock:
                self._server.status_list.clear()
                self._server.publish_status()
        elif frame.name == "drop_result":
            with self._server.lock:
                for tracker in self._server.status_list:
                    if tracker.status.goal_id.id == handle.get_goal_id().id:
                        tracker.status.status = GoalStatus.SUCCEEDED
                self._server.publish_status()
        elif frame.name == "freeze":
            self._server.status_timer.shutdown()
            self._server.started = False
        elif frame.name == "die":
            # rospy sends from queues, which an exit drops: the acceptance is to arrive first.
            time.sleep(1.0)
            os._exit(1)

    def _watch(self, handle, cancelled, elements):
        """Says "not so" (or "so", if `before` is 1), and after some seconds does what `then` says."""
        holds, begin_s = elements["before"] == "1", time.monotonic()
        then, stamp, is_over = elements["then"], rospy.Time.now(), False
        while not cancelled.wait(0.1):
            seconds = time.monotonic() - begin_s
            is_over = seconds >= float(elements["seconds"]) and seconds > 0.3
            if is_over and then == "abort":
                handle.set_aborted(FilledSemanticFrameResult(success=False), "aborted as asked for")
                return
            if is_over and then == "die":
                os._exit(1)
            if is_over and then == "silence":
                continue
            if then != "old" or not is_over:
                stamp = rospy.Time.now()
            # "toggle": the other way round after the time, and back again.
            changes = {"so": 1, "toggle": 1 + (seconds >= 2.0 * float(elements["seconds"]))}.get(then, 0)
            is_so = holds != bool(changes % 2) if is_over else holds
            message = FilledSemanticFrameActionFeedback(status=handle.get_goal_status())
            message.header.stamp = stamp
            message.feedback.is_succeeding = is_so
            self._server.feedback_pub.publish(message)
        handle.set_canceled(FilledSemanticFrameResult(success=False))


def main():
    rospy.init_node("misbehaving_server")
    log = rospy.Publisher("server_log", String, queue_size=1000)
    servers = [MisbehavingServer(name, log) for name in rospy.get_param("~servers")]
    rospy.Subscriber("~mark", String, log.publish, queue_size=10)
    rospy.loginfo("%d servers", len(servers))
    rospy.spin()


if __name__ == "__main__":
    main()
