#!/usr/bin/python3
"""ServiceState with a real service."""

import threading
import unittest

import rospy
import rostest
from std_srvs.srv import Empty, SetBool, SetBoolRequest, SetBoolResponse, TriggerRequest

import smach
import smach_ros


class ServiceStateTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.asked = []
        rospy.Service("switch", SetBool, cls.switch)
        rospy.Service("broken", SetBool, lambda request: 1 / 0)

    @classmethod
    def switch(cls, request):
        cls.asked.append(request.data)
        return SetBoolResponse(success=request.data, message="switched")

    def setUp(self):
        del self.asked[:]

    def run_in_machine(self, state, userdata=None, outcomes=("succeeded", "aborted", "preempted")):
        """Return the outcome of the state and the userdata behind it."""
        machine = smach.StateMachine(list(outcomes))
        for key, value in (userdata or {}).items():
            machine.userdata[key] = value
        with machine:
            smach.StateMachine.add("CALL", state)
        return machine.execute(), machine.userdata

    def test_requests(self):
        @smach.cb_interface(input_keys=["on"])
        def make(userdata, request, is_inverted=False):
            return SetBoolRequest(data=userdata.on != is_inverted)

        def change(userdata, request):
            request.data = True

        userdata = {"on": True, "data": True, "whole": SetBoolRequest(data=True)}
        for kwargs, expected in (
            ({}, False),
            ({"request": SetBoolRequest(data=True)}, True),
            ({"request": True}, True),
            ({"request_key": "data"}, True),
            ({"request_cb": lambda userdata, request: True}, True),
            ({"request_key": "whole"}, True),
            ({"request_slots": ["data"]}, True),
            ({"request_cb": change}, True),
            ({"request_cb": make}, True),
            ({"request_cb": make, "request_cb_args": [True]}, False),
            ({"request_cb": make, "request_cb_kwargs": {"is_inverted": True}}, False),
        ):
            del self.asked[:]
            outcome, _ = self.run_in_machine(smach_ros.ServiceState("switch", SetBool, **kwargs), userdata)
            self.assertEqual((outcome, self.asked), ("succeeded", [expected]), kwargs)

    def test_response_into_userdata_and_callback(self):
        @smach.cb_interface(outcomes=["is_on"], output_keys=["seen"])
        def judge(userdata, response, *args, **kwargs):
            userdata.seen = (args, kwargs)
            return "is_on" if response.success else None

        for data, expected in ((True, "is_on"), (False, "succeeded")):
            state = smach_ros.ServiceState(
                "switch",
                SetBool,
                SetBoolRequest(data=data),
                response_cb=judge,
                response_cb_args=[1],
                response_cb_kwargs={"a": 2},
                response_key="whole",
                response_slots=["message"],
            )
            outcome, userdata = self.run_in_machine(state, outcomes=("succeeded", "aborted", "preempted", "is_on"))
            self.assertEqual(
                (outcome, userdata.whole.success, userdata.message, userdata.seen),
                (expected, data, "switched", ((1,), {"a": 2})),
            )
        for bad in (lambda ud, response: "unknown", lambda ud, response: 1 / 0):
            self.assertEqual(
                self.run_in_machine(smach_ros.ServiceState("switch", SetBool, response_cb=bad))[0], "aborted"
            )

    def test_wrong_requests(self):
        for kwargs in (
            {"request": TriggerRequest()},
            {"request": lambda ud, request: None},
            {"request_slots": ["nothing"]},
            {"response_slots": ["nothing"]},
        ):
            with self.assertRaises(smach.InvalidStateError, msg=str(kwargs)):
                smach_ros.ServiceState("switch", SetBool, **kwargs)
        with self.assertRaises(smach.InvalidStateError):
            smach_ros.ServiceState("broken", Empty, True)

    def test_request_that_cannot_be_made_aborts_the_state(self):
        for kwargs in (
            {"request_cb": lambda ud, request: 1 / 0},
            {"request_cb": lambda ud, request: TriggerRequest()},
            {"request_cb": lambda ud, request: "text"},
            {"request_key": "missing"},
            {"request_slots": ["data"]},
        ):
            outcome, _ = self.run_in_machine(smach_ros.ServiceState("switch", SetBool, **kwargs))
            self.assertEqual(outcome, "aborted", kwargs)
        self.assertEqual(self.asked, [])

    def test_outcomes_that_a_request_callback_declares_are_none_of_the_state(self):
        make = smach.CBInterface(lambda userdata, request: SetBoolRequest(data=True), ["made"])
        state = smach_ros.ServiceState("switch", SetBool, request_cb=make)
        self.assertEqual(set(state.get_registered_outcomes()), {"succeeded", "aborted", "preempted"})
        self.assertEqual(self.run_in_machine(state)[0], "succeeded")

    def test_failures(self):
        self.assertEqual(self.run_in_machine(smach_ros.ServiceState("broken", SetBool))[0], "aborted")
        self.assertEqual(self.run_in_machine(smach_ros.ServiceState("switch", Empty))[0], "aborted", "another type")
        absent = smach_ros.ServiceState("absent", Empty, server_wait_timeout=rospy.Duration(0.3))
        self.assertEqual(self.run_in_machine(absent)[0], "aborted")

    def test_request_to_stop_while_the_service_is_missing(self):
        state, outcomes = smach_ros.ServiceState("absent", Empty), []
        thread = threading.Thread(target=lambda: outcomes.append(self.run_in_machine(state)[0]), daemon=True)
        thread.start()
        state.request_preempt()
        thread.join(20.0)
        self.assertEqual(outcomes, ["preempted"])
        self.assertFalse(state.preempt_requested())


if __name__ == "__main__":
    rospy.init_node("test_service_state")
    rostest.rosrun("smach_ros", "service_state", ServiceStateTest)
