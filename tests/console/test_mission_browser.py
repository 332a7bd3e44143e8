"""A person plans a mission in a real browser: a wait, a no-go area, save and load; two robots on one map."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.helpers.browser import BROWSER_MARKS, console_for, page_at
from tests.helpers.command_line import RunningRobot
from tests.helpers.ports import unused_port

pytest.importorskip("PIL", reason="needs the extra 'sim'")

from tests.helpers.tiles import write_tiles

pytestmark = BROWSER_MARKS


@pytest.fixture
def url(tmp_path: Path) -> Iterator[str]:
    tiles = write_tiles(tmp_path / "map.mbtiles", 38.593, -77.179)
    robot = RunningRobot(unused_port(), tmp_path / "sockets", "rover", "--also", "rover", backend="kinematic")
    try:
        options = ("--recordings", str(tmp_path), "--map", str(tiles))
        state = {**os.environ, "XDG_STATE_HOME": str(tmp_path / "state")}
        with console_for(robot.local, *options, robot=105, env=state) as (address, _):
            yield address
    finally:
        robot.close()


def click(page: Any, ahead: float, left: float) -> None:
    """Click on the map, metres from where the robot was when the page was opened."""
    page.evaluate("jauspy.map.draw()")
    right, down = page.evaluate(f"jauspy.map.toScreen([start[0] + {ahead}, start[1] + {left}])")
    box = page.locator("#world-map").bounding_box()
    ratio = page.evaluate("jauspy.map.ratio")
    page.mouse.click(box["x"] + 1 + right / ratio, box["y"] + 1 + down / ratio)


def plan(page: Any) -> None:
    """Open the map with two waypoints; the robot waits at the first."""
    page.get_by_role("tab", name="World").click()
    page.get_by_role("button", name="map", exact=True).click()
    page.wait_for_function("jauspy.world.pose && jauspy.world.geo && jauspy.world.others.length == 1")
    page.evaluate("window.start = jauspy.world.pose.slice(0, 2)")
    click(page, 0.8, 0.3)
    page.locator(".waypoint").nth(0).wait_for()
    click(page, 1.5, 0.0)
    page.locator(".waypoint").nth(1).wait_for()
    page.get_by_role("button", name="speed and action of waypoint 1").click()
    dialog = page.locator(".mission").filter(has_text="waypoint 1")
    dialog.get_by_label("speed in m/s").fill("0.4")
    dialog.get_by_label("at the waypoint").click()
    page.get_by_role("option", name="wait").click()
    dialog.get_by_label("seconds").fill("3")
    dialog.get_by_role("button", name="apply").click()
    page.get_by_role("button", name="speed and action of waypoint 1").get_by_text("0.4 m/s, wait 3 s").wait_for()


def test_a_mission_is_planned_saved_driven_and_loaded(url: str, tmp_path: Path) -> None:
    with page_at(url) as page:
        plan(page)
        page.wait_for_function("[...jauspy.mission.images.values()].some((each) => each.naturalWidth == 256)")
        page.get_by_role("button", name="mission …").click()
        page.get_by_role("button", name="draw an area").click()
        page.locator(".q-dialog__backdrop").first.wait_for(state="hidden")
        for ahead, left in ((1.1, -0.4), (1.3, -0.4), (1.3, 0.6), (1.1, 0.6)):
            click(page, ahead, left)
        page.get_by_role("button", name="done").click()
        page.get_by_role("button", name="take", exact=True).click()
        page.get_by_text("you operate this robot").wait_for()
        page.get_by_role("button", name="start", exact=True).click()
        page.get_by_text("the way to waypoint 2 leads through the no-go area 1").wait_for()
        page.get_by_role("button", name="mission …").click()
        page.locator(".mission").get_by_label("name").fill("cellar")
        page.get_by_role("button", name="save", exact=True).click()
        with page.expect_download() as download:
            page.get_by_role("button", name="download").click()
        saved = json.loads(download.value.path().read_text())
        assert saved["waypoints"][0]["action"] == {"kind": "wait", "seconds": 3.0}
        assert len(saved["no_go"][0]["corners"]) == 4
        page.get_by_role("button", name="remove area 1").click()
        page.get_by_role("button", name="close").click()

        page.get_by_role("button", name="start", exact=True).click()
        page.locator(".progress").get_by_text("drives to waypoint 1 of 2").wait_for()
        buttons = page.locator(".execution button:visible").all_inner_texts()
        assert buttons[0] == "stop", "the first of a mission that runs"
        assert "clear" not in buttons
        page.locator(".progress").get_by_text("at waypoint 1 of 2: wait 3 s").wait_for()
        page.locator(".progress").get_by_text("the mission ended at waypoint 2 of 2").wait_for()
        x, y = page.evaluate("jauspy.world.pose.slice(0, 2).map((each, axis) => each - start[axis])")
        assert abs(x - 1.5) < 0.3
        assert abs(y) < 0.3

        page.reload()
        page.get_by_role("tab", name="World").click()
        page.wait_for_function("jauspy.world.pose")
        page.get_by_role("button", name="mission …").click()
        page.get_by_label("saved missions").click()
        page.get_by_role("option", name="cellar").click()
        page.get_by_role("button", name="load", exact=True).click()
        page.get_by_role("button", name="speed and action of waypoint 1").get_by_text("0.4 m/s, wait 3 s").wait_for()
        assert page.evaluate("jauspy.mission.areas.length") == 1
        bad = {"name": "bad.json", "mimeType": "application/json", "buffer": b'{"format": "<img src=x>"}'}
        page.get_by_role("button", name="mission …").click()
        page.locator(".mission input[type=file]").set_input_files(bad)
        page.get_by_text("bad.json: format: Input should be 'jauspy-mission'").wait_for()
        page.locator(".mission input[type=file]").set_input_files({**bad, "buffer": bytes((1 << 20) + 1)})
        page.get_by_text("the file was not taken: it has more than 1 MiB").wait_for()
