"""The pointer in the large picture, in a real browser: a drag and a click turn the camera, a click measures."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import pytest
from tests.helpers.browser import BROWSER_MARKS, GAMEPAD, HOLD_FOR_CAMERA, console_for, page_at
from tests.helpers.command_line import RunningRobot, camera_direction, shared_robot

pytest.importorskip("av", reason="the extra 'video' is not installed")

pytestmark = BROWSER_MARKS


@pytest.fixture(scope="module")
def robot() -> Iterator[RunningRobot]:
    with shared_robot() as running:
        yield running


@pytest.fixture(scope="module")
def url(robot: RunningRobot) -> Iterator[str]:
    with console_for(robot.local) as (address, _):
        yield address


def until(robot: RunningRobot, page: Any, is_there: Any) -> tuple[float, float]:
    for _ in range(20):
        if is_there(*(found := camera_direction(robot))):
            return found
        page.wait_for_timeout(300)
    pytest.fail(f"the camera looks {found}: {page.locator('.video-said').inner_text()}")


def test_a_camera_is_turned_by_drag_click_and_name(url: str, robot: RunningRobot) -> None:
    with page_at(url) as page:
        page.wait_for_function("jauspy.video.views.size === 3")
        page.get_by_text("chassis camera").wait_for()
        assert page.locator(".component", has_text="1.103").inner_text().find("flippers") > 0
        page.locator("figure[aria-label='camera 101.1.107']").click()
        page.get_by_role("button", name="look").wait_for()
        box = page.locator("figure.large").bounding_box()
        x, y = box["x"] + box["width"] / 2, box["y"] + box["height"] / 2
        page.wait_for_timeout(500)
        page.mouse.click(x + 100, y)
        page.locator(".video-said").get_by_text("the camera is not turned").wait_for()
        page.get_by_role("button", name="take", exact=True).click()
        page.get_by_text("you operate this robot").wait_for()

        page.mouse.move(x, y)
        page.mouse.down()
        for step in range(1, 6):
            page.mouse.move(x - 40 * step, y)
            page.wait_for_timeout(120)
        page.mouse.up()
        right, _ = until(robot, page, lambda right, up: right > 0.2 and abs(up) < 0.05)
        page.wait_for_function("document.querySelector('.video-said').innerText === ''")
        page.mouse.click(x + 150, y - 60)
        until(robot, page, lambda now, up: now > right + 0.1 and up > 0.05)
        page.get_by_role("button", name="look").click()
        page.get_by_text("ahead", exact=True).click()
        until(robot, page, lambda right, up: abs(right) < 0.02 and abs(up) < 0.02)
        page.get_by_role("button", name="release", exact=True).click()


def test_a_gamepad_turns_the_camera_while_its_button_is_held(url: str, robot: RunningRobot) -> None:
    with page_at(url, GAMEPAD) as page:
        page.wait_for_function("jauspy.video.views.size === 3")
        page.locator("figure[aria-label='camera 101.1.107']").click()
        page.get_by_role("button", name="look").wait_for()
        page.bring_to_front()
        before, _ = camera_direction(robot)
        page.evaluate("pad.axes[2] = 1")
        hold = f"pad.buttons[{HOLD_FOR_CAMERA}].pressed = "
        page.evaluate(hold + "true")
        page.wait_for_timeout(600)
        assert camera_direction(robot)[0] == pytest.approx(before, abs=0.01), "nobody operates the robot"
        page.get_by_role("button", name="take", exact=True).click()
        page.get_by_text("you operate this robot").wait_for()
        page.wait_for_timeout(600)
        assert camera_direction(robot)[0] == pytest.approx(before, abs=0.01), "it was held before"
        page.evaluate(hold + "false")
        page.wait_for_timeout(200)
        page.evaluate(hold + "true")
        until(robot, page, lambda right, _: right > before + 0.15)
        page.evaluate(hold + "false")
        page.wait_for_timeout(1000)
        after, _ = camera_direction(robot)
        page.wait_for_timeout(600)
        assert camera_direction(robot)[0] == pytest.approx(after, abs=0.02), "the stick alone"
        page.get_by_role("button", name="release", exact=True).click()


def test_a_click_measures_and_draws_the_gripper(url: str) -> None:
    with page_at(url) as page:
        page.wait_for_function("jauspy.video.views.size === 3")
        page.wait_for_function("document.querySelector('figure.large canvas').dataset.pictures > 0")
        page.locator("figure.large .cross").wait_for()
        box = page.locator("figure.large").bounding_box()
        page.mouse.click(box["x"] + box["width"] / 2, box["y"] + 0.7 * box["height"])
        page.locator(".sight .range").get_by_text(
            re.compile(r"^\d\.\d\d m \(floor, if level\), gripper 60 mm")
        ).wait_for()
        near = page.locator(".sight[data-shown] .grip").bounding_box()["width"]
        assert 5.0 < near < 100.0
        page.mouse.click(box["x"] + box["width"] / 2, box["y"] + 0.5 * box["height"])
        page.wait_for_function(f"document.querySelector('.sight[data-shown] .grip').clientWidth < {0.8 * near}")
