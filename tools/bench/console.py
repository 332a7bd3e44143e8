"""The console in the browser: latency of its video, and what it costs with several robots and browsers.

python tools/bench/console.py latency [--seconds 30] [--backend kinematic]
python tools/bench/console.py load [--seconds 20] [--robots 3] [--browsers 4] [--backend kinematic]

`latency`: a robot with two cameras, 640x480 with 15 pictures a second, a node manager, the console and a headless
chromium with one page that shows both. Each picture carries the monotonic time of the state that it shows, drawn as
squares (`stamped` of the camera); the page reads them from the canvas.

    drawn    from the state that a picture shows until it is on the canvas
    shown    until the frame of the page with it has been made
    stated   how far the time that comes with the stream is from the stamp (the overlay shows it)

Processor time is in cores: of the cameras' processes (rendering and encoding; of that encoding, measured alone), of
robot, node manager and console, and of the browser's processes.

`load`: several robots with two cameras each, and as many pages. First all pages show plots, together 100 reports a
second, and no video; then each shows the video of a robot, and further ones are received as well. `key` is from the
key's event in the browser until the command is sent to the node manager. The page's own rate is measured while it
works, and what it says about that is printed.
"""

from __future__ import annotations

import argparse
import json
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

import numpy as np
import psutil
from _processes import free_port, node_manager
from playwright.sync_api import Browser, Page, sync_playwright

from jauspy.platform.video_settings import VideoSettings
from jauspy.video.h264 import H264Encoder

SERVER = Path(__file__).with_name("_console_server.py")
ROBOT = """
extends = "inc1"
name = "robot{number}"
subsystem = {subsystem}
backend = "{backend}"
modules = [
  {{ type = "CM-MOB", component = 102 }},
  {{ type = "CM-VIS", component = 106, camera = "arm" }},
  {{ type = "CM-VIS", component = 107, camera = "chassis" }},
]
cameras = [
  {{ name = "arm", link = "arm_camera_link", fov = 80.0, size = [640, 480], rate = 15, stamped = true }},
  {{ name = "chassis", link = "chassis_camera_link", fov = 80.0, size = [640, 480], rate = 15, stamped = true }},
]
"""
HOOK = """
() => {
  window.seen = [];
  const clock = () => performance.timeOrigin + performance.now();
  jauspy.video.onShown = (canvas, taken) => {
    const drawn = clock();
    const side = Math.floor(canvas.width / 32);
    const { data } = canvas.getContext("2d").getImageData(0, side + (side >> 1), 32 * side, 1);
    let stamp = 0;
    for (let bit = 0; bit < 32; bit += 1) stamp = stamp * 2 + (data[4 * (bit * side + (side >> 1))] > 125 ? 1 : 0);
    requestAnimationFrame(() => setTimeout(() => seen.push([canvas.dataset.component, stamp, taken, drawn, clock()])));
  };
}
"""
KEYS = """
() => {
  window.keys = [];
  addEventListener("keydown", (event) => {
    if (event.code === "KeyW" && !event.repeat) keys.push(performance.timeOrigin + event.timeStamp);
  }, true);
}
"""


def cpu(processes: list[psutil.Process]) -> float:
    """Seconds of processor time of these processes so far."""
    total = 0.0
    for process in processes:
        try:
            times = process.cpu_times()
        except psutil.NoSuchProcess:
            continue
        total += times.user + times.system
    return total


def family(process: psutil.Process) -> list[psutil.Process]:
    """A process with all below it."""
    return [process, *process.children(recursive=True)]


class Stage:
    """Robots, node manager, console and a browser, as processes."""

    def __init__(self, browser: Browser, url: str, server: subprocess.Popen[str], robots: list[subprocess.Popen[str]]):
        self.browser, self.url, self.server, self.robots = browser, url, server, robots

    def page(self) -> Page:
        """A page that shows the first robot."""
        # playwright evaluates conditions in the page, which the policy of the page forbids
        page = self.browser.new_page(viewport={"width": 1440, "height": 900}, bypass_csp=True)
        page.set_default_timeout(120_000)
        page.goto(self.url)
        page.locator(".robot").nth(len(self.robots) - 1).wait_for()
        page.locator(".robot .name").first.click()
        return page

    def groups(self) -> dict[str, list[psutil.Process]]:
        """The processes by what they do."""
        robots = [each for robot in self.robots for each in family(psutil.Process(robot.pid))]
        cameras = [each for each in robots if "camera_worker" in " ".join(each.cmdline())]
        chromium = [
            each
            for each in psutil.Process().children(recursive=True)
            if "chrom" in each.name() and each.status() != psutil.STATUS_ZOMBIE
        ]
        return {
            "cameras": cameras,
            "robots": [each for each in robots if each not in cameras],
            "console": [psutil.Process(self.server.pid)],
            "browser": chromium,
        }

    def used(self, seconds: float, wait: Any) -> dict[str, float]:
        """Cores used by each group while `wait(milliseconds)` runs."""
        groups = self.groups()
        before, began = {name: cpu(each) for name, each in groups.items()}, time.monotonic()
        wait(1000.0 * seconds)
        passed = time.monotonic() - began
        return {name: (cpu(each) - before[name]) / passed for name, each in groups.items()}


