#!/usr/bin/python3
"""Programs in the shapes of public tutorials and books, with simulated robots."""

import threading
import unittest

import actionlib
import rospy
import rostest
from actionlib.msg import TestAction, TestGoal, TestResult
from actionlib_msgs.msg import GoalStatus
from std_msgs.msg import Float32
from std_srvs.srv import Empty, EmptyResponse, SetBool, SetBoolRequest, SetBoolResponse

import smach
import smach_ros
from roboframenet_testing import wait_until

OUTCOMES = ["succeeded", "aborted", "preempted"]
# Goals from this number on run until they are cancelled or released.
LONG = 100


class Robot:
    """Action servers and services that note what they are asked."""

    def __init__(self):
        self.calls = []
        self.released = threading.Event()
        rospy.Service("reset", Empty, lambda request: self.calls.append("reset") or EmptyResponse())
        rospy.Service("charger", SetBool, self._charge)
        self._servers = [self._server(name) for name in ("move", "draw_big", "draw_small")]
        self._battery = rospy.Publisher("battery", Float32, queue_size=5, latch=True)
        self.set_battery(100.0)

    def set_battery(self, level):
        self._battery.publish(Float32(level))

    def _charge(self, request):
        self.calls.append(("charge", request.data))
        self.set_battery(100.0)
        return SetBoolResponse(True, "charged")

    def _server(self, name):
        def execute(goal):
            self.calls.append((name, goal.goal))
            while goal.goal >= LONG and not self.released.is_set():
                if server.is_preempt_requested():
                    self.calls.append((name, "cancelled"))
                    server.set_preempted()
                    return
                rospy.sleep(0.01)
            server.set_succeeded(TestResult(goal.goal))

        server = actionlib.SimpleActionServer(name, TestAction, execute, auto_start=False)
        server.start()
        return server


class ProgramsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.robot = Robot()

    def setUp(self):
        del self.robot.calls[:]
        self.robot.released.clear()
        self.robot.set_battery(100.0)

    def start(self, machine):
        """Run a machine in a thread, as the tutorials do; return a function that waits for its outcome."""
        outcomes = []
        thread = threading.Thread(target=lambda: outcomes.append(machine.execute()), daemon=True)
        thread.start()

        def join():
            thread.join(30.0)
            return outcomes

        return join

    # A patrol that recharges

    def patrol(self, rounds, goals):
        """A machine that visits places round by round, and counts in userdata."""

        @smach.cb_interface(input_keys=["rounds"], output_keys=["rounds"], outcomes=["again", "succeeded"])
        def count(userdata):
            userdata.rounds += 1
            return "again" if userdata.rounds <= rounds else "succeeded"

        def note(userdata, status, result):
            if status == GoalStatus.SUCCEEDED:
                self.visited.append(result.result)

        self.visited = []
        machine = smach.StateMachine(outcomes=OUTCOMES)
        machine.userdata.rounds = 0
        with machine:
            smach.StateMachine.add("COUNT", smach.CBState(count), {"again": "PLACE_0", "succeeded": ""})
            labels = [f"PLACE_{number}" for number in range(len(goals))]
            for label, following, goal in zip(labels, [*labels[1:], "COUNT"], goals):
                state = smach_ros.SimpleActionState(
                    "move",
                    TestAction,
                    goal=TestGoal(goal),
                    result_cb=note,
                    exec_timeout=rospy.Duration(0),
                    server_wait_timeout=rospy.Duration(10.0),
                )
                smach.StateMachine.add(
                    label, state, transitions={"succeeded": following, "aborted": following, "preempted": ""}
                )
        return machine

    def test_patrol_goes_its_rounds(self):
        machine = self.patrol(2, [1, 2, 3])
        viewer = smach_ros.IntrospectionServer("patrol", machine, "/SM_ROOT")
        viewer.start()
        outcome = machine.execute()
        viewer.stop()
        self.assertEqual((outcome, self.visited), ("succeeded", [1, 2, 3, 1, 2, 3]))

    def guarded_patrol(self, patrol):
        """The patrol beside a monitor of the battery; a low battery stops it and leads to the charger, and back."""

        def is_high(userdata, message):
            return message.data > 50.0

        def ended(outcomes):
            return outcomes["PATROL"] == "succeeded" or outcomes["BATTERY"] == "invalid"

        def choose(outcomes):
            if outcomes["BATTERY"] == "invalid":
                return "recharge"
            return "succeeded" if outcomes["PATROL"] == "succeeded" else "stop"

        guarded = smach.Concurrence(
            outcomes=["succeeded", "recharge", "stop"],
            default_outcome="succeeded",
            child_termination_cb=ended,
            outcome_cb=choose,
        )
        with guarded:
            smach.Concurrence.add("BATTERY", smach_ros.MonitorState("battery", Float32, is_high))
            smach.Concurrence.add("PATROL", patrol)
        top = smach.StateMachine(outcomes=OUTCOMES)
        with top:
            smach.StateMachine.add("GUARDED", guarded, {"succeeded": "", "recharge": "RECHARGE", "stop": "aborted"})
            smach.StateMachine.add(
                "RECHARGE",
                smach_ros.ServiceState("charger", SetBool, True, response_cb=lambda userdata, response: "succeeded"),
                {"succeeded": "GUARDED", "aborted": "", "preempted": ""},
            )
        return top

    def test_patrol_stops_for_the_charger_and_goes_on(self):
        patrol = self.patrol(1, [LONG])
        join = self.start(self.guarded_patrol(patrol))
        wait_until(lambda: ("move", LONG) in self.robot.calls)
        self.robot.set_battery(20.0)
        wait_until(lambda: ("charge", True) in self.robot.calls)
        # The second run counts a second round and ends the patrol at once.
        self.assertEqual(join(), ["succeeded"])
        self.assertEqual(self.robot.calls, [("move", LONG), ("move", "cancelled"), ("charge", True)])
        self.assertFalse(patrol.preempt_requested())

    def test_patrol_is_stopped_from_outside(self):
        machine = self.guarded_patrol(self.patrol(1, [LONG]))
        join = self.start(machine)
        wait_until(lambda: ("move", LONG) in self.robot.calls)
        machine.request_preempt()
        self.assertEqual(join(), ["aborted"])
        self.assertIn(("move", "cancelled"), self.robot.calls)

    # Drawings, interrupted while somebody is near

    def drawing(self):
        """Two drawings at once; the small one is interrupted by a monitor, waits, and begins anew."""
        root = smach.StateMachine(outcomes=OUTCOMES)
        with root:
            smach.StateMachine.add("RESET", smach_ros.ServiceState("reset", Empty), {"succeeded": "SPAWN"})
            smach.StateMachine.add(
                "SPAWN", smach_ros.ServiceState("charger", SetBool, SetBoolRequest(False)), {"succeeded": "DRAW"}
            )
            both = smach.Concurrence(
                outcomes=OUTCOMES,
                default_outcome="aborted",
                outcome_map={"succeeded": {"BIG": "succeeded", "SMALL": "succeeded"}},
            )
            smach.StateMachine.add("DRAW", both)
            with both:
                smach.Concurrence.add("BIG", smach_ros.SimpleActionState("draw_big", TestAction, goal=TestGoal(1)))
                small = smach.StateMachine(outcomes=OUTCOMES)
                smach.Concurrence.add("SMALL", small)
                with small:
                    smach.StateMachine.add(
                        "START", smach_ros.ServiceState("reset", Empty), {"succeeded": "DRAW_WITH_MONITOR"}
                    )
                    monitored = smach.Concurrence(
                        outcomes=[*OUTCOMES, "interrupted"],
                        default_outcome="aborted",
                        child_termination_cb=lambda outcomes: True,
                        outcome_map={
                            "succeeded": {"DRAW": "succeeded"},
                            "preempted": {"DRAW": "preempted", "MONITOR": "preempted"},
                            "interrupted": {"MONITOR": "invalid"},
                        },
                    )
                    smach.StateMachine.add("DRAW_WITH_MONITOR", monitored, {"interrupted": "WAIT"})
                    with monitored:
                        smach.Concurrence.add(
                            "DRAW", smach_ros.SimpleActionState("draw_small", TestAction, goal=TestGoal(LONG))
                        )
                        smach.Concurrence.add(
                            "MONITOR",
                            smach_ros.MonitorState("battery", Float32, lambda userdata, message: message.data > 50.0),
                        )
                    smach.StateMachine.add(
                        "WAIT",
                        smach_ros.MonitorState("battery", Float32, lambda userdata, message: message.data < 50.0),
                        {"valid": "WAIT", "invalid": "START", "preempted": "preempted"},
                    )
        return root

    def test_drawing_is_interrupted_and_begins_anew(self):
        join = self.start(self.drawing())
        wait_until(lambda: ("draw_small", LONG) in self.robot.calls)
        self.robot.set_battery(20.0)
        wait_until(lambda: ("draw_small", "cancelled") in self.robot.calls)
        self.robot.set_battery(90.0)
        wait_until(lambda: self.robot.calls.count(("draw_small", LONG)) == 2)
        self.robot.released.set()
        self.assertEqual(join(), ["succeeded"])
        self.assertEqual(self.robot.calls.count("reset"), 3)
        self.assertEqual(self.robot.calls.count(("draw_big", 1)), 1)

    def test_drawing_is_stopped_from_outside(self):
        machine = self.drawing()
        join = self.start(machine)
        wait_until(lambda: ("draw_small", LONG) in self.robot.calls and ("draw_big", 1) in self.robot.calls)
        machine.request_preempt()
        self.assertEqual(join(), ["aborted"], "the default outcome: one drawing was done")
        self.assertIn(("draw_small", "cancelled"), self.robot.calls)

    # Recovery

    def test_callback_that_fails_leads_to_the_recovery(self):
        def broken(userdata, *args):
            raise RuntimeError("broken on purpose")

        for state in (
            smach_ros.SimpleActionState("move", TestAction, goal_cb=broken),
            smach_ros.SimpleActionState("move", TestAction, result_cb=broken),
            smach_ros.ServiceState("reset", Empty, request_cb=broken),
            smach_ros.ServiceState("reset", Empty, response_cb=broken),
        ):
            del self.robot.calls[:]
            machine = smach.StateMachine(outcomes=["done", "recovered"])
            with machine:
                smach.StateMachine.add("TRY", state, {"succeeded": "done", "aborted": "RECOVER", "preempted": "done"})
                smach.StateMachine.add(
                    "RECOVER",
                    smach_ros.ServiceState("charger", SetBool, False),
                    {"succeeded": "recovered", "aborted": "done", "preempted": "done"},
                )
            self.assertEqual(machine.execute(), "recovered")
            self.assertIn(("charge", False), self.robot.calls)

    def test_transitions_are_in_the_log_of_ros(self):
        from rosgraph_msgs.msg import Log

        seen = []
        subscriber = rospy.Subscriber("/rosout", Log, lambda message: seen.append((message.level, message.msg)))
        wait_until(lambda: subscriber.get_num_connections() > 0)
        machine = smach.StateMachine(outcomes=["succeeded"])
        with machine:
            smach.StateMachine.add("ONLY", smach.CBState(lambda userdata: "succeeded", outcomes=["succeeded"]))
        machine.execute()
        smach.logwarn("%s is %d%%", "battery", 20)
        wait_until(
            lambda: (
                (Log.INFO, "State machine terminating 'ONLY':'succeeded':'succeeded'") in seen
                and (Log.WARN, "battery is 20%") in seen
            )
        )
        subscriber.unregister()


if __name__ == "__main__":
    rospy.init_node("test_programs")
    rostest.rosrun("smach_ros", "programs", ProgramsTest)
