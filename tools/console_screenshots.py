"""Screenshots of the console's panels for docs/console.md: light and dark, at 1440x900, 1024x768 and 390x844.

    python tools/console_screenshots.py [--backend sim] [--output docs/assets]

It runs a robot and a console with ports and sockets of its own, and needs Debian's chromium and playwright.
"""

from __future__ import annotations

import argparse
import io
import re
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Final

from PIL import Image
from playwright.sync_api import Error, Page, ViewportSize, sync_playwright

import jauspy

MAX_BYTES: Final = 250_000
SIZES: Final = {"1440x900": (1440, 900), "1024x768": (1024, 768), "390x844": (390, 844)}
SCHEMES: Final = ("light", "dark")
PANELS: Final = ("plots", "trajectory", "log", "tasks", "world", "video", "drive", "arm", "observe")
PRESETS: Final = ("one view", "drive", "arm", "observe")
"""Arrangements by their keys 1 to 4."""
CELL: Final = "cell"
"""The World of the factory cell, while its arm is assembled."""
RATE: Final = 3
"""Pictures a second of each camera of inc1: camera and browser draw without a GPU on the same machine."""
SOFTWARE_GL: Final = ("--use-angle=swiftshader", "--enable-unsafe-swiftshader")
PORT: Final = 3952
WAIT: Final = 180_000
"""Milliseconds for anything to appear."""


