"""A person moves the arm in a real browser: sliders with a ghost, tool by key and button, poses, a trajectory."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from tests.helpers.browser import BROWSER_MARKS, console_for, page_at
from tests.helpers.command_line import RunningRobot, shared_robot

pytestmark = BROWSER_MARKS
TURN, SHOULDER = "base_link_to_arm_link_1", "arm_link_1_to_arm_link_2"


@pytest.fixture(scope="module")
def robot() -> Iterator[RunningRobot]:
    with shared_robot(few_pictures=True) as running:
        yield running


@pytest.fixture(scope="module")
def url(robot: RunningRobot, tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    state = {**os.environ, "XDG_STATE_HOME": str(tmp_path_factory.mktemp("state"))}
    with console_for(robot.local, env=state) as (address, _):
        yield address


def until(page, *, least: float = -9.0, most: float = 9.0, joint: int = 0) -> None:
    """Wait until the measured position of a joint is within a range."""
    page.wait_for_function(
        f"(() => {{ const at = parseFloat(document.querySelectorAll('.joint-value')[{joint}].innerText);"
        f"return {least} <= at && at <= {most} }})()"
    )


def height(page) -> float:
    """Of the tool, metres."""
    return float(re.search(r"z (-?[\d.]+)", page.locator(".pose").inner_text())[1])


def still(page) -> float:
    """The height of the tool, which does not change any more; on a busy machine the page shows that late."""
    page.wait_for_timeout(600)  # 200 ms of the dead-man's switch, and two pictures of the panel
    heights = [height(page)]
    for _ in range(4):
        page.wait_for_timeout(700)
        heights.append(height(page))
        if heights[-1] == pytest.approx(heights[-2], abs=0.002):
            return heights[-1]
    pytest.fail(f"the tool still moves: {heights}")


def move_joints(page) -> None:
    """An exact position, then one beyond the limit, which is entered while the arm moves."""
    page.get_by_label(TURN).first.fill("0.4")
    page.get_by_label(SHOULDER).first.fill("2.0")
    page.keyboard.press("Tab")
    page.get_by_role("button", name="move", exact=True).click()
    until(page, least=0.38, most=0.42)
    page.get_by_label(TURN).first.fill("9")
    page.keyboard.press("Tab")
    page.locator(".arm button:has-text('move'):not([disabled])").click()
    page.locator(".arm .problem").get_by_text(f"{TURN} can be").wait_for()
    page.get_by_role("button", name="reset").click()


def move_tool(page) -> None:
    """By key, by button, and with loss of focus."""
    page.locator(".arm").get_by_text("tool", exact=True).first.click()
    page.wait_for_function("document.querySelector('.pose').innerText.includes('z ')")
    before = still(page)
    page.locator(".heading", has_text="Fleet").click()
    page.keyboard.down("KeyU")
    page.wait_for_timeout(1500)
    page.keyboard.up("KeyU")
    raised = still(page)
    assert raised > before + 0.02
    button = page.locator(".jog-button", has_text="z \N{MINUS SIGN}").bounding_box()
    page.mouse.move(button["x"] + 5, button["y"] + 5)
    page.mouse.down()
    page.wait_for_timeout(1500)
    page.mouse.up()
    lowered = still(page)
    assert lowered < raised - 0.02
    page.keyboard.down("KeyU")
    page.wait_for_timeout(500)
    page.evaluate("window.dispatchEvent(new Event('blur'))")
    still(page)
    page.keyboard.up("KeyU")


def keep_a_pose(page) -> None:
    """Under a name."""
    page.locator(".arm").get_by_text("poses", exact=True).click()
    page.get_by_label("name of the present pose").fill("low")
    page.locator(".arm").get_by_role("button", name="save").click()
    page.get_by_role("button", name="go to low").wait_for()


def move_to_poses_of_the_robot(page) -> None:
    """The arm alone, then with the flippers, and stopped on its way."""
    page.locator(".arm").get_by_text("poses", exact=True).click()
    page.get_by_role("button", name="go to inspect", exact=True).click()
    page.locator(".arm").get_by_text("joints", exact=True).click()
    until(page, least=1.72, most=1.77, joint=1)
    page.locator(".arm button:has-text('move'):not([disabled])").wait_for()
    page.locator(".arm").get_by_text("poses", exact=True).click()
    page.get_by_role("button", name="all to reach_low", exact=True).click()
    page.locator(".arm").get_by_text("joints", exact=True).click()
    until(page, least=0.63, most=0.68, joint=1)
    page.locator(".arm button:has-text('move'):not([disabled])").wait_for()
    page.locator(".arm").get_by_text("poses", exact=True).click()
    page.get_by_role("button", name="go to stow", exact=True).click()
    page.locator(".arm").get_by_role("button", name="stop").click()
    page.locator(".arm").get_by_role("button", name="stop").wait_for(state="hidden")
    page.locator(".arm").get_by_text("joints", exact=True).click()
    page.wait_for_timeout(1500)
    until(page, most=2.5, joint=1)
    page.locator(".arm").get_by_text("poses", exact=True).click()
    page.get_by_role("button", name="all to stow", exact=True).click()
    page.locator(".arm").get_by_text("joints", exact=True).click()
    until(page, least=2.68, joint=1)
    page.locator(".arm button:has-text('move'):not([disabled])").wait_for()
    assert page.locator(".arm .problem").first.inner_text() == ""


def teach(page) -> None:
    """Two rows: too fast first, then played, then one step."""
    page.get_by_role("tab", name="Trajectory").click()
    page.get_by_role("button", name="add present positions").click()
    page.get_by_label("seconds of row 1").wait_for()
    page.get_by_role("button", name="add present positions").click()
    page.get_by_label("seconds of row 2").wait_for()
    page.get_by_label(f"{TURN} of row 1").fill("-0.3")
    page.get_by_label("seconds of row 1").fill("0.01")
    page.keyboard.press("Tab")
    page.get_by_role("button", name="play", exact=True).click()
    page.locator(".trajectory .problem").get_by_text(re.compile(f"row 1: {TURN} needs at least")).wait_for()
    page.get_by_label("seconds of row 1").fill("3")
    page.keyboard.press("Tab")
    page.locator(".arm").get_by_text("joints", exact=True).click()
    page.get_by_role("button", name="play", exact=True).click()
    page.locator(".line.active").wait_for()
    until(page, most=-0.25)
    until(page, least=0.35)
    page.locator(".line.active").wait_for(state="detached")
    page.get_by_role("button", name="step", exact=True).click()
    until(page, most=-0.28)


def export(page, robot: RunningRobot, tmp_path: Path) -> None:
    """As a file, which is changed and loaded; as a program, which another client runs."""
    with page.expect_download() as saved:
        page.get_by_role("button", name="download").click()
    text = saved.value.path().read_text().replace("-0.3", "-0.5")
    with page.expect_download() as exported:
        page.get_by_role("button", name="export as Python").click()
    program = tmp_path / "wave.py"
    program.write_text(exported.value.path().read_text().replace("0.4", "0.7"))
    page.locator("input[type=file][accept='.json']").set_input_files(
        {"name": "mine.json", "mimeType": "application/json", "buffer": text.encode()}
    )
    page.wait_for_function(f"document.querySelector('[aria-label=\"{TURN} of row 1\"]').value === '-0.500'")
    page.get_by_role("button", name="release", exact=True).first.click()
    page.get_by_text("observing", exact=True).wait_for()
    page.locator(".trajectory .problem").get_by_text("take control first").wait_for()

    done = subprocess.run(
        [sys.executable, str(program), robot.local], capture_output=True, text=True, timeout=120, check=False
    )
    assert done.stdout.splitlines() == ["row 1 of 2", "row 2 of 2"], done.stderr
    until(page, least=0.6)


def test_an_arm_is_moved_and_taught(url: str, robot: RunningRobot, tmp_path: Path) -> None:
    with page_at(url) as page:
        page.locator(".joint-wanted input").first.wait_for()
        move = page.get_by_role("button", name="move", exact=True)
        assert move.is_disabled(), "only the operator's browser moves the arm"
        page.get_by_role("button", name="take", exact=True).click()
        page.get_by_text("you operate this robot").wait_for()
        move_joints(page)
        move_tool(page)
        keep_a_pose(page)
        teach(page)
        export(page, robot, tmp_path)


def test_an_arm_is_moved_to_poses_of_the_robot(url: str) -> None:
    with page_at(url) as page:
        page.locator(".joint-wanted input").first.wait_for()
        page.get_by_role("button", name="take", exact=True).click()
        page.get_by_text("you operate this robot").wait_for()
        move_to_poses_of_the_robot(page)


def test_the_wanted_posture_is_a_ghost_that_tells_what_it_would_touch(url: str) -> None:
    with page_at(url) as page:
        page.locator(".joint-wanted input").first.wait_for()
        page.locator(".heading", has_text="Control").click()
        page.keyboard.press("Digit3")
        page.wait_for_function("document.getElementById('world-3d').dataset.pictures > 3")
        page.get_by_label(TURN).first.fill("0.4")
        page.keyboard.press("Tab")
        page.wait_for_function("document.getElementById('world-3d').dataset.wanted === 'free'")
        page.get_by_label(SHOULDER).first.fill("-0.4")
        page.keyboard.press("Tab")
        page.locator(".wanted-posture").get_by_text(re.compile("would touch: .* and ")).wait_for()
        page.wait_for_function("document.getElementById('world-3d').dataset.wanted === 'touches'")
        page.get_by_role("button", name="reset").click()
        page.wait_for_function("document.getElementById('world-3d').dataset.wanted === 'none'")
        assert page.locator(".wanted-posture").inner_text() == ""
