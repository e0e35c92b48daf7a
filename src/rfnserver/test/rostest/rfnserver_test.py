#!/usr/bin/python3
"""RFNServer against a registrar that lives in the test: goals, preemption, registration."""

import tempfile
import threading
import time
import unittest
from typing import Any, Callable, List, Set
from unittest import mock

import actionlib
import rospy
from actionlib_msgs.msg import GoalID, GoalStatus, GoalStatusArray
from actionlib_tutorials.msg import FibonacciAction, FibonacciGoal
from roboframenet_msgs.msg import (
    FilledFrameElement,
    FilledSemanticFrame,
    FilledSemanticFrameAction,
    FilledSemanticFrameGoal,
    FrameCallback,
    FrameServers,
    Lexicon,
)
from roboframenet_msgs.srv import (
    AddLexicalUnit,
    AddLexicalUnitRequest,
    AddLexicalUnitResponse,
    RegisterServer,
    RegisterServerRequest,
    RegisterServerResponse,
    RegisterWithFrame,
    RegisterWithFrameRequest,
    RegisterWithFrameResponse,
)

from rfnserver import RFNServer, ros_registration
from rfnserver.registration import FrameFit, RequestKind
from rfnserver.ros_registration import Registration
from roboframenet_ros import ros_quiet_action_server
from roboframenet_testing import wait_until
from semantic_frames.ros_server_profile import profile_from_message
from semantic_frames.server_statement import stated_profile


class Goal:
    """A goal sent to a server, and what came of it."""

    def __init__(self, name: str, frame: FilledSemanticFrame) -> None:
        self.client = actionlib.ActionClient(name, FilledSemanticFrameAction)
        assert self.client.wait_for_server(rospy.Duration(60.0)), f"no server {name}"
        self.handle = self.client.send_goal(FilledSemanticFrameGoal(frame=frame))

    def wait(self) -> int:
        """Wait for the end; return the status."""
        wait_until(lambda: self.handle.get_comm_state() == actionlib.CommState.DONE, message="the goal does not end")
        return self.handle.get_goal_status()


class Registrar:
    """Just enough of a registrar: the service and the latched topic."""

    def __init__(self, registrar_id: str) -> None:
        self.requests: List[RegisterWithFrameRequest] = []
        self._id = registrar_id
        self._publisher = rospy.Publisher("frame_servers", FrameServers, queue_size=1, latch=True)
        self._service = rospy.Service("register_with_frame", RegisterWithFrame, self._on_register)
        self._publish()

    def restart(self, registrar_id: str) -> None:
        """Forget everything, as a new process has.

        The publisher stays: rospy may connect to one of its own process while that is replaced, and not try again.
        A registrar that is really killed is among the tests of the whole.
        """
        self._id = registrar_id
        self.requests = []
        self._publish()

    def _publish(self) -> None:
        self._publisher.publish(
            FrameServers(
                registrar_id=self._id,
                callbacks=[
                    FrameCallback(frame_name=request.frame_name, callback_topic=request.callback_topic, is_alive=True)
                    for request in self.requests
                ],
            )
        )

    def _on_register(self, request: RegisterWithFrameRequest) -> RegisterWithFrameResponse:
        if request.frame_name == "forbidden":
            return RegisterWithFrameResponse(success=False, error=["not this one"])
        self.requests.append(request)
        self._publish()
        remark = ["no file describes it yet"] if request.frame_name == "brodcasting" else []
        return RegisterWithFrameResponse(success=True, error=remark)


class Framer:
    """A framer that refuses every file, and tells its lexicon each time."""

    def __init__(self) -> None:
        self.refused = 0
        self._publisher = rospy.Publisher("lexicon", Lexicon, queue_size=1000, latch=True)
        self._service = rospy.Service("add_lexical_unit", AddLexicalUnit, self._on_add)
        self.publish()

    def publish(self) -> None:
        self._publisher.publish(Lexicon(framer_id="framer"))

    def _on_add(self, _request: AddLexicalUnitRequest) -> AddLexicalUnitResponse:
        self.refused += 1
        self.publish()
        return AddLexicalUnitResponse(success=False)


