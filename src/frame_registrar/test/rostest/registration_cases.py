"""Which servers are offered: what they register, and whether they live."""

from typing import List

import actionlib
import rospy
from actionlib.msg import TestAction
from frame_registrar_case import FrameRegistrarCase
from roboframenet_msgs.msg import FrameServers, Reply
from roboframenet_msgs.msg import ServerProfile as ServerProfileMessage
from roboframenet_msgs.srv import RegisterServer, RegisterWithFrame

from roboframenet_testing import wait_until
from semantic_frames.ros_server_profile import profile_from_message, profile_to_message
from semantic_frames.server_profile import AS_IN_2012, ServerProfile
from semantic_frames.server_statement import stated_profile


class RegistrationCases(FrameRegistrarCase):
    """Servers that register, are wrong, or die."""

    def test_registration_that_makes_no_sense_is_refused_with_a_reason(self) -> None:
        for frame, server in (
            ("", "steady"),
            ("moving", ""),
            ("moving", "two words"),
            ("moving", "~private"),
            ("moving", "/"),
            ("moving", "two\nlines"),
            ("moving", "s" * 100_000),
            ("m" * 1_000_000, "steady"),
            ("two\nlines", "steady"),
        ):
            answer = self.call("register_with_frame", RegisterWithFrame, frame, server)
            self.assertFalse(answer.success)
            self.assertTrue(answer.error and answer.error[0])
            self.assertLess(len(answer.error[0]), 300)

    def test_profile_is_told_and_a_wrong_one_is_refused(self) -> None:
        self.assertTrue(
            self.add_frame("putting.yaml", "name: putting\nframe_elements: [{name: goal, is_core: true}]\n")
        )
        wait_until(lambda: any(file.path.endswith("putting.yaml") for file in self.catalogues[-1].files))
        stated = stated_profile({"heeds": {"Manner": ["slow"], "goal": {"relations": ["on"]}}, "occupies": ["arms"]})
        catalogue_count = len(self.catalogues)
        answer = self.call("register_server", RegisterServer, "putting", "steady", profile_to_message(stated))
        self.assertEqual((answer.success, list(answer.error)), (True, []))

        def profiles() -> List[ServerProfile]:
            callbacks = [each for each in self.known.callbacks if each.frame_name == "putting"]
            return [profile_from_message(callback.profile) for callback in callbacks]

        wait_until(lambda: profiles() == [stated], message=profiles)
        # The texts of the files have not changed, and are not sent again.
        self.assertEqual(len(self.catalogues), catalogue_count)
        wrong = [stated_profile({"heeds": ["Maner"]}), stated_profile({"heeds": {"goal": {"relations": ["nextto"]}}})]
        for profile, hint in zip(wrong, ("did you mean 'Manner'?", "did you mean 'next_to'?")):
            answer = self.call("register_server", RegisterServer, "putting", "steady", profile_to_message(profile))
            self.assertFalse(answer.success)
            self.assertIn(hint, answer.error[0])
        answer = self.call("register_server", RegisterServer, "putting", "steady", ServerProfileMessage(purpose=7))
        self.assertIn("purpose", answer.error[0])
        self.assertEqual(profiles(), [stated])
        self.register("putting", "steady")
        wait_until(lambda: profiles() == [AS_IN_2012], message=profiles)

    def test_registration_for_a_frame_that_no_file_describes_is_remarked(self) -> None:
        answer = self.call("register_with_frame", RegisterWithFrame, "movign", "steady")
        self.assertTrue(answer.success)
        self.assertEqual(list(answer.error), ["no file describes the frame 'movign' yet; did you mean 'moving'?"])

    def test_registration_that_repeats_itself_is_published_to_nobody(self) -> None:
        self.register("repeating", "steady")
        heard: List[FrameServers] = []
        subscriber = rospy.Subscriber("frame_servers", FrameServers, heard.append)
        wait_until(lambda: heard, message="nothing is latched")
        for _ in range(5):
            self.register("repeating", "steady")
        self.register("repeating", "other")
        wait_until(lambda: any(each.callback_topic == "other" for each in heard[-1].callbacks), message="no change")
        subscriber.unregister()
        self.assertFalse(any(before == after for before, after in zip(heard, heard[1:])))

    def test_server_may_register_before_the_file_comes(self) -> None:
        self.register("waving", "steady")
        self.assertEqual(self.command("waving").reply.code, "UNKNOWN_FRAME")
        self.assertTrue(self.add_frame("waving.yaml", "name: waving\n"))
        self.assertEqual(self.servers("waving"), [["steady"]])

    def test_server_of_another_type_is_not_offered(self) -> None:
        self.assertTrue(self.add_frame("counting.yaml", "name: counting\n"))
        other = actionlib.SimpleActionServer("counter", TestAction, execute_cb=lambda goal: None, auto_start=False)
        other.start()
        self.register("counting", "counter")
        wait_until(lambda: self.is_alive("counter") is False, message="a server of another type is offered")

    def test_killed_server_is_not_offered_until_it_is_back(self) -> None:
        self.assertTrue(self.add_frame("dying.yaml", "name: dying\n"))
        self.register("dying", "mortal")
        wait_until(lambda: self.servers("dying") == [["mortal"]])
        self.kill("mortal_servers")
        wait_until(lambda: self.is_alive("mortal") is False, message="a dead server is offered")
        event = self.command("dying")
        self.assertEqual((event.reply.outcome, event.reply.code), (Reply.REFUSED, "NO_SERVER"))
        self.assertIn('"dying"', event.reply.sentence)
        wait_until(lambda: self.is_alive("mortal") is True, message="a server that is back is not offered")
        self.assertEqual(self.servers("dying"), [["mortal"]])
