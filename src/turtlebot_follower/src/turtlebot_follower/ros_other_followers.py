"""Existing followers of a robot: behind a service, or in a launch file, as in 2012."""

import os
import signal
import subprocess
from typing import Optional

import rospy
from turtlebot_msgs.srv import SetFollowState, SetFollowStateRequest, SetFollowStateResponse

from roboframenet_ros.ros_service import ServiceError, call_service


class FollowerError(Exception):
    """The robot's own follower cannot be used; the message says why."""


class ServiceFollower:
    """A follower with turtlebot_msgs/SetFollowState.

    Args:
        service: its name
        timeout_s: for each call
    """

    def __init__(self, service: str, *, timeout_s: float) -> None:
        self._service = service
        self._timeout_s = timeout_s

    def start(self) -> None:
        """Make it follow.

        Raises:
            FollowerError: the service is missing, silent, or refuses
        """
        self._set(SetFollowStateRequest.FOLLOW)

    def stop(self) -> None:
        """Make it stop.

        Raises:
            FollowerError: the service is missing, silent, or refuses
        """
        self._set(SetFollowStateRequest.STOPPED)

    def problem(self) -> str:
        """Return why it no longer follows; unknown, because a service does not say so."""
        return ""

    def _set(self, state: int) -> None:
        try:
            answer = call_service(self._service, SetFollowState, timeout_s=self._timeout_s, state=state)
        except ServiceError as error:
            raise FollowerError(str(error)) from error
        if answer.result != SetFollowStateResponse.OK:
            raise FollowerError(f"the service {self._service} refused: its result is {answer.result}")


class LaunchFollower:
    """A follower in a launch file. The launch file runs while the robot follows.

    Args:
        path: of the launch file
        timeout_s: how long its nodes may take to end
    """

    def __init__(self, path: str, *, timeout_s: float) -> None:
        self._path = path
        self._timeout_s = timeout_s
        self._process: Optional[subprocess.Popen] = None

    def start(self) -> None:
        """Launch it.

        Raises:
            FollowerError: the file or roslaunch does not exist
        """
        if not os.path.isfile(self._path):
            raise FollowerError(f"~launchfile: there is no file {self._path!r}")
        try:
            # In a process group of its own, so that an interrupt in the terminal does not reach it before stop() does.
            self._process = subprocess.Popen(
                ["roslaunch", self._path], stdin=subprocess.DEVNULL, start_new_session=True
            )
        except OSError as error:
            raise FollowerError(f"roslaunch cannot be started: {error}") from error

    def stop(self) -> None:
        """End all launched processes."""
        process, self._process = self._process, None
        if process is None:
            return
        # Killing roslaunch would leave its nodes running, so it gets time to end them.
        for signal_number, patience in ((signal.SIGINT, 10.0), (signal.SIGTERM, 5.0), (signal.SIGKILL, 1.0)):
            try:
                os.killpg(process.pid, signal_number)
                process.wait(patience * self._timeout_s)
                return
            except ProcessLookupError:
                process.wait(self._timeout_s)
                return
            except subprocess.TimeoutExpired:
                rospy.logwarn("%s does not end", self._path)

    def problem(self) -> str:
        """Return why it no longer follows; empty while it does."""
        if self._process is not None and self._process.poll() is not None:
            return f"the launch file ended with status {self._process.returncode}"
        return ""
