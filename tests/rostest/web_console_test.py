#!/usr/bin/python3
"""A person uses the page in a real browser; the whole graph and a simulated robot are behind it."""

import contextlib
import math
import os
import shutil
import signal
import unittest
import urllib.request
from typing import Iterator, List, Optional, Set

import rosgraph
import rospy
from nav_msgs.msg import OccupancyGrid, Odometry
from sensor_msgs.msg import Image
from std_msgs.msg import Empty, String, UInt8MultiArray

from roboframenet_rostest import wait_for_pipeline
from roboframenet_testing import wait_until
from roboframenet_testing.ros_processes import process_of

try:
    from selenium.webdriver.common.keys import Keys

    from console_browser import (
        AXE,
        BROKEN,
        CHROMIUM,
        LINE,
        OVERLAPS,
        PROJECTOR,
        TELEPHONE,
        WIDE,
        WINDOW,
        ConsoleBrowser,
    )

    HAS_BROWSER = shutil.which(CHROMIUM) is not None
except ImportError:
    # Selenium comes with the browser.
    HAS_BROWSER = False

MARKUP = "<img src=x onerror=alert(1)> turn <b>left</b> 10 degrees"


#: What the tab key has to reach, by its id, and whether it is on the screen.
REACHED = "button[id], input[id]"
IS_SEEN = "(one) => one.checkVisibility() && !one.disabled && !one.closest('details:not([open])')"
#: What draws the first number over time; a line has an "L".
LINE = "document.querySelector('#plots .one path').getAttribute('d')"


def alive(node: str) -> Optional[int]:
    try:
        return process_of(node)
    except (OSError, rosgraph.MasterError):
        return None


def heard_by_page() -> Set[str]:
    """Return the topics that the node of the page hears."""
    _, subscribers, _ = rosgraph.Master("/web_console_test").getSystemState()
    return {topic for topic, nodes in subscribers if "/web_console" in nodes}


@contextlib.contextmanager
def suspended(processes: List[int]) -> Iterator[None]:
    """Suspend processes for the time of a block."""
    for process in processes:
        os.kill(process, signal.SIGSTOP)
    try:
        yield
    finally:
        for process in processes:
            os.kill(process, signal.SIGCONT)


