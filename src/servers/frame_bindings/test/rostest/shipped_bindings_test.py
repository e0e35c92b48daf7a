#!/usr/bin/python3
"""The shipped binding files: each frame is accepted, and its goal arrives as the bound server wants it."""

import unittest
from typing import Any, Callable, Dict, List, Tuple

import actionlib
import rospy
import rostest
from actionlib_msgs.msg import GoalStatus
from control_msgs.msg import (
    FollowJointTrajectoryAction,
    FollowJointTrajectoryResult,
    GripperCommandAction,
    GripperCommandResult,
)
from geometry_msgs.msg import PoseStamped
from kobuki_msgs.msg import AutoDockingAction, AutoDockingResult
from move_base_msgs.msg import MoveBaseAction
from play_motion_msgs.msg import PlayMotionAction, PlayMotionResult
from roboframenet_msgs.msg import (
    FilledFrameElement,
    FilledSemanticFrame,
    FilledSemanticFrameAction,
    FilledSemanticFrameGoal,
    FrameServers,
    Locations,
)
from sound_play.msg import SoundRequest

from roboframenet_ros.ros_waiting import wait_for_action_server
from roboframenet_testing import wait_until

BOUND = {
    "arm_extending": "extending_arm",
    "arm_retracting": "retracting_arm",
    "gripper_opening": "opening",
    "gripper_closing": "closing",
    "navigation": "navigating_to_location",
    "motion_of_waving": "waving",
    "motion_of_bowing": "bowing",
    "motion_of_retracting": "retracting_arm",
    "sound_play_saying": "saying",
    "kobuki_docking": "docking",
}


class Stub:
    """An action server that keeps its goals, and ends each as a function says."""

    is_jammed = False

    def __init__(self, name: str, action: Any, end: Callable[["Stub"], None]) -> None:
        self.goals: List[Any] = []
        self.server = actionlib.SimpleActionServer(name, action, self.execute, auto_start=False)
        self.end = end
        self.server.start()

    def execute(self, goal: Any) -> None:
        self.goals.append(goal)
        self.end(self)


class ShippedBindingsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls) -> None:
        cls.gripper = Stub("gripper_controller/gripper_cmd", GripperCommandAction, cls.grip)
        cls.base = Stub("move_base", MoveBaseAction, lambda stub: stub.server.set_succeeded())
        cls.dock = Stub(
            "dock_drive_action",
            AutoDockingAction,
            lambda stub: stub.server.set_aborted(AutoDockingResult("the station is out of sight")),
        )
        cls.arm = Stub("arm_controller/follow_joint_trajectory", FollowJointTrajectoryAction, cls.follow)
        cls.motions = Stub("play_motion", PlayMotionAction, cls.play)
        cls.said: List[SoundRequest] = []
        cls.sound = rospy.Subscriber("robotsound", SoundRequest, cls.said.append)
        pose = PoseStamped()
        pose.header.frame_id, pose.pose.position.x, pose.pose.orientation.w = "map", 3.0, 1.0
        cls.places = rospy.Publisher("locations", Locations, queue_size=1, latch=True)
        cls.places.publish(Locations(names=["office"], poses=[pose]))
        cls.servers: Dict[str, str] = {}
        cls.registered = rospy.Subscriber("frame_servers", FrameServers, cls.on_servers)

    @staticmethod
    def grip(stub: Stub) -> None:
        """End as a gripper around a thing: it stalls at 3 cm, and opens as far as nothing is in the way."""
        is_open = stub.goals[-1].command.position > 0.03 and not Stub.is_jammed
        stub.server.set_succeeded(GripperCommandResult(stalled=not is_open, reached_goal=is_open))

    @staticmethod
    def follow(stub: Stub) -> None:
        """End as a trajectory controller: a goal that the arm did not keep to is aborted with a code."""
        if len(stub.goals[-1].trajectory.points) == 1:
            stub.server.set_succeeded(FollowJointTrajectoryResult(error_code=0))
        else:
            result = FollowJointTrajectoryResult(error_code=-4, error_string="elbow_flex_joint is blocked")
            stub.server.set_aborted(result)

    @staticmethod
    def play(stub: Stub) -> None:
        """End as play_motion does: its server succeeds, and the result has a code."""
        if stub.goals[-1].motion_name == "bow":
            stub.server.set_succeeded(PlayMotionResult(PlayMotionResult.MOTION_NOT_FOUND, "there is no motion bow"))
        else:
            stub.server.set_succeeded(PlayMotionResult(PlayMotionResult.SUCCEEDED, ""))

    @classmethod
    def on_servers(cls, message: FrameServers) -> None:
        cls.servers = {one.callback_topic.lstrip("/"): one.frame_name for one in message.callbacks}

    def carry_out(self, server: str, **arguments: str) -> Tuple[int, str]:
        wait_until(lambda: server in self.servers)
        client = actionlib.ActionClient(server, FilledSemanticFrameAction)
        self.assertTrue(wait_for_action_server(client, 60.0), server)
        elements = [FilledFrameElement(name=name, argument=value) for name, value in arguments.items()]
        frame = FilledSemanticFrame(name=BOUND[server], frame_elements=elements)
        handle = client.send_goal(FilledSemanticFrameGoal(frame=frame))
        wait_until(lambda: handle.get_comm_state() == actionlib.CommState.DONE)
        return handle.get_goal_status(), handle.get_goal_status_text()

    def test_all_are_registered(self) -> None:
        wait_until(lambda: len(self.servers) >= len(BOUND))
        self.assertEqual(BOUND, self.servers)

    def test_grippers(self) -> None:
        for server, position, effort in (("gripper_opening", 0.08, 0.0), ("gripper_closing", 0.0, 20.0)):
            self.assertEqual((GoalStatus.SUCCEEDED, ""), self.carry_out(server, container_portal="gripper"))
            command = self.gripper.goals[-1].command
            self.assertEqual((position, effort), (command.position, command.max_effort))

    def test_a_door_is_not_opened_by_a_gripper(self) -> None:
        before = len(self.gripper.goals)
        self.assertEqual(GoalStatus.ABORTED, self.carry_out("gripper_opening", container_portal="door")[0])
        self.assertEqual(before, len(self.gripper.goals))

    def test_a_gripper_that_does_not_open_is_told(self) -> None:
        Stub.is_jammed = True
        self.addCleanup(setattr, Stub, "is_jammed", False)
        self.assertEqual(GoalStatus.ABORTED, self.carry_out("gripper_opening", container_portal="gripper")[0])

    def test_places(self) -> None:
        self.assertEqual(GoalStatus.SUCCEEDED, self.carry_out("navigation", goal="the office")[0])
        pose = self.base.goals[-1].target_pose
        self.assertEqual(("map", 3.0), (pose.header.frame_id, pose.pose.position.x))

    def test_motions(self) -> None:
        self.assertEqual(GoalStatus.SUCCEEDED, self.carry_out("motion_of_waving")[0])
        self.assertEqual(("wave", False), (self.motions.goals[-1].motion_name, self.motions.goals[-1].skip_planning))
        self.assertEqual(GoalStatus.SUCCEEDED, self.carry_out("motion_of_retracting")[0])
        self.assertEqual("home", self.motions.goals[-1].motion_name)

    def test_a_motion_that_fails_says_why(self) -> None:
        state, text = self.carry_out("motion_of_bowing")
        self.assertEqual((GoalStatus.ABORTED, True), (state, "there is no motion bow" in text), text)

    def test_trajectories(self) -> None:
        self.assertEqual(GoalStatus.SUCCEEDED, self.carry_out("arm_extending", limb="arm")[0])
        trajectory = self.arm.goals[-1].trajectory
        self.assertEqual((4, 4), (len(trajectory.joint_names), len(trajectory.points[0].positions)))
        self.assertEqual(4.0, trajectory.points[0].time_from_start.to_sec())

    def test_a_trajectory_that_fails_says_why(self) -> None:
        state, text = self.carry_out("arm_retracting")
        self.assertEqual((GoalStatus.ABORTED, True), (state, "elbow_flex_joint is blocked" in text), text)

    def test_another_limb_is_not_moved(self) -> None:
        before = len(self.arm.goals)
        self.assertEqual(GoalStatus.ABORTED, self.carry_out("arm_extending", limb="left arm")[0])
        self.assertEqual(before, len(self.arm.goals))

    def test_sound_play(self) -> None:
        self.assertEqual(GoalStatus.SUCCEEDED, self.carry_out("sound_play_saying", message="hello")[0])
        wait_until(lambda: len(self.said) > 0)
        (said,) = self.said
        self.assertEqual(
            (SoundRequest.SAY, SoundRequest.PLAY_ONCE, 1.0, "hello"), (said.sound, said.command, said.volume, said.arg)
        )

    def test_docking_that_fails_says_why(self) -> None:
        state, text = self.carry_out("kobuki_docking")
        self.assertEqual((GoalStatus.ABORTED, True), (state, "the station is out of sight" in text), text)
        self.assertEqual(1, len(self.dock.goals))


if __name__ == "__main__":
    rospy.init_node("shipped_bindings_test")
    rostest.rosrun("frame_bindings", "shipped_bindings", ShippedBindingsTest)