class RFNServerTest(unittest.TestCase):
    """One behaviour in each method."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.registrar = Registrar("first")

    def serve(self, name: str, callback: Callable[[Any], Any]) -> RFNServer:
        server = RFNServer(name, callback)
        server.start()
        return server

    def test_callback_gets_the_filled_frame_and_the_goal_succeeds(self) -> None:
        seen: List[FilledSemanticFrame] = []
        self.serve("seeing", seen.append)
        frame = FilledSemanticFrame(name="seeing", frame_elements=[FilledFrameElement("what", "the door")])
        goal = Goal("seeing", frame)
        self.assertEqual(goal.wait(), GoalStatus.SUCCEEDED)
        self.assertTrue(goal.handle.get_result().success)
        self.assertEqual(seen, [frame])

    def test_exception_aborts_with_its_reason(self) -> None:
        def fall_over(_frame: FilledSemanticFrame) -> None:
            raise RuntimeError("no legs")

        self.serve("falling", fall_over)
        goal = Goal("falling", FilledSemanticFrame())
        self.assertEqual(goal.wait(), GoalStatus.ABORTED)
        self.assertIn("no legs", goal.handle.get_goal_status_text())

    def test_callback_may_abort_with_a_text(self) -> None:
        server = self.serve("refusing", lambda _frame: server.set_aborted(None, "I would rather not"))
        goal = Goal("refusing", FilledSemanticFrame())
        self.assertEqual(goal.wait(), GoalStatus.ABORTED)
        self.assertEqual(goal.handle.get_goal_status_text(), "I would rather not")

    def test_cancelled_goal_is_preempted(self) -> None:
        asked = threading.Event()
        server = self.serve("dreaming", lambda _frame: asked.wait(60.0))
        server.register_preempt_callback(asked.set)
        goal = Goal("dreaming", FilledSemanticFrame())
        wait_until(server.is_active)
        goal.handle.cancel()
        self.assertEqual(goal.wait(), GoalStatus.PREEMPTED)
        self.assertFalse(goal.handle.get_result().success)

    def test_goals_back_to_back_lose_no_wake_up(self) -> None:
        self.serve("counting", lambda _frame: None)
        for _ in range(100):
            self.assertEqual(Goal("counting", FilledSemanticFrame()).wait(), GoalStatus.SUCCEEDED)

    def test_clock_that_was_set_back_leaves_the_server_usable(self) -> None:
        asked = threading.Event()

        def rest(frame: FilledSemanticFrame) -> None:
            if frame.name == "long":
                asked.wait(60.0)

        server = self.serve("resting", rest)
        server.register_preempt_callback(asked.set)
        cancel = rospy.Publisher("resting/cancel", GoalID, queue_size=10)
        wait_until(lambda: cancel.get_num_connections() == 1)
        # Stamps from before the clock was set back are in the future.
        later = mock.patch.object(rospy.Time, "now", lambda now=rospy.Time.now: now() + rospy.Duration(3600.0))
        with later:
            self.assertEqual(Goal("resting", FilledSemanticFrame()).wait(), GoalStatus.SUCCEEDED)
            running = Goal("resting", FilledSemanticFrame(name="long"))
            wait_until(server.is_active)
        cancel.publish(GoalID(stamp=rospy.Time.now()))
        self.assertEqual(running.wait(), GoalStatus.PREEMPTED)
        self.assertEqual(Goal("resting", FilledSemanticFrame()).wait(), GoalStatus.SUCCEEDED)
        with later:
            cancel.publish(GoalID(stamp=rospy.Time.now()))
            wait_until(lambda: not server.action_server.last_cancel.is_zero())
        self.assertEqual(Goal("resting", FilledSemanticFrame()).wait(), GoalStatus.SUCCEEDED)

    def test_goal_that_is_over_stands_in_nobodys_way(self) -> None:
        self.serve("hurrying", lambda _frame: None)
        now = rospy.Time.now()
        # The clock of one host is half a second ahead of the other's; and no clock has arrived.
        for stamp in (now + rospy.Duration.from_sec(0.5), now, rospy.Time(), rospy.Time()):
            with mock.patch.object(rospy.Time, "now", lambda stamp=stamp: rospy.Time(stamp.secs, stamp.nsecs)):
                self.assertEqual(Goal("hurrying", FilledSemanticFrame()).wait(), GoalStatus.SUCCEEDED)

    def test_clock_set_back_by_less_than_a_second_is_noticed(self) -> None:
        asked = threading.Event()
        server = self.serve("dawdling", lambda frame: frame.name == "long" and asked.wait(60.0))
        server.register_preempt_callback(asked.set)
        ahead = rospy.Duration.from_sec(0.9)
        with mock.patch.object(rospy.Time, "now", lambda now=rospy.Time.now: now() + ahead):
            running = Goal("dawdling", FilledSemanticFrame(name="long"))
            wait_until(server.is_active)
        self.assertEqual(Goal("dawdling", FilledSemanticFrame()).wait(), GoalStatus.SUCCEEDED)
        self.assertEqual(running.wait(), GoalStatus.PREEMPTED)

    def test_idle_server_is_silent_and_still_found(self) -> None:
        self.serve("sleeping", lambda _frame: None)
        statuses: List[GoalStatusArray] = []
        subscriber = rospy.Subscriber("sleeping/status", GoalStatusArray, statuses.append)
        wait_until(lambda: len(statuses) == 1)
        time.sleep(1.0)
        self.assertEqual(len(statuses), 1)
        subscriber.unregister()

    def test_status_tells_of_the_last_goals_that_are_over(self) -> None:
        self.serve("hurrying_on", lambda _frame: None)
        most = ros_quiet_action_server.MOST_OVER
        counts: List[int] = []
        subscriber = rospy.Subscriber(
            "hurrying_on/status", GoalStatusArray, lambda status: counts.append(len(status.status_list))
        )
        for _ in range(most + 20):
            self.assertEqual(Goal("hurrying_on", FilledSemanticFrame()).wait(), GoalStatus.SUCCEEDED)
        wait_until(lambda: max(counts) >= most)
        subscriber.unregister()
        # And the one that runs.
        self.assertLessEqual(max(counts), most + 1)

    def test_status_that_cannot_be_written_does_not_silence_the_server(self) -> None:
        server = self.serve("mumbling", lambda _frame: None)
        statuses: List[GoalStatusArray] = []
        subscriber = rospy.Subscriber("mumbling/status", GoalStatusArray, statuses.append)
        with mock.patch.object(server.action_server, "_forget_oldest", side_effect=RuntimeError("odd")) as failing:
            self.assertEqual(Goal("mumbling", FilledSemanticFrame()).wait(), GoalStatus.SUCCEEDED)
            wait_until(lambda: failing.called)
        count = len(statuses)
        wait_until(lambda: len(statuses) > count, message="the server is silent")
        subscriber.unregister()

    def test_idle_server_ends_at_once_when_ros_shuts_down(self) -> None:
        hooks: List[Callable[[], None]] = []
        with mock.patch.object(ros_quiet_action_server, "WAKE_UP_S", 1e5), mock.patch.object(
            rospy, "on_shutdown", hooks.append
        ):
            server = self.serve("ending", lambda _frame: None)
            self.assertEqual(Goal("ending", FilledSemanticFrame()).wait(), GoalStatus.SUCCEEDED)
            # While the hooks run, rospy.is_shutdown() is still false.
            for hook in hooks:
                hook()
            server.execute_thread.join(60.0)
        self.assertFalse(server.execute_thread.is_alive())

    def test_registers_again_with_a_registrar_that_restarted(self) -> None:
        server = RFNServer("returning", lambda _frame: None)
        self.assertTrue(server.register_with_frame("coming_back"))

        def frames() -> Set[str]:
            requests = [request for request in self.registrar.requests if request.callback_topic == "returning"]
            return {request.frame_name for request in requests}

        # Twice, where the state of before the registration arrives after it; that does no harm.
        self.assertEqual(frames(), {"coming_back"})
        self.registrar.restart("second")
        wait_until(lambda: frames() == {"coming_back"})

    def test_registrar_of_2012_gets_the_call_of_2012(self) -> None:
        warnings: List[str] = []
        with mock.patch.object(ros_registration.rospy, "logwarn", lambda text, *about: warnings.append(text % about)):
            server = RFNServer("gliding", lambda _frame: None, heeds={"Manner": ["slow"]})
            self.assertTrue(server.register_with_frame("gliding"), server.last_error)
        requests = [request for request in self.registrar.requests if request.callback_topic == "gliding"]
        self.assertEqual({request.frame_name for request in requests}, {"gliding"})
        self.assertTrue(any("as in 2012" in warning for warning in warnings), warnings)
        watcher = RFNServer("looking", lambda _frame: None, purpose="watches")
        self.assertFalse(watcher.register_with_frame("looking"))
        self.assertIn("only servers that act", watcher.last_error)

    def test_what_a_server_states_goes_to_a_registrar_that_takes_it(self) -> None:
        taken: List[RegisterServerRequest] = []

        def take(request: RegisterServerRequest) -> RegisterServerResponse:
            taken.append(request)
            return RegisterServerResponse(success=request.frame_name != "sailing", error=["no such element"])

        service = rospy.Service("register_server", RegisterServer, take)
        try:
            server = RFNServer("sliding", lambda _frame: None, heeds={"Manner": ["slow"]}, occupies="base")
            self.assertTrue(server.register_with_frame("sliding"), server.last_error)
            self.assertTrue(server.register_with_frame("skating", purpose="watches"), server.last_error)
            self.assertFalse(server.register_with_frame("sailing"))
            self.assertEqual(server.last_error, "no such element")
            plain = RFNServer("plain", lambda _frame: None)
            self.assertTrue(plain.register_with_frame("sliding"), plain.last_error)
        finally:
            service.shutdown()
        profiles = {request.frame_name: profile_from_message(request.profile) for request in taken}
        self.assertEqual(profiles["sliding"], stated_profile({"heeds": {"Manner": ["slow"]}, "occupies": "base"}))
        self.assertEqual(profiles["skating"], stated_profile({"purpose": "watches"}))
        self.assertEqual({request.server for request in taken}, {"sliding"})
        wait_until(lambda: any(request.callback_topic == "plain" for request in self.registrar.requests))

    def test_private_name_is_registered_as_the_one_that_others_use(self) -> None:
        frames = RFNServer("~gripping", lambda _frame: None)
        ported = RFNServer(
            "~fibonacci", FibonacciAction, execute_cb=lambda _goal: ported.set_succeeded(), auto_start=False
        )
        for server in (frames, ported):
            self.assertTrue(server.register_with_frame("gripping"), server.last_error)
            server.start()
        names = [request.callback_topic for request in self.registrar.requests if request.frame_name == "gripping"]
        self.assertEqual(set(names), {f"{rospy.get_name()}/gripping", f"{rospy.get_name()}/fibonacci/frame"})
        for name in set(names):
            frame = FilledSemanticFrame(frame_elements=[FilledFrameElement("order", "3")])
            self.assertEqual(Goal(name, frame).wait(), GoalStatus.SUCCEEDED)

    def test_words_that_no_field_takes_are_said_to_the_person(self) -> None:
        server = RFNServer("computing", FibonacciAction, execute_cb=lambda _goal: server.set_succeeded())
        self.assertTrue(server.register_with_frame("computing"))
        elements = [FilledFrameElement("order", "3"), FilledFrameElement("duration", "ten seconds")]
        goal = Goal("computing/frame", FilledSemanticFrame(name="computing", frame_elements=elements))
        self.assertEqual(goal.wait(), GoalStatus.ABORTED)
        self.assertIn('the duration "ten seconds"', goal.handle.get_goal_status_text())

    def test_refusal_is_false_with_the_reason(self) -> None:
        server = RFNServer("intruding", lambda _frame: None)
        self.assertFalse(server.register_with_frame("forbidden"))
        self.assertEqual(server.last_error, "not this one")

    def test_frame_that_no_file_describes_is_told_when_none_has_come(self) -> None:
        warnings: List[str] = []
        with mock.patch.object(ros_registration, "RETRY_S", 0.2), mock.patch.object(
            ros_registration.rospy, "logwarn", lambda text, *about: warnings.append(text % about)
        ):
            server = RFNServer("sending", lambda _frame: None)
            self.assertTrue(server.register_with_frame("brodcasting"))
            self.assertEqual(server.last_error, "")
            wait_until(lambda: warnings == ["sending: registered, but no file describes it yet"], message=warnings)

    def test_file_that_was_refused_makes_no_storm_of_requests(self) -> None:
        framer = Framer()
        server = RFNServer("stubborn", lambda _frame: None)
        with tempfile.NamedTemporaryFile("w", suffix=".yaml") as file:
            self.assertFalse(server.add_lexical_unit(file.name))
            self.assertIn("file_problems", server.last_error)
            # Each lexicon makes the server look for what is missing.
            for _ in range(100):
                framer.publish()
                time.sleep(0.005)
            # The first lexicon told which framer this is, and that counts as a change.
            self.assertLessEqual(framer.refused, 2)
            refused = framer.refused
            file.write("frame_name: waving\n")
            file.flush()
            framer.publish()
            wait_until(lambda: framer.refused == refused + 1, message="the changed file is not offered again")

    def test_file_that_does_not_exist_is_said(self) -> None:
        server = RFNServer("lost", lambda _frame: None)
        self.assertFalse(server.add_lexical_unit("/no/such/unit.yaml"))
        self.assertEqual(server.last_error, "no such file")

    def test_two_frames_of_one_server_have_mappings_of_their_own(self) -> None:
        orders: List[int] = []

        def execute(goal: FibonacciGoal) -> None:
            orders.append(goal.order)
            server.set_succeeded()

        server = RFNServer("gripper", FibonacciAction, execute_cb=execute, auto_start=False)
        self.assertTrue(server.register_with_frame("opening", goal_mapping={"order": {"value": 100}}))
        self.assertTrue(
            server.register_with_frame(
                "closing", goal_mapping={"order": {"element": "manner", "values": {"firmly": 0, "softly": 20}}}
            )
        )
        server.start()
        closing = FilledSemanticFrame(name="closing", frame_elements=[FilledFrameElement("manner", "softly")])
        for frame in (FilledSemanticFrame(name="opening"), closing):
            self.assertEqual(Goal("gripper/frame", frame).wait(), GoalStatus.SUCCEEDED)
        self.assertEqual([100, 20], orders)
        closing.frame_elements[0].argument = "gladly"
        refused = Goal("gripper/frame", closing)
        self.assertEqual(GoalStatus.ABORTED, refused.wait())
        self.assertIn('"gladly" is none of firmly, softly', refused.handle.get_goal_status_text())

    def test_mapping_needs_an_action_type(self) -> None:
        with self.assertRaises(TypeError):
            RFNServer("plain", lambda _frame: None).register_with_frame("opening", goal_mapping={})

    def test_shutdown_during_the_first_registration_ends_it(self) -> None:
        # Once it shuts down, rospy calls a hook as soon as it is added.
        with mock.patch.object(rospy, "on_shutdown", lambda hook: hook()):
            registration = Registration("shut_down", check=lambda _name: FrameFit(is_known=True, fault="not that one"))
            self.assertFalse(registration.request(RequestKind.REGISTRATION, "turning"))
        self.assertEqual(registration.last_error, "not that one")
        self.assertNotIn("registration of shut_down", [thread.name for thread in threading.enumerate()])


if __name__ == "__main__":
    import rostest

    rospy.init_node("rfnserver_test")
    rostest.rosrun("rfnserver", "rfnserver", RFNServerTest)
