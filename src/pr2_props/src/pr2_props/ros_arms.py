"""The arms of a PR2, through their trajectory controllers."""

import queue
import threading
import time
from typing import Callable, Dict, Mapping, Sequence, Tuple

import actionlib
import rospy
from actionlib_msgs.msg import GoalStatus
from pr2_controllers_msgs.msg import JointTrajectoryAction, JointTrajectoryGoal
from sensor_msgs.msg import JointState
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint

from pr2_props.props import JOINTS, RETURN_S, Arm, JointLimit, Pose, Props, check, joint_names
from roboframenet_ros.ros_waiting import wait_for_action_server

#: Period of checks of running trajectories, seconds.
POLL_S = 0.05


class ArmError(RuntimeError):
    """The arms failed; the message is the reason, for a person."""


class Arms:
    """Both arms.

    Actions:
        r_arm_controller/joint_trajectory_action, l_arm_controller/joint_trajectory_action
        (pr2_controllers_msgs/JointTrajectoryAction): client
    Subscribes:
        joint_states (sensor_msgs/JointState)
    """

    def __init__(self, props: Props, limits: Mapping[str, JointLimit], *, server_timeout_s: float) -> None:
        """
        Args:
            props: what the arms can do
            limits: by name of joint
            server_timeout_s: how long to wait for a controller, seconds
        """
        self._props = props
        self._limits = limits
        self._server_timeout_s = server_timeout_s
        self._lock = threading.Lock()
        self._positions: Dict[str, float] = {}
        self._subscriber = rospy.Subscriber("joint_states", JointState, self._on_joints, queue_size=1)
        self._clients = {
            arm: actionlib.ActionClient(f"{arm.prefix}_arm_controller/joint_trajectory_action", JointTrajectoryAction)
            for arm in Arm
        }

    def _on_joints(self, message: JointState) -> None:
        with self._lock:
            self._positions.update(zip(message.name, message.position))

    def perform(self, name: str, arms: Sequence[Arm] = (), *, is_wanted: Callable[[], bool]) -> bool:
        """Run the trajectories of a prop, all arms at once, and end in the safe pose.

        Args:
            name: of the prop
            arms: that move; empty for the usual ones
            is_wanted: called repeatedly; False moves the arms back to the safe pose
        Returns:
            whether the prop was completed; False when it was no longer wanted
        Raises:
            ArmError: a controller or joint states are missing, a limit would be exceeded, or a controller gave up
        """
        try:
            moving = tuple(arms) or self._props.usual_arms[name]
            poses = {arm: self._props.trajectories[name][arm] for arm in moving}
            if self._run(name, poses, is_wanted=is_wanted):
                return True
        except ArmError:
            self.return_to_safe_pose()
            raise
        self.return_to_safe_pose()
        return False

    def return_to_safe_pose(self) -> None:
        """Move both arms back; wait until they have arrived or have failed."""
        poses = {arm: (Pose(at_s=RETURN_S, positions_rad=self._props.safe_rad[arm]),) for arm in Arm}
        try:
            self._run("safe pose", poses, is_wanted=lambda: not rospy.is_shutdown())
        except ArmError as error:
            rospy.logerr("the arms are not in the safe pose: %s", error)

    def _run(self, name: str, poses: Mapping[Arm, Sequence[Pose]], *, is_wanted: Callable[[], bool]) -> bool:
        ended: queue.Queue[Tuple[Arm, actionlib.ClientGoalHandle]] = queue.Queue()
        handles = {arm: self._send(name, arm, poses[arm], ended) for arm in poses}
        end = time.monotonic() + max(trajectory[-1].at_s for trajectory in poses.values()) + self._server_timeout_s
        try:
            while handles:
                if not is_wanted():
                    return False
                try:
                    arm, handle = ended.get(timeout=POLL_S)
                except queue.Empty:
                    if time.monotonic() >= end:
                        raise ArmError(f"the {next(iter(handles)).value} arm did not finish in time") from None
                    continue
                del handles[arm]
                if handle.get_goal_status() != GoalStatus.SUCCEEDED:
                    raise ArmError(f"the {arm.value} arm gave up: {handle.get_goal_status_text() or 'no reason given'}")
            return True
        finally:
            for handle in handles.values():
                handle.cancel()

    def _send(self, name: str, arm: Arm, poses: Sequence[Pose], ended: "queue.Queue") -> actionlib.ClientGoalHandle:
        with self._lock:
            missing = [joint for joint in joint_names(arm) if joint not in self._positions]
            start = [self._positions.get(joint, 0.0) for joint in joint_names(arm)]
        if missing:
            raise ArmError(f"no joint state of {missing[0]} yet")
        try:
            check(name, arm, start, poses, self._limits)
        except ValueError as error:
            raise ArmError(str(error)) from error
        client = self._clients[arm]
        if not wait_for_action_server(client, self._server_timeout_s):
            raise ArmError(f"the controller of the {arm.value} arm is not there (waited {self._server_timeout_s:g} s)")

        def on_transition(handle: actionlib.ClientGoalHandle) -> None:
            if handle.get_comm_state() == actionlib.CommState.DONE:
                ended.put((arm, handle))

        return client.send_goal(JointTrajectoryGoal(trajectory=_message(arm, poses)), on_transition)


def _message(arm: Arm, poses: Sequence[Pose]) -> JointTrajectory:
    points = [
        JointTrajectoryPoint(
            positions=pose.positions_rad, velocities=[0.0] * len(JOINTS), time_from_start=rospy.Duration(pose.at_s)
        )
        for pose in poses
    ]
    return JointTrajectory(joint_names=joint_names(arm), points=points)
