#!/usr/bin/python3
"""Uses the page as its test does, and writes the pictures of the documentation.

console_screenshots.py FOLDER ROBOT     a master and the robot with its page have to be there
"""

import base64
import struct
import sys
import time
from pathlib import Path
from typing import Callable, Dict, List, Tuple

import rospy

from console_browser import PROJECTOR, TELEPHONE, ConsoleBrowser
from roboframenet_rostest import wait_for_pipeline
from roboframenet_testing import wait_until

SIZE = (1360, 900)
#: What engineers see is longer than a screen.
LONG = (1360, 1580)
#: Of the animated picture.
FRAME_S, FRAMES, SMALL, SCALE = 0.3, 18, (1240, 840), 0.75


def animated(frames: List[bytes], *, size: Tuple[int, int], frame_s: float) -> bytes:
    """Join pictures in WebP to an animated one that repeats for ever: the container is a list of chunks."""

    def chunk(name: bytes, data: bytes) -> bytes:
        return name + struct.pack("<I", len(data)) + data + b"\x00" * (len(data) % 2)

    def in_24_bits(value: int) -> bytes:
        return struct.pack("<I", value)[:3]

    def picture(frame: bytes) -> bytes:
        at = 12
        while frame[at : at + 4] not in (b"VP8 ", b"VP8L"):
            at += 8 + struct.unpack("<I", frame[at + 4 : at + 8])[0]
            at += at % 2
        return chunk(frame[at : at + 4], frame[at + 8 : at + 8 + struct.unpack("<I", frame[at + 4 : at + 8])[0]])

    extent = in_24_bits(size[0] - 1) + in_24_bits(size[1] - 1)
    # The last frame stays for a while.
    durations = [frame_s] * (len(frames) - 1) + [2.5]
    body = chunk(b"VP8X", b"\x02\x00\x00\x00" + extent) + chunk(b"ANIM", b"\xff\xff\xff\xff\x00\x00")
    for frame, lasting_s in zip(frames, durations):
        place = in_24_bits(0) * 2 + extent + in_24_bits(int(1000 * lasting_s)) + b"\x02"
        body += chunk(b"ANMF", place + picture(frame))
    return b"RIFF" + struct.pack("<I", len(body) + 4) + b"WEBP" + body


def webp(browser: ConsoleBrowser) -> bytes:
    """Return what the page shows."""
    shown = browser.driver.execute_cdp_cmd("Page.captureScreenshot", {"format": "webp", "quality": 55})
    return base64.b64decode(shown["data"])


def turtlebot(browser: ConsoleBrowser, folder: Path) -> None:
    """What engineers see while a command runs, a question on a telephone, and a command as an animated picture."""
    wait_for_pipeline(("turning", "saying"))
    wait_until(lambda: browser.texts("#abilities .frame"))
    browser.click("#engineer", "Engineer's view")
    browser.say("Say hello to Alice in two hours.")
    browser.reply()
    wait_until(lambda: browser.texts("#orders b"))
    browser.say("Where are you?")
    browser.reply()
    browser.resize(*LONG)
    browser.find("#filter")[0].send_keys("turn")
    browser.run("document.querySelectorAll('#senses, #past-details').forEach((one) => { one.open = true; })")
    browser.choose_number("one", "odom: heading (degrees)")
    browser.choose_number("other", "odom: turning speed (rad/s)")
    wait_until(lambda: browser.find("#past summary"))
    browser.find("#past summary")[0].click()
    browser.click("#past .verdicts button", "Right")
    browser.say("Turn right 100 degrees.")
    browser.reply()
    browser.say("Turn left 240 degrees.")
    wait_until(lambda: browser.find(".box.active") and browser.pose()["heading"] > 50)
    browser.screenshot(str(folder / "console.png"))
    browser.reply()
    browser.run("document.querySelectorAll('#senses, #past-details').forEach((one) => { one.open = false; })")
    browser.find("#filter")[0].clear()
    browser.say("Turn right 45 degrees with a smile.")
    browser.reply()
    browser.resize(*TELEPHONE)
    browser.screenshot(str(folder / "console_telephone.png"))
    browser.click("#answers button", "No")
    wait_until(lambda: browser.texts("#log li:last-child .person") == ["No"])
    browser.reply()
    browser.resize(*SMALL, scale=SCALE)
    browser.find("#text")[0].send_keys("Turn right 160 degrees.")
    frames = [webp(browser)]
    browser.find("#text")[0].send_keys("\n")
    next_s = time.monotonic()
    while len(frames) < FRAMES:
        next_s += FRAME_S
        time.sleep(max(0.0, next_s - time.monotonic()))
        frames.append(webp(browser))
    browser.reply()
    frames.append(webp(browser))
    size = (int(SMALL[0] * SCALE), int(SMALL[1] * SCALE))
    (folder / "console.webp").write_bytes(animated(frames, size=size, frame_s=FRAME_S))


def home(browser: ConsoleBrowser, folder: Path) -> None:
    """A home in which the robot fetches something, on three screens."""
    wait_for_pipeline(("bringing", "navigating_to_location"))
    wait_until(lambda: browser.texts("#suggestions button"))
    browser.say("Bring me the newspaper, please.")
    wait_until(lambda: "Going to" in browser.texts("#mind .reply")[0])
    wait_until(lambda: browser.find("path.way, path.trail"))
    browser.screenshot(str(folder / "home.png"))
    browser.resize(*PROJECTOR, is_dark=True)
    browser.screenshot(str(folder / "home_dark.png"))
    browser.resize(*TELEPHONE)
    browser.run("document.querySelector('.tabs [data-part=map]').click()")
    time.sleep(FRAME_S)  # the map fits itself into its new place
    browser.screenshot(str(folder / "home_telephone.png"))
    browser.run("document.querySelector('.tabs [data-part=talk]').click()")
    browser.reply()


def pr2(browser: ConsoleBrowser, folder: Path) -> None:
    """The page in the dark, with a map."""
    wait_for_pipeline(("navigating_to_location",))
    wait_until(lambda: browser.texts("#abilities .frame"))
    browser.resize(*SIZE, is_dark=True)
    browser.say("Go to the kitchen and say hello.")
    wait_until(lambda: browser.find(".box.active") and browser.pose()["x"] < -1.0)
    browser.screenshot(str(folder / "console_dark.png"))


SCENES: Dict[str, Callable[[ConsoleBrowser, Path], None]] = {"turtlebot": turtlebot, "pr2": pr2, "home": home}


def main(folder: Path, robot: str) -> None:
    """Write the pictures of a robot."""
    rospy.init_node("console_screenshots", disable_signals=True)
    wait_until(lambda: rospy.has_param("web_console/url"), message="the page is not there")
    browser = ConsoleBrowser(rospy.get_param("web_console/url"))
    try:
        browser.resize(*SIZE)
        SCENES[robot](browser, folder)
    finally:
        browser.close()
        rospy.signal_shutdown("done")


if __name__ == "__main__":
    main(Path(sys.argv[1]), sys.argv[2])
