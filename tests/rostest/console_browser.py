"""A browser without a window that shows the page. Debian's chromium, its driver, and Selenium."""

import json
import time
from pathlib import Path
from typing import Any, Dict, List, Tuple

from selenium import webdriver
from selenium.common.exceptions import StaleElementReferenceException
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.remote.webelement import WebElement

from roboframenet_testing import comes_true, wait_until

CHROMIUM = "/usr/bin/chromium"
DRIVER = "/usr/bin/chromedriver"
#: Sizes of a window and of a telephone, pixels.
WINDOW = (1440, 900)
TELEPHONE = (390, 844)
#: A window of an old projector.
PROJECTOR = (1024, 768)
#: Put there by `scripts/setup browser`.
AXE = Path(__file__).resolve().parents[2] / ".venv/share/roboframenet/axe/axe_core_python/axe.min.js"
#: Labels of the map that overlap.
OVERLAPS = """(() => {
  const labels = [...document.querySelectorAll(".labels .name")];
  const boxes = labels.map((one) => [one.textContent, one.getBoundingClientRect()]);
  const found = [];
  boxes.forEach(([name, box], place) => boxes.slice(place + 1).forEach(([other, its]) => {
    const isBeside = box.left >= its.right || its.left >= box.right || box.top >= its.bottom || its.top >= box.bottom;
    if (!isBeside) found.push(`${name} ${other}`);
  }));
  return found;
})()"""
#: Words that are broken over two lines.
BROKEN = """(() => {
  const found = [], range = document.createRange();
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const node = walker.currentNode;
    if (!node.parentElement.checkVisibility() || node.parentElement.closest("svg, .hidden, script, style")) continue;
    for (const match of node.textContent.matchAll(/[\\p{L}\\p{N}]+/gu)) {
      range.setStart(node, match.index);
      range.setEnd(node, match.index + match[0].length);
      if (new Set([...range.getClientRects()].map((box) => Math.round(box.top))).size > 1) found.push(match[0]);
    }
  }
  return found;
})()"""
#: What is wider than the screen, and does not scroll in its place.
WIDE = """(() => {
  const isScrolled = (one) => getComputedStyle(one).overflowX === "auto";
  const scrolls = (one) => one && one !== document.body && (isScrolled(one) || scrolls(one.parentElement));
  return [...document.querySelectorAll("body *")].filter((one) => one.checkVisibility() && !one.closest("#ground")
    && one.getBoundingClientRect().right > innerWidth + 1 && !scrolls(one.parentElement))
    .map((one) => `${one.tagName} ${one.id} ${one.className} ${one.textContent.slice(0, 40)}`);
})()"""
#: Whether the line to type in lies on the screen, and on top.
LINE = """(() => {
  const box = document.getElementById("text").getBoundingClientRect();
  const top = document.elementFromPoint((box.left + box.right) / 2, (box.top + box.bottom) / 2);
  return box.top >= 0 && box.bottom <= innerHeight && box.left >= 0 && box.right <= innerWidth && top?.id === "text";
})()"""
#: What a screen reader has to name.
NAMED_ROLES = frozenset(("button", "textbox", "searchbox", "image", "img", "log"))
#: Texts whose contrast with their ground is below 4.5, as WCAG 2 (AA) counts it.
FAINT = """(() => {
  const parts = (text) => (text.match(/[\\d.]+/g) || []).map(Number);
  const part = (value) => (value /= 255) <= 0.03928 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4;
  const light = ([red, green, blue]) => 0.2126 * part(red) + 0.7152 * part(green) + 0.0722 * part(blue);
  const ground = (one) => {
    for (; one; one = one.parentElement) {
      const found = parts(getComputedStyle(one).backgroundColor);
      if (found.length === 3 || found[3] > 0.5) return found;
    }
    return [255, 255, 255];
  };
  const found = [];
  for (const one of document.querySelectorAll("body *")) {
    const says = [...one.childNodes].some((node) => node.nodeType === 3 && node.textContent.trim());
    if (!says || !one.checkVisibility() || one.closest("svg")) continue;
    const [low, high] = [light(parts(getComputedStyle(one).color)), light(ground(one))].sort((a, b) => a - b);
    const contrast = (high + 0.05) / (low + 0.05);
    const text = one.textContent.trim().slice(0, 30);
    if (contrast < 4.5) found.push(`${one.tagName} ${one.className} "${text}" ${contrast.toFixed(2)}`);
  }
  return found;
})()"""


#: A microphone that beeps, and nobody who has to be asked.
FAKE_MICROPHONE = ("--use-fake-device-for-media-stream", "--use-fake-ui-for-media-stream")