@unittest.skipUnless(HAS_BROWSER, "no chromium: scripts/setup browser")
class WebConsoleTest(unittest.TestCase):
    """One page and one conversation; the methods run in the order of their names."""

    @classmethod
    def setUpClass(cls) -> None:
        cls.speed = 0.0
        cls.subscriber = rospy.Subscriber("odom", Odometry, cls.on_odometry, queue_size=1)
        wait_until(lambda: rospy.has_param("web_console/url"), message="the page is not there")
        cls.heard_before = heard_by_page()
        # The browser starts while the parser loads its models.
        cls.page = ConsoleBrowser(rospy.get_param("web_console/url"))
        wait_for_pipeline(("turning", "moving_forward"))
        wait_until(cls.page.is_connected)

    @classmethod
    def tearDownClass(cls) -> None:
        cls.page.close()

    @classmethod
    def on_odometry(cls, message: Odometry) -> None:
        cls.speed = max(abs(message.twist.twist.linear.x), abs(message.twist.twist.angular.z))

    def steps(self) -> List[str]:
        """Frame and state of each box of the plan."""
        boxes = "[...document.querySelectorAll('.box')]"
        return list(self.page.run(f"{boxes}.map((one) => one.dataset.frame + ' ' + one.dataset.state)"))

    def test_1_page_hears_where_the_robot_is_only_while_somebody_looks(self) -> None:
        self.assertIn("/reply", self.heard_before)
        self.assertNotIn("/odom", self.heard_before)
        # The brake does not wait for a page: a stop may be needed when there is no master any more.
        self.assertIn("/cmd_vel", self.heard_before)
        wait_until(lambda: {"/odom", "/cmd_vel", "/turning/status"} <= heard_by_page(), message=heard_by_page)

    def test_1_command_is_shown_from_its_parse_to_its_reply(self) -> None:
        # The page asks for the odometry when the first browser opens it.
        wait_until(lambda: "heading" in self.page.pose(), message="no robot is shown")
        heading = self.page.pose()["heading"]
        self.page.say("Turn left 120 degrees.")
        wait_until(lambda: self.steps() == ["turning active"], message=self.steps)
        self.assertIn("Turn", self.page.texts("svg .word"))
        self.assertIn("nummod", self.page.texts("svg .label"))
        self.assertEqual(self.page.texts(".clause .frame"), ["turning"])
        self.assertEqual(self.page.texts("dt"), ["direction", "angle", "angle_unit"])
        self.assertIn("measure 120 degrees = 2.094 rad", self.page.texts("dd .chip"))
        self.assertEqual(self.page.reply(), "DONE")
        wait_until(lambda: self.steps() == ["turning done"], message=self.steps)
        self.assertTrue(self.page.settles())
        self.assertAlmostEqual((self.page.pose()["heading"] - heading) % 360, 120, delta=3)
        self.assertIn("semantic_framer", " ".join(self.page.texts(".trace summary")))

    def test_2_question_is_answered_by_its_button(self) -> None:
        self.page.say("Turn left 30 degrees with a smile.")
        self.assertEqual(self.page.reply(), "NEEDS_INFORMATION")
        self.assertEqual(self.page.texts("#answers button"), ["Yes", "No"])
        self.page.click("#answers button", "Yes")
        wait_until(lambda: self.page.texts("#log li:last-child .person") == ["Yes"])
        self.assertEqual(self.page.reply(), "DONE")
        wait_until(lambda: not self.page.texts("#answers button"))

    def test_3_abilities_are_sentences_to_click(self) -> None:
        wait_until(lambda: "turning" in self.page.texts("#abilities .frame"))
        self.page.run("document.querySelector('#abilities details').setAttribute('open', '')")
        text = self.page.texts("#abilities .examples button")[0].strip()
        self.page.click("#abilities .examples button", text)
        self.assertEqual(self.page.run("document.getElementById('text').value"), text)
        self.page.find("#text")[0].clear()
        self.page.find("#text")[0].send_keys("Turn le")
        wait_until(
            lambda: "Turn left" in self.page.texts("#suggestions button"),
            message=lambda: self.page.texts("#suggestions"),
        )

    def test_3_what_it_waits_for_is_shown(self) -> None:
        self.page.say("Say hello in two hours.")
        self.assertEqual(self.page.reply(), "DONE")
        wait_until(lambda: self.page.texts("#orders b"), message="no order is shown")
        self.assertIn("hello", self.page.texts("#orders b")[0])
        self.assertTrue(self.page.find("#orders")[0].is_displayed())

    def test_3_voice_is_shown_and_listens(self) -> None:
        def is_offered() -> bool:
            return bool(self.page.run("document.getElementById('listen').offsetParent"))

        self.assertFalse(is_offered())
        pushed: List[Empty] = []
        push = rospy.Subscriber("push_to_talk", Empty, pushed.append)
        voice = {
            topic: rospy.Publisher(f"voice_{topic}", String, queue_size=1, latch=True)
            for topic in ("state", "heard", "question")
        }
        voice["state"].publish("waiting")
        wait_until(is_offered)
        self.page.click("#listen", "Speak")
        wait_until(lambda: pushed)
        voice["state"].publish("listening")
        wait_until(lambda: self.page.texts("#heard") == ["Listening ..."])
        voice["heard"].publish("sure: turn left | turn left please")
        voice["question"].publish("Shall I turn left?")
        voice["state"].publish("confirming")
        wait_until(lambda: self.page.texts("#heard") == ['Heard: "turn left please". Shall I turn left?'])
        push.unregister()
        heard: List[UInt8MultiArray] = []
        sound = rospy.Subscriber("page_sound", UInt8MultiArray, heard.append)
        wait_until(lambda: sound.get_num_connections() > 0)
        voice["state"].publish("listening")
        wait_until(lambda: bool(self.page.run("document.getElementById('microphone').offsetParent")))
        self.page.click("#microphone", "Microphone")
        # The browser's own microphone beeps once a second: not all of it is silence.
        wait_until(lambda: any(any(one.data) for one in heard), message=self.page.complaints)
        self.assertEqual({len(one.data) for one in heard}, {3200})
        self.page.click("#microphone", "Microphone")
        wait_until(
            lambda: self.page.run("document.getElementById('microphone').getAttribute('aria-pressed')") == "false"
        )
        sound.unregister()
        voice["state"].publish("")
        wait_until(lambda: not is_offered() and self.page.texts("#heard") == [""])

    def test_3_what_was_taught_is_listed_and_forgotten(self) -> None:
        self.page.say("When I say dismissed, turn left 10 degrees.")
        self.assertEqual(self.page.reply(), "NEEDS_INFORMATION")
        self.assertEqual(self.page.texts("#answers button"), ["Yes", "No"])
        self.page.click("#answers button", "Yes")
        wait_until(lambda: self.page.texts("#learned b") == ['"dismissed" means "turn left 10 degrees"'])
        self.page.say("Gyrate left 20 degrees.")
        self.assertEqual(self.page.reply(), "NEEDS_INFORMATION")
        self.page.click("#answers button", "Yes")
        wait_until(lambda: self.page.texts("#learned b")[:1] == ['"gyrate" means "turn"'], message=self.learned)
        self.page.say("Dismissed!")
        self.assertEqual(self.page.reply(), "DONE")
        while self.page.texts("#learned button"):
            count = len(self.learned())
            self.page.click("#learned button", "Forget")
            wait_until(lambda before=count: len(self.learned()) < before, message=self.learned)
        self.assertFalse(self.page.find("#learned-card")[0].is_displayed())
        self.page.say("Dismissed!")
        self.assertEqual(self.page.reply(), "REFUSED")

    def learned(self) -> List[str]:
        return self.page.texts("#learned b")

    def test_4_stop_button_stops(self) -> None:
        self.page.say("Move forward 10 metres.")
        wait_until(lambda: self.speed > 0.1, message="the robot does not move")
        self.page.find("#stop")[0].click()
        wait_until(lambda: self.speed < 0.01, message="the robot does not stop")
        wait_until(lambda: "Stopped" in " ".join(self.page.texts("#banner")))
        wait_until(lambda: "SUPERSEDED" in self.page.run("document.getElementById('log').innerHTML"))

    def test_5_stop_button_stops_when_the_pipeline_hangs(self) -> None:
        self.page.say("Move forward 10 metres.")
        wait_until(lambda: self.speed > 0.1, message="the robot does not move")
        hanging = [process_of(node) for node in ("/stop_server", "/command_server", "/executor", "/semantic_framer")]
        with suspended(hanging):
            self.page.find("#stop")[0].click()
            wait_until(lambda: self.speed < 0.01, message="the robot does not stop")
            wait_until(
                lambda: "this page did it itself" in " ".join(self.page.texts("#banner")),
                message=lambda: self.page.texts("#banner"),
            )
        wait_until(lambda: not self.page.find("#log .waiting"), message=lambda: self.page.texts("#log li"))
        self.assertTrue(self.page.settles())

    def test_6_markup_stays_text(self) -> None:
        self.page.say(MARKUP)
        self.page.reply()
        self.assertEqual(self.page.texts("#log li:last-child .person"), [MARKUP])
        self.assertEqual(
            self.page.find("#log img, #mind img, #mind b b, .wide svg *:not(path):not(text):not(rect)"), []
        )

    def test_7_past_conversations_are_found_judged_and_written_down(self) -> None:
        page = self.page
        page.find("#past-details summary")[0].click()
        wait_until(lambda: MARKUP in page.texts("#past .first"), message=lambda: page.texts("#past"))
        page.find("#past-words")[0].send_keys("smile")
        wait_until(lambda: page.texts("#past .first") == ["Turn left 30 degrees with a smile."])
        page.find("#past .past summary")[0].click()
        page.click("#past .verdicts button", "Wrong")
        wait_until(lambda: page.find("#past form input"), message=lambda: page.texts("#past"))
        page.find("#past form input")[0].send_keys("Turn left 30 degrees.\n")
        wait_until(lambda: page.texts("#past .teach"), message=lambda: page.texts("#past"))
        page.find("#past-words")[0].send_keys(" :wrong")
        wait_until(lambda: "%3Awrong" in str(page.run("document.querySelector('#past-files a').href")))
        page.click("#past .teach", "Teach it")
        taught = "When I say turn left 30 degrees with a smile, turn left 30 degrees."
        self.assertEqual(page.run("document.getElementById('text').value"), taught)
        page.find("#text")[0].clear()
        address = page.run("document.querySelector('#past-files a').href")
        with urllib.request.urlopen(address, timeout=10.0) as answer:
            self.assertIn("means: Turn left 30 degrees.", answer.read().decode("utf-8"))
        # A link to a moment, opened in a page that has just come.
        link = str(page.run("document.querySelector('#past .verdicts a').href"))
        page.driver.get("about:blank")
        page.driver.get(link)
        wait_until(page.is_connected)
        smile = "“Turn left 30 degrees with a smile.”"
        wait_until(lambda: page.texts("#mind .sentence span") == [smile], message=lambda: page.texts("#mind .sentence"))

    def test_6_cameras_and_numbers_are_shown_while_somebody_looks(self) -> None:
        page = self.page
        publisher = rospy.Publisher("front_camera/image_raw", Image, queue_size=1)
        image = Image(width=64, height=48, step=192, encoding="rgb8", data=bytes(range(192)) * 48)
        timer = rospy.Timer(rospy.Duration.from_sec(0.2), lambda _event: publisher.publish(image))
        try:
            page.find("#senses summary")[0].click()
            wait_until(lambda: "front camera" in page.texts("#cameras option"), message=lambda: page.texts("#senses"))
            wait_until(lambda: page.run("document.querySelector('img.camera').naturalWidth") == 64)
            page.click("#engineer", "Engineer's view")
            page.choose_number("one", "odom: heading (degrees)")
            wait_until(lambda: "L" in str(page.run(LINE)))
            page.click("#engineer", "Engineer's view")
            page.find("#senses summary")[0].click()
            wait_until(lambda: publisher.get_num_connections() == 0, message="the camera is heard, and nobody looks")
        finally:
            timer.shutdown()
            publisher.unregister()

    def test_7_page_fits_on_a_telephone(self) -> None:
        self.page.resize(*TELEPHONE)
        width = TELEPHONE[0]
        self.assertLessEqual(self.page.run("document.documentElement.scrollWidth"), width)
        self.page.run("window.scrollTo(0, 2000)")
        button = self.page.find("#stop")[0].rect
        self.assertLessEqual(button["x"] + button["width"], width)
        self.assertTrue(self.page.run("document.elementFromPoint(innerWidth - 40, 30).closest('#stop') !== null"))
        self.page.resize(*WINDOW)

    def test_7_line_stays_and_nothing_breaks_or_overlaps(self) -> None:
        page = self.page
        page.run("document.getElementById('state-text').textContent = 'Going to the newspaper in the living room'")
        for size in (WINDOW, PROJECTOR, TELEPHONE):
            page.resize(*size)
            for part in ("talk", "map", "plan", "more") if size == TELEPHONE else ("talk",):
                page.run(f"document.querySelector('.tabs [data-part={part}]').click()")
                wait_until(lambda: page.run(LINE), message=f"the line is not on the screen: {size} {part}")
                self.assertEqual(page.run(WIDE), [], size)
                self.assertLessEqual(page.run("document.documentElement.scrollWidth"), size[0], part)
                self.assertEqual(page.run(BROKEN), [], size)
                self.assertEqual(page.run(OVERLAPS), [], size)
            page.run("document.querySelector('.tabs [data-part=talk]').click()")
            places = "JSON.stringify([...document.querySelectorAll('.card')].map((one) => one.getBoundingClientRect()))"
            page.run("document.getElementById('note').hidden = true")
            before = page.run(places)
            page.run("document.getElementById('note').hidden = false")
            self.assertEqual(page.run(places), before, "a banner moves nothing")
            page.run("document.getElementById('note').hidden = true")
        page.run("document.getElementById('state-text').textContent = 'Ready'")
        page.run("document.querySelector('.person').style.width = '2.2rem'")
        page.run("document.querySelector('.person').style.wordBreak = 'break-all'")
        self.assertNotEqual(page.run(BROKEN), [], "a broken word is found")
        page.run("document.querySelector('.person').removeAttribute('style')")
        page.resize(*WINDOW)

    def test_7_axe_finds_nothing(self) -> None:
        if not AXE.is_file():
            self.skipTest("no axe-core: scripts/setup browser")
        page = self.page
        publisher = rospy.Publisher("front_camera/image_raw", Image, queue_size=1)
        image = Image(width=64, height=48, step=192, encoding="rgb8", data=bytes(range(192)) * 48)
        timer = rospy.Timer(rospy.Duration.from_sec(0.2), lambda _event: publisher.publish(image))
        try:
            # Every part is open, and every card shows something.
            page.click("#engineer", "Engineer's view")
            page.run("document.querySelectorAll('details').forEach((one) => { one.open = true; })")
            wait_until(lambda: page.run("document.querySelector('img.camera')?.naturalWidth ?? 0") == 64)
            page.choose_number("one", "odom: heading (degrees)")
            wait_until(lambda: "L" in str(page.run(LINE)))
            wait_until(lambda: page.find("#past .first"), message=lambda: page.texts("#past"))
            page.run("document.querySelectorAll('#past details').forEach((one) => { one.open = true; })")
            page.click("#past .verdicts button", "Wrong")
            wait_until(lambda: page.find("#past form input"), message=lambda: page.texts("#past"))
            for size in (WINDOW, PROJECTOR, TELEPHONE):
                for part in ("talk", "map", "plan", "more") if size == TELEPHONE else ("talk",):
                    page.run(f"document.querySelector('.tabs [data-part={part}]').click()")
                    if size != TELEPHONE or part == "more":
                        for card in ("img.camera", "#plots .one path", "#past form input"):
                            wait_until(lambda card=card: page.find(card)[0].is_displayed(), message=f"{size} {card}")
                    for is_dark in (False, True):
                        page.resize(*size, is_dark=is_dark)
                        self.assertEqual(page.findings(), [], (size, part, is_dark))
                        self.assertEqual(page.run(BROKEN), [], (size, part, is_dark))
                        self.assertEqual(page.run(WIDE), [], (size, part, is_dark))
                page.run("document.querySelector('.tabs [data-part=talk]').click()")
            page.resize(*WINDOW)
            page.run("document.querySelector('#plots .one select').removeAttribute('aria-label')")
            self.assertTrue(page.findings(), "a choice without a name is found")
            page.run("document.querySelector('#plots .one select').setAttribute('aria-label', 'First number')")
        finally:
            timer.shutdown()
            publisher.unregister()
            page.resize(*WINDOW)
            page.click("#past .verdicts [aria-pressed=true]", "Wrong")
            wait_until(lambda: not page.find("#past form input"), message=lambda: page.texts("#past"))
            page.run("document.querySelectorAll('details').forEach((one) => { one.open = false; })")
            page.click("#engineer", "Engineer's view")

    def test_7_servers_and_frames_are_behind_one_switch(self) -> None:
        page = self.page
        names = {name for name in page.texts("#abilities .frame, .box b, .trace summary") if "_" in name}
        names |= {name.strip("/") for name in page.texts("#health li b") if "_" in name}
        self.assertIn("semantic_framer", names)

        def seen() -> List[str]:
            text = page.seen_text()
            return sorted(name for name in names if name in text)

        self.assertEqual(seen(), [])
        page.click("#engineer", "Engineer's view")
        self.assertTrue(seen(), "the engineer sees them")
        page.driver.refresh()
        wait_until(page.is_connected)
        wait_until(seen, message="the switch is kept")
        page.click("#engineer", "Engineer's view")
        wait_until(lambda: not seen(), message=seen)

    def test_7_page_can_be_read_and_used_by_all(self) -> None:
        for is_dark in (False, True):
            self.page.resize(*WINDOW, is_dark=is_dark)
            self.assertEqual(self.page.faint_texts(), [])
        self.page.run("document.getElementById('ground-text').style.color = '#d0d0d0'")
        self.page.resize(*WINDOW)
        self.assertEqual(len(self.page.faint_texts()), 1, "a grey text on white is found")
        self.page.run("document.getElementById('ground-text').style.color = ''")
        self.assertEqual(self.page.nameless(), [])
        self.page.run("document.activeElement.blur()")
        self.page.press("/", Keys.ARROW_UP)
        self.assertEqual(self.page.run("document.activeElement.value"), MARKUP)
        self.page.press(Keys.ARROW_DOWN)
        self.assertEqual(self.page.run("document.activeElement.value"), "")
        reached = set()
        for _ in range(12):
            self.page.press(Keys.TAB)
            reached.add(self.page.run("document.activeElement.tagName + ' ' + document.activeElement.id"))
        self.assertIn("BUTTON send", reached)
        self.assertIn("INPUT filter", reached)

    def test_7_touch_zooms_the_map_and_taps_buttons(self) -> None:
        page = self.page
        page.resize(*TELEPHONE)
        page.tap(".tabs [data-part=map]")
        size = "document.querySelector('path.robot-body')?.getBoundingClientRect().width ?? 0"
        wait_until(lambda: page.run(size) > 0 and page.find("#ground")[0].is_displayed())
        before = page.run(size)
        page.pinch("#ground", 40, 120)
        wait_until(lambda: page.run(size) > 1.5 * before, message=lambda: f"{before} {page.run(size)}")
        page.tap(".tabs [data-part=more]")
        wait_until(page.find("#filter")[0].is_displayed)
        page.tap(".tabs [data-part=talk]")
        page.resize(*WINDOW)

    def test_7_with_keys_alone(self) -> None:
        page = self.page
        page.run("document.activeElement.blur()")
        page.press("/")
        page.press("Ping.", Keys.ENTER)
        wait_until(lambda: page.texts("#log li:last-child .person") == ["Ping."])
        self.assertEqual(page.reply(), "DONE")
        # The map of the test before.
        size = "parseFloat(document.querySelector('img.grid-picture').style.width)"
        page.run("document.getElementById('ground').focus()")
        before = page.run(size)
        page.press("=")
        wait_until(lambda: page.run(size) > 1.2 * before)
        page.press("-")
        wait_until(lambda: page.run(size) < 1.2 * before)
        # Every button that is to be seen is reached by the tab key.
        wanted = set(page.run(f"[...document.querySelectorAll('{REACHED}')].filter({IS_SEEN}).map((one) => one.id)"))
        self.assertIn("stop", wanted)
        reached = set()
        page.run("document.activeElement.blur()")
        for _ in range(120):
            page.press(Keys.TAB)
            reached.add(page.run("document.activeElement.id"))
        self.assertEqual(wanted - reached, set())

    def test_7_turned_map_is_drawn_turned(self) -> None:
        grid = OccupancyGrid()
        grid.header.frame_id = "map"
        grid.info.width, grid.info.height, grid.info.resolution = 40, 20, 0.1
        grid.info.origin.position.x, grid.info.origin.position.y = -1.0, -1.0
        grid.info.origin.orientation.z, grid.info.origin.orientation.w = math.sin(0.25), math.cos(0.25)
        grid.data = [100 if index < 40 else 0 for index in range(800)]
        publisher = rospy.Publisher("map", OccupancyGrid, queue_size=1, latch=True)
        publisher.publish(grid)
        wait_until(lambda: self.page.run("document.querySelector('img.grid-picture')?.naturalWidth ?? 0") == 40)
        style = "document.querySelector('img.grid-picture').style"
        self.assertIn("rotate(-0.5", self.page.run(f"{style}.transform"))
        # The lower left corner, about which it is turned, stays: so the box is wider by the height's share.
        box = "document.querySelector('img.grid-picture').getBoundingClientRect()"
        width, long, high = (self.page.run(one) for one in (f"{box}.width", f"{style}.width", f"{style}.height"))
        long_px, high_px = float(long[:-2]), float(high[:-2])
        self.assertAlmostEqual(width, long_px * math.cos(0.5) + high_px * math.sin(0.5), delta=2.0)

    def test_8_page_finds_a_console_that_was_killed(self) -> None:
        before = process_of("/web_console")
        os.kill(before, signal.SIGKILL)
        wait_until(lambda: not self.page.is_connected(), message="the page does not tell that the console is gone")
        self.assertIn("cannot stop it", " ".join(self.page.texts("#banner")))
        wait_until(lambda: alive("/web_console") not in (None, before), message="the node was not started again")
        wait_until(self.page.is_connected, message="the page does not come back")
        # The complaints about the lost connection are right; others are not.
        self.assertEqual([text for text in self.page.complaints() if "WebSocket connection" not in text], [])
        # The new console has to find the others first.
        wait_until(lambda: "All" in " ".join(self.page.texts("#health")), message=lambda: self.page.texts("#health"))
        self.page.say("Ping.")
        self.assertEqual(self.page.reply(), "DONE")


if __name__ == "__main__":
    import rostest

    rospy.init_node("web_console_test", disable_signals=True)
    rostest.rosrun("roboframenet_tests", "web_console_page", WebConsoleTest)
