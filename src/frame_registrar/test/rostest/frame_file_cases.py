"""Files of frames that are wrong, change or vanish."""

import os
import threading
from typing import List

import rospy
from frame_registrar_case import FrameRegistrarCase
from roboframenet_msgs.msg import FileProblems
from roboframenet_msgs.srv import GetEmptyFrame

from roboframenet_testing import wait_until


class FrameFileCases(FrameRegistrarCase):
    """Files at start, and those that are added."""

    def test_wrong_file_at_start_is_told_by_line_and_key_to_who_comes_late(self) -> None:
        late = rospy.wait_for_message("file_problems", FileProblems, timeout=60.0)
        problem = next(problem for problem in late.problems if problem.path.endswith("mistyped.yaml"))
        self.assertEqual((problem.code, problem.line, problem.key), ("UNKNOWN_KEY", 2, "descripton"))
        self.assertIn("did you mean 'description'", problem.hint)
        self.assertEqual(self.call("get_empty_frame", GetEmptyFrame, "moving").frame.name, "moving")

    def test_cycle_is_refused_by_its_names_and_nothing_changes(self) -> None:
        self.assertTrue(self.add_frame("circle_a.yaml", "name: circle_a\nchildren:\n  - name: circle_b\n"))
        self.assertFalse(self.add_frame("circle_b.yaml", "name: circle_b\nchildren:\n  - name: circle_a\n"))

        def cycles() -> List[str]:
            return [problem.found for problem in self.problems.problems if problem.code == "CYCLE"]

        wait_until(lambda: cycles() == ["circle_b -> circle_a -> circle_b"], message=cycles)
        self.assertEqual(self.call("get_empty_frame", GetEmptyFrame, "circle_b").frame.name, "")
        self.assertTrue(self.add_frame("circle_b.yaml", "name: circle_b\n"))
        wait_until(lambda: not cycles(), message="the problem of a file that was mended stays")

    def test_changed_file_takes_the_place_of_the_old_one_even_under_another_name(self) -> None:
        self.register("bowing", "steady")
        self.register("nodding", "steady")
        for _ in range(2):
            self.assertTrue(self.add_frame("gesture.yaml", "name: bowing\n"))
        self.assertEqual(self.servers("bowing"), [["steady"]])
        self.assertTrue(self.add_frame("gesture.yaml", "name: nodding\n"))
        self.assertEqual(self.servers("nodding"), [["steady"]])
        self.assertEqual(self.command("bowing").reply.code, "UNKNOWN_FRAME")

    def test_killed_registrar_knows_what_was_added_to_it(self) -> None:
        names = [f"added_{index}" for index in range(6)]
        threads = [threading.Thread(target=self.add_frame, args=(f"{name}.yaml", f"name: {name}\n")) for name in names]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertTrue(self.add_frame("vanishing.yaml", "name: vanishing\n"))
        os.remove(os.path.join(self.folder, "vanishing.yaml"))
        old = self.known.registrar_id
        self.kill("frame_registrar")
        wait_until(lambda: self.known.registrar_id != old, message="no new registrar")
        wait_until(self.is_connected)
        for name in names:
            self.assertEqual(self.call("get_empty_frame", GetEmptyFrame, name).frame.name, name)
        wait_until(
            lambda: (
                [problem.code for problem in self.problems.problems if "vanishing" in problem.path] == ["UNREADABLE"]
            )
        )
        self.register(names[0], "steady")
        wait_until(lambda: self.servers(names[0]) == [["steady"]])