@contextmanager
def stage(count: int, backend: str) -> Iterator[Stage]:
    """Everything runs; it ends with the block."""
    with ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix="jauspy-")))
        port = free_port()

        def child(*command: str) -> subprocess.Popen[str]:
            process = subprocess.Popen(
                [sys.executable, *command], stdin=-1, stdout=-1, stderr=subprocess.DEVNULL, text=True
            )
            stack.callback(process.communicate)  # closes its standard input, which ends the console
            stack.callback(process.terminate)
            assert process.stdout is not None
            return process

        manager = child(*node_manager(str(folder / "root"), port))
        assert manager.stdout is not None
        manager.stdout.readline()
        robots = []
        for number in range(count):
            file = folder / f"robot{number}.toml"
            file.write_text(ROBOT.format(number=number, subsystem=101 + number, backend=backend))
            options = ("--port", str(port), "--interface", "127.0.0.1", "--local-root", str(folder / "root"), "--plain")
            robot = child("-m", "jauspy.cli.main", "up", str(file), *options)
            assert robot.stdout is not None
            if not any("stop it" in line for line in robot.stdout):
                raise SystemExit(f"a robot did not start: try jauspy up {file}")
            robots.append(robot)
        server = child(str(SERVER), str(folder / "root"))
        assert server.stdout is not None
        url = server.stdout.readline().strip()
        playwright = stack.enter_context(sync_playwright())
        browser = playwright.chromium.launch(executable_path=shutil.which("chromium"), args=["--no-sandbox"])
        stack.callback(browser.close)
        yield Stage(browser, url, server, robots)


def clock_offset(page: Page) -> float:
    """Milliseconds from the machine's monotonic clock to the page's, by the fastest of many questions."""
    best = (float("inf"), 0.0)
    for _ in range(50):
        before = time.monotonic()
        now = page.evaluate("performance.timeOrigin + performance.now()")
        after = time.monotonic()
        best = min(best, (after - before, now - 500.0 * (before + after)))
    return best[1]


def percentiles(values: list[float]) -> str:
    """Median and 95th percentile, in milliseconds."""
    if not values:
        return "   none"
    ordered = sorted(values)
    return f"{statistics.median(ordered):7.0f}{ordered[int(0.95 * len(ordered))]:7.0f}"


def encoding_share(rate: int) -> float:
    """Cores that encoding alone takes for a camera, of noise that moves."""
    encoder, random = H264Encoder(VideoSettings()), np.random.default_rng(1)
    image = np.kron(random.integers(0, 255, (30, 40, 3), np.uint8), np.ones((16, 16, 1), np.uint8))
    began = time.process_time()
    for number in range(60):
        encoder.encode(np.roll(image, number, axis=1))
    return (time.process_time() - began) / 60 * rate


def latency(seconds: float, backend: str) -> None:
    """From picture taken to picture shown."""
    with stage(1, backend) as at:
        page = at.page()
        page.wait_for_function("[...jauspy.video.views.values()].filter((view) => view.shown > 15).length > 1")
        page.evaluate(HOOK)
        used = at.used(seconds, page.wait_for_timeout)
        seen, offset = page.evaluate("seen"), clock_offset(page)
        wall = 1000.0 * (time.time() - time.monotonic())
        frame_rate = page.evaluate("jauspy.video.frameRate")
        print(
            f"{'camera':12}{'pictures/s':>11}{'drawn p50':>12}{'p95':>5}{'shown p50':>12}{'p95':>5}{'stated':>7}   [ms]"
        )
        everything: list[float] = []
        for camera in sorted({each[0] for each in seen}):
            rows = [each for each in seen if each[0] == camera]
            drawn, shown, stated = [], [], []
            for _, stamp, taken, at_drawn, at_shown in rows:
                until_shown = (round(1e3 * (at_shown - offset)) - stamp) % (1 << 32) / 1e3
                shown.append(until_shown)
                drawn.append(until_shown - (at_shown - at_drawn))
                if taken:
                    stated.append((round(1e3 * (taken - wall)) - stamp + (1 << 31)) % (1 << 32) / 1e3 - (1 << 31) / 1e3)
            everything += shown
            print(
                f"{camera:12}{len(rows) / seconds:11.1f}{percentiles(drawn):>17}{percentiles(shown):>17}"
                f"{statistics.median(stated) if stated else float('nan'):7.0f}"
            )
        print(f"both: shown p50 and p95{percentiles(everything)} ms; the page made {frame_rate:.0f} frames/s")
        told_by_page = page.locator("#video-load").inner_text()
        print(f"the page says: {told_by_page or 'nothing'}")
        print("cores: " + ", ".join(f"{name} {value:.2f}" for name, value in used.items()))
        print(f"of the cameras' time, encoding takes about {2 * encoding_share(15):.2f} cores")