class ConsoleBrowser:
    """One page in a browser. Close it when it is needed no more."""

    def __init__(self, url: str) -> None:
        """Open the page."""
        options = Options()
        for argument in (
            "--headless=new",
            "--no-sandbox",
            "--disable-dev-shm-usage",
            "--hide-scrollbars",
            *FAKE_MICROPHONE,
        ):
            options.add_argument(argument)
        options.binary_location = CHROMIUM
        options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
        self.driver = webdriver.Chrome(service=Service(DRIVER), options=options)
        self.url = url
        self.resize(*WINDOW)
        self.driver.get(url)

    def close(self) -> None:
        """End the browser."""
        self.driver.quit()

    def resize(self, width: int, height: int, *, scale: float = 1.0, is_dark: bool = False) -> None:
        """Set the size of the page in pixels, and the colours that the person likes."""
        self.driver.execute_cdp_cmd(
            "Emulation.setDeviceMetricsOverride",
            {"width": width, "height": height, "deviceScaleFactor": scale, "mobile": width < 600},
        )
        scheme = "dark" if is_dark else "light"
        features = [{"name": "prefers-color-scheme", "value": scheme}]
        self.driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": features})

    def complaints(self) -> List[str]:
        """Return what the browser has complained about since the last call, such as violations of the policy."""
        return [str(entry["message"]) for entry in self.driver.get_log("browser") if entry["level"] == "SEVERE"]

    def run(self, script: str) -> Any:
        """Return the value of a JavaScript expression."""
        return self.driver.execute_script(f"return {script}")

    def faint_texts(self) -> List[str]:
        """Return the texts that are hard to read on their ground."""
        return list(self.run(FAINT))

    def nameless(self) -> List[str]:
        """Return the roles of what a screen reader finds and cannot name."""
        nodes = self.driver.execute_cdp_cmd("Accessibility.getFullAXTree", {})["nodes"]
        told = [node for node in nodes if not node["ignored"] and node["role"]["value"] in NAMED_ROLES]
        assert told
        return [node["role"]["value"] for node in told if not node.get("name", {}).get("value", "").strip()]

    def findings(self) -> List[str]:
        """Return what axe-core finds; call it where `AXE` is a file."""
        self.driver.execute_script(AXE.read_text(encoding="utf-8"))
        found = self.driver.execute_async_script("axe.run(document).then(arguments[arguments.length - 1])")
        return [f"{one['id']}: {node['html']}" for one in found["violations"] for node in one["nodes"]]

    def seen_text(self) -> str:
        """Return the text that is to be seen."""
        return str(self.run("document.body.innerText"))

    def press(self, *keys: str) -> None:
        """Press keys wherever the focus is."""
        ActionChains(self.driver).send_keys(*keys).perform()

    def _touch(self, kind: str, points: List[Tuple[float, float]]) -> None:
        touches = [{"x": x, "y": y, "id": number} for number, (x, y) in enumerate(points)]
        self.driver.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": kind, "touchPoints": touches})

    def _middle(self, selector: str) -> Tuple[float, float]:
        box = self.run(f"document.querySelector({json.dumps(selector)}).getBoundingClientRect().toJSON()")
        return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2

    def tap(self, selector: str) -> None:
        """Touch an element with a finger."""
        self._touch("touchStart", [self._middle(selector)])
        self._touch("touchEnd", [])

    def pinch(self, selector: str, before: float, after: float) -> None:
        """Move two fingers on an element from one distance to another, pixels."""
        x, y = self._middle(selector)
        for step in range(11):
            half = (before + (after - before) * step / 10) / 2
            self._touch("touchMove" if step else "touchStart", [(x - half, y), (x + half, y)])
            time.sleep(0.03)
        self._touch("touchEnd", [])

    def find(self, selector: str) -> List[WebElement]:
        """Return the elements of a CSS selector."""
        return list(self.driver.find_elements(By.CSS_SELECTOR, selector))

    def texts(self, selector: str) -> List[str]:
        """Return the texts of the elements of a CSS selector, as they are in the page, shown or not."""
        return list(self.run(f"[...document.querySelectorAll({json.dumps(selector)})].map((one) => one.textContent)"))

    def is_connected(self) -> bool:
        """Whether the page hears the console."""
        return bool(self.run("document.getElementById('state').dataset.state !== 'lost'"))

    def say(self, text: str) -> None:
        """Type a sentence and send it; returns when the page shows it."""
        count = len(self.find("#log li"))
        field = self.find("#text")[0]
        field.clear()
        field.send_keys(text + "\n")
        wait_until(lambda: len(self.find("#log li")) > count, message=f"the page does not show {text!r}")

    def click(self, selector: str, text: str) -> None:
        """Click the button with this text."""

        def is_clicked() -> bool:
            try:
                button = next((one for one in self.find(selector) if one.text.strip() == text), None)
                if button is not None:
                    button.click()
            except StaleElementReferenceException:
                return False  # the page has put another button in its place
            return button is not None

        wait_until(is_clicked, message=lambda: self.texts(selector))

    def choose_number(self, which: str, name: str) -> None:
        """Have a number drawn over time.

        Args:
            which: of the plots, "one" or "other"
            name: of the number, as the page offers it
        """
        select = f"#plots .{which} select"
        wait_until(lambda: name in self.texts(f"{select} option"), message=lambda: self.texts(f"{select} option"))
        self.run(
            f"(() => {{ const one = document.querySelector('{select}'); one.value = "
            f"[...one.options].find((each) => each.text === {name!r}).value; "
            "one.dispatchEvent(new Event('change')); })()"
        )

    def reply(self, timeout_s: float = 60.0) -> str:
        """Wait for the reply to the newest command; returns its outcome."""
        newest = "#log li:last-child .robot:not(.waiting)"
        classes: List[str] = []

        def is_there() -> bool:
            # At once: a row may come behind it at any time.
            classes[:] = str(self.run(f"document.querySelector('{newest}')?.className ?? ''")).split()
            return bool(classes)

        wait_until(is_there, timeout_s, lambda: self.texts("#log li"))
        return classes[-1]

    def pose(self) -> Dict[str, float]:
        """Return where the map shows the robot: metres, degrees."""
        data = self.run("({...document.getElementById('ground').dataset})")
        return {name: float(data[name]) for name in ("x", "y", "heading") if name in data}

    def settles(self, timeout_s: float = 10.0) -> bool:
        """Wait until the robot stands still on the map for half a second; returns whether it does."""

        def stands() -> bool:
            before = self.pose()
            time.sleep(0.5)
            return before == self.pose()

        return comes_true(stands, timeout_s)

    def screenshot(self, path: str) -> None:
        """Write the page as PNG."""
        assert self.driver.save_screenshot(path)
