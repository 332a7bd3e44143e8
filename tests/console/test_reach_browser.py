"""A person clicks a thing in the 3-D view of a real browser: the robot's planner shows the way and reaches for it."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from typing import Any

import pytest
from tests.helpers.browser import BROWSER_MARKS, console_for, page_at
from tests.helpers.command_line import shared_robot, start, stopped

pytest.importorskip("ompl", reason="needs the extra 'planning'")
pytest.importorskip("coal", reason="needs the extra 'planning'")

from jauspy.console.reaching import SIZE, STANDOFF

pytestmark = BROWSER_MARKS
PLACE = (0.75, 0.3, 0.0)
"""On the ground, left before the robot; metres."""


@pytest.fixture
def url() -> Iterator[str]:
    with (
        shared_robot(few_pictures=True) as robot,
        stopped(start("planner", "101.1.104", "--no-sensors", "--connect", robot.local)) as planner,
    ):
        assert planner.stderr is not None
        assert "101.1.130 plans motions of 101.1.104" in planner.stderr.readline()
        with console_for(robot.local) as (address, _):
            yield address


def click_at(page: Any, place: tuple[float, float, float]) -> None:
    """Click where the 3-D view shows a place of the world."""
    x, y = page.evaluate(
        """(place) => {
            const seen = new jauspy.view.library.THREE.Vector3(...place).project(jauspy.view.camera);
            const box = jauspy.view.renderer.domElement.getBoundingClientRect();
            return [box.left + (box.width * (1 + seen.x)) / 2, box.top + (box.height * (1 - seen.y)) / 2];
        }""",
        list(place),
    )
    page.mouse.click(x, y)


def tool(page: Any) -> list[float]:
    text = page.locator(".jog .pose").inner_text()
    return [float(re.search(rf"{axis} (-?[\d.]+)", text)[1]) for axis in "xyz"]


def test_the_arm_reaches_for_what_is_clicked_after_the_ghost_is_agreed_with(url: str) -> None:
    with page_at(url) as page:
        page.get_by_text("101 inc1").first.wait_for()
        page.get_by_role("tab", name="World").click()
        page.wait_for_function("+document.getElementById('world-3d').dataset.pictures > 3")
        row = page.locator("[aria-label='Planned motion']")
        assert row.get_by_role("button", name="reach …").is_disabled(), "only the operator's page reaches"
        page.get_by_role("button", name="take", exact=True).click()
        page.get_by_text("you operate this robot").wait_for()
        page.locator(".arm").get_by_text("tool", exact=True).first.click()
        page.wait_for_function("document.querySelector('.jog .pose').innerText.includes('z ')")
        before = tool(page)

        row.get_by_role("button", name="reach …").click()
        row.get_by_text("click a thing in the 3-D view").wait_for()
        click_at(page, PLACE)
        row.get_by_role("button", name="execute").wait_for()
        page.wait_for_function("+document.getElementById('world-3d').dataset.ghost > 1")
        assert tool(page) == pytest.approx(before, abs=0.005), "nothing moves before the operator agrees"
        row.get_by_role("button", name="cancel motion").click()
        page.wait_for_function("+document.getElementById('world-3d').dataset.ghost === 0")
        assert tool(page) == pytest.approx(before, abs=0.005)

        row.get_by_role("button", name="reach …").click()
        row.get_by_text("click a thing in the 3-D view").wait_for()
        click_at(page, PLACE)
        row.get_by_role("button", name="execute").click()
        row.get_by_text(re.compile("^reached")).wait_for()
        page.wait_for_timeout(1500)
        assert math.dist(tool(page), PLACE) == pytest.approx(STANDOFF, abs=0.02 + max(SIZE))
        page.get_by_text("you operate this robot").wait_for()
        joint = page.locator(".arm").get_by_text("joints", exact=True)
        joint.click()
        page.locator(".arm button:has-text('move')").first.wait_for()
        assert row.locator(".problem").inner_text() == ""