def load(seconds: float, backend: str, robots: int, browsers: int) -> None:
    """Server and commands with and without video."""
    with stage(robots, backend) as at:
        pages = [at.page() for _ in range(browsers)]
        for number, page in enumerate(pages):
            page.locator(".robot .name").nth(number % robots).click()
        first = pages[0]
        first.get_by_role("button", name="take", exact=True).click()
        first.get_by_text("you operate this robot").wait_for()
        first.evaluate(KEYS)
        for page in pages:
            page.get_by_role("tab", name="Plots").click()
        for message, field in (("LocalPose", "x"), ("VelocityState", "velocity_x")):
            plot(first, message, field)
        first.locator(".heading", has_text="Fleet").click()
        measure(at, first, seconds, "plots, 100 reports/s, no video")
        for page in pages:
            page.get_by_role("tab", name="Video").click()
        first.wait_for_function("+document.querySelector('canvas[data-component]').dataset.pictures > 15")
        measure(at, first, seconds, f"{min(robots, browsers) * 2} videos in {browsers} pages")
        for number, page in enumerate(pages):
            facts = page.evaluate(
                "[jauspy.video.frameRate, document.getElementById('video-load').textContent,"
                " [...jauspy.video.views.values()].map((view) => view.times.length / 2)]"
            )
            print(f"page {number}: {facts[0]:.0f} frames/s, pictures/s {facts[2]}; it says: {facts[1] or 'nothing'}")


def plot(page: Page, message: str, field: str) -> None:
    """Add a trace with 50 reports a second."""
    page.get_by_label("message").click()
    page.get_by_role("option", name=message, exact=True).click()
    page.wait_for_timeout(1500)
    page.get_by_label("fields").click()
    page.locator(".q-item").filter(has_text=f"{field} ").first.click()
    page.keyboard.press("Tab")
    page.get_by_label("Hz").fill("50")
    page.get_by_role("button", name="add").click()
    page.locator(".trace").get_by_text(f"{message}.{field}").wait_for()


def measure(at: Stage, page: Page, seconds: float, what: str) -> None:
    """Drive, and print the cores of all and the way of a key to the wire."""
    page.evaluate("keys.length = 0")

    def press(milliseconds: float) -> None:
        end = time.monotonic() + milliseconds / 1000.0
        while time.monotonic() < end:
            page.keyboard.down("KeyW")
            page.wait_for_timeout(150)
            page.keyboard.up("KeyW")
            page.wait_for_timeout(650)

    used = at.used(seconds, press)
    offset = clock_offset(page)
    pressed = [(each - offset) / 1000.0 for each in page.evaluate("keys")]
    sent = commands(at)
    delays = []
    for began in pressed:
        after = next((each for each in sent if each >= began), None)
        if after is not None and after - began < 0.7:
            delays.append(1000.0 * (after - began))
    memory = psutil.Process(at.server.pid).memory_info().rss / 1e6
    print(f"{what}: key to wire p50 and p95{percentiles(delays)} ms of {len(delays)} in {len(pressed)} keys")
    print("  cores: " + ", ".join(f"{name} {value:.2f}" for name, value in used.items()) + f"; console {memory:.0f} MB")


def commands(at: Stage) -> list[float]:
    """When the console sent commands that move a robot, so far."""
    assert at.server.stdin is not None
    assert at.server.stdout is not None
    at.server.stdin.write("\n")
    at.server.stdin.flush()
    found: list[float] = json.loads(at.server.stdout.readline())
    return found


def main() -> None:
    """Run one of the two."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["latency", "load"])
    parser.add_argument("--seconds", type=float, default=20.0)
    parser.add_argument("--backend", default="kinematic")
    parser.add_argument("--robots", type=int, default=3)
    parser.add_argument("--browsers", type=int, default=4)
    options = parser.parse_args()
    if options.what == "latency":
        latency(options.seconds, options.backend)
    else:
        load(options.seconds, options.backend, options.robots, options.browsers)


if __name__ == "__main__":
    main()