@contextmanager
def console(robot: str, backend: str, root: str) -> Iterator[str]:
    """The URL of a console beside a robot, which both end with the block; `root` is the folder of its sockets."""
    command = [sys.executable, "-m", "jauspy.cli.main", "up", robot, "--backend", backend, "--port", str(PORT)]
    command += ["--interface", "127.0.0.1", "--local-root", root, "--console", "--console-port", "0", "--plain"]
    with subprocess.Popen([*command, "--own-root"], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        try:
            found = (re.match(r"console: +(http\S+)", line) for line in process.stdout)
            yield next(each[1] for each in found if each)
        finally:
            process.send_signal(signal.SIGINT)


def robot_with_slow_cameras(folder: Path) -> str:
    """The file of inc1 whose cameras begin with `RATE`, in a folder."""
    shutil.copytree(Path(jauspy.__file__).with_name("robots"), folder)
    file = folder / "inc1.toml"
    head, *cameras = re.split(r"^\[\[cameras]]\n", file.read_text(), flags=re.MULTILINE)
    slow = (re.sub(r"^rate = \d+.*\n", "", camera, count=1, flags=re.MULTILINE) for camera in cameras)
    file.write_text(head + "".join(f"[[cameras]]\nrate = {RATE}\n{camera}" for camera in slow))
    return str(file)


def prepare(page: Page) -> None:
    """Add plots, drive a curve, so that there is something to see."""
    page.get_by_text("101 inc1").first.wait_for()
    page.get_by_role("tab", name="Video").click()
    wait_for_video(page)
    page.get_by_role("tab", name="Plots").click()
    add_traces(page, "LocalPose", ("x", "y", "yaw"))
    page.get_by_role("button", name="take", exact=True).click()
    page.get_by_text("you operate this robot").wait_for()
    page.locator(".heading", has_text="Fleet").click()  # away from input fields, so that keys drive
    for keys, seconds in (("W", 1.5), ("WA", 2.0), ("D", 1.0), ("", 4.0)):
        for key in keys:
            page.keyboard.down(f"Key{key}")
        page.wait_for_timeout(1000 * seconds)
        for key in keys:
            page.keyboard.up(f"Key{key}")


def add_traces(page: Page, message: str, fields: tuple[str, ...]) -> None:
    """Plot fields of a message of the first component."""
    page.get_by_label("message").click()
    page.get_by_role("option", name=message, exact=True).click()
    page.wait_for_timeout(1500)
    page.get_by_label("fields").click()
    for name in fields:
        page.locator(".q-item").filter(has_text=re.compile(f"^{name} ")).first.click()
    page.keyboard.press("Tab")
    page.get_by_role("button", name="add").click()
    page.locator(".trace").nth(len(fields) - 1).wait_for()


def show(page: Page, panel: str) -> None:
    """Open a tab, or arrange views; wait for the video; in the log, open a message; make a trajectory; drive."""
    page.locator(".heading", has_text="Control").click()  # away from fields
    page.keyboard.press(f"Digit{1 + PRESETS.index(panel)}" if panel in PRESETS else "Digit1")
    if panel in PRESETS:
        page.locator(".desk.arranged").wait_for()
        if panel == "arm":
            page.locator(".arm").get_by_text("joints", exact=True).click()
            page.locator(".arm").get_by_label("base_link_to_arm_link_1").first.fill("0.6")
            page.keyboard.press("Tab")
            page.wait_for_function("document.getElementById('world-3d').dataset.wanted === 'free'")
        page.wait_for_timeout(3000)
    else:
        page.get_by_role("tab", name=panel, exact=False).click()
    if panel == "tasks":
        page.locator(".card[aria-label='Sound']").wait_for()
    if panel == "video":
        wait_for_video(page)
    if panel == "world":
        page.wait_for_function("document.getElementById('world-3d').dataset.pictures > 5")
        page.wait_for_function("jauspy.world.pose && jauspy.map.toScreen(jauspy.world.pose)")
        for ahead, left in ((0.6, 0.9), (-0.8, 1.4), (-1.6, 0.0)):
            place = f"(([x, y]) => [x + {ahead}, y + {left}])(jauspy.world.pose)"
            right, down = page.evaluate(f"jauspy.map.toScreen({place})")
            page.locator("#world-map canvas").click(position={"x": right, "y": down})
            page.wait_for_timeout(1000)
        page.get_by_role("button", name="start", exact=True).click()
        page.get_by_text("drives to waypoint 2").wait_for()
        page.get_by_role("button", name="pause", exact=True).click()
    if panel == "trajectory":
        teach(page)
    if panel == "log":
        page.locator(".traffic tbody tr", has_text="ReportLocalPose").first.click()
        page.locator(".fields .path").first.wait_for()
    page.keyboard.press("KeyQ")  # acknowledges what this machine was too slow for
    page.mouse.move(2, 2)
    page.wait_for_timeout(1500)


def wait_for_video(page: Page) -> None:
    """Wait until each of the three cameras has shown some pictures."""
    page.wait_for_function(
        "[...document.querySelectorAll('canvas[data-component]')].filter(each => each.dataset.pictures > 3).length > 2"
    )


def teach(page: Page) -> None:
    """Make a trajectory of three rows, and play it."""
    page.locator(".arm").get_by_text("tool", exact=True).first.click()
    turn, shoulder = "base_link_to_arm_link_1", "arm_link_1_to_arm_link_2"
    for row, (seconds, turned, raised) in enumerate((("4", "0.6", "2.4"), ("6", "-0.6", "2.1"), ("0", "0", "2.7")), 1):
        page.get_by_role("button", name="add present positions").click()
        page.get_by_label(f"seconds of row {row}").fill(seconds)
        page.get_by_label(f"{turn} of row {row}").fill(turned)
        page.get_by_label(f"{shoulder} of row {row}").fill(raised)
        page.keyboard.press("Tab")
        page.wait_for_timeout(500)
    page.get_by_role("button", name="play", exact=True).click()
    page.locator(".line.active").wait_for()


@contextmanager
def assembling(root: str) -> Iterator[None]:
    """The UR10 of the cell takes parts out of the bins and joins them, as long as the block lasts."""
    command = [sys.executable, "-m", "jauspy.cli.main", "cell", "assemble", "--seed", "7", "--connect", f"local:{root}"]
    with subprocess.Popen(command, stdout=subprocess.DEVNULL) as process:
        try:
            yield
        finally:
            process.terminate()


def show_cell(page: Page) -> None:
    """Wait until the arm that is built has a joint, and better two, and show them."""
    page.get_by_role("tab", name="World").click()
    page.wait_for_function("document.getElementById('world-3d').dataset.pictures > 5")
    page.locator(".arm .q-select .q-field__control").click()
    page.get_by_role("option", name="CM-ARM arm").click()
    page.locator(".arm .joint", has_text="servo_1").wait_for(timeout=3 * WAIT)
    with suppress(Error):  # a busy machine takes longer
        page.locator(".arm .joint").nth(1).wait_for(timeout=WAIT / 3)
    page.mouse.move(2, 2)


def save(picture: bytes, path: Path) -> None:
    """As JPEG of the best quality that fits into `MAX_BYTES`."""
    image = Image.open(io.BytesIO(picture)).convert("RGB")
    for quality in (85, 75, 65, 50):
        data = io.BytesIO()
        image.save(data, "JPEG", quality=quality, optimize=True)
        if data.tell() < MAX_BYTES:
            break
    path.write_bytes(data.getvalue())
    print(f"{path}: {data.tell() // 1000} kB, quality {quality}")


def take_all(url: str, folder: Path, panels: Sequence[str]) -> None:
    """These panels in all sizes and schemes, of one page, on which the robot was driven before."""
    executable = shutil.which("chromium") or shutil.which("google-chrome")
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=executable, args=["--no-sandbox", *SOFTWARE_GL])
        # playwright evaluates conditions in the page, which the policy of the page forbids
        page = browser.new_page(viewport=ViewportSize(width=1440, height=900), bypass_csp=True)
        page.set_default_timeout(WAIT)
        page.goto(url)
        if CELL not in panels:
            prepare(page)
        for panel in panels:
            page.set_viewport_size(ViewportSize(width=1440, height=900))  # where all inputs are in sight
            if panel == CELL:
                show_cell(page)
            else:
                show(page, panel)
            for scheme in SCHEMES:
                page.emulate_media(color_scheme="dark" if scheme == "dark" else "light")
                for size, (width, height) in SIZES.items():
                    page.set_viewport_size(ViewportSize(width=width, height=height))
                    page.wait_for_timeout(1500)
                    save(page.screenshot(), folder / f"console_{panel}_{scheme}_{size}.jpg")
        browser.close()


def main() -> None:
    """Run all."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--backend", default="sim", help="of the robot")
    parser.add_argument("--output", type=Path, default=Path("docs/assets"), help="folder of the pictures")
    parser.add_argument(
        "--panel", action="append", choices=(*PANELS, CELL), help="only this one; may be given several times"
    )
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    panels = arguments.panel or (*PANELS, CELL)
    root = tempfile.mkdtemp(prefix="jauspy-")
    if of_robot := [each for each in panels if each != CELL]:
        robot = robot_with_slow_cameras(Path(root, "robots"))
        with console(robot, arguments.backend, root) as url:
            take_all(url, arguments.output, of_robot)
    if CELL in panels:
        with console("cell", "sim", root) as url, assembling(root):
            take_all(url, arguments.output, [CELL])


if __name__ == "__main__":
    main()
