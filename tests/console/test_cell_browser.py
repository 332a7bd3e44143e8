"""The factory cell in a real browser: a subsystem without cameras, with an arm of no joints."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

import pytest
from tests.helpers.browser import BROWSER_MARKS, WAIT, console_for, page_at, sync_api
from tests.helpers.command_line import start, stopped, wait_for
from tests.helpers.ports import unused_port

pytest.importorskip("mujoco", reason="needs the extra 'sim'")
pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)
pytestmark = BROWSER_MARKS


@pytest.fixture
def url(tmp_path: Path) -> Iterator[str]:
    where = ("--port", str(unused_port()), "--interface", "127.0.0.1", "--local-root", str(tmp_path), "--own-root")
    with stopped(start("up", "cell", "--plain", *where)) as cell:
        wait_for(cell, "stop it")
        with console_for(f"local:{tmp_path}", robot=201) as (address, _):
            yield address


def test_it_opens_on_the_world_and_names_its_arms(url: str) -> None:
    with page_at(url) as page:
        page.locator(".tabs .chosen", has_text="World").wait_for()
        waiting = page.locator("[data-line=waiting]")
        waiting.get_by_text(re.compile("starting the 3-D view|asking the robot|connecting")).wait_for(state="attached")
        page.wait_for_function(
            "jauspy.world.model?.joints.filter((each) => each.kind === 'free').length > 25"
            " && jauspy.world.joints.filter(Array.isArray).length > 25"
        )
        arm = page.locator("section.arm")
        arm.get_by_text("CM-MAN 201.1.10").first.wait_for()
        page.get_by_role("button", name="take", exact=True).click()
        page.get_by_text("you operate this robot").wait_for()
        arm.locator(".joint-value").nth(5).wait_for()
        move = arm.get_by_role("button", name="move", exact=True)
        sync_api.expect(move).to_be_enabled(timeout=WAIT)
        arm.locator(".q-select .q-field__control").click()
        page.get_by_role("option", name="CM-ARM arm 201.3.1").click()
        arm.get_by_text("no joints now").wait_for()
        sync_api.expect(move).to_be_disabled(timeout=WAIT)
        page.locator(".component", has_text="CM-MAN").click()
        name = page.locator(".service").get_by_text("ManipulatorJointPositionDriver", exact=True)
        assert "Manipulator<wbr>Joint<wbr>Position<wbr>Driver" in name.evaluate("(each) => each.outerHTML")


def test_the_conveyor_is_run_and_stopped(url: str) -> None:
    with page_at(url) as page:
        conveyor = page.locator("section.conveyor")
        conveyor.get_by_text(re.compile("^stands, moved")).wait_for()
        conveyor.get_by_text(re.compile("on it: .*box_1 at 0.2")).wait_for()
        conveyor.get_by_text("speed 0.10 m/s").wait_for()
        run = conveyor.get_by_role("button", name="run", exact=True)
        sync_api.expect(run).to_be_disabled(timeout=WAIT)
        page.get_by_role("button", name="take", exact=True).click()
        sync_api.expect(run).to_be_enabled(timeout=WAIT)
        run.click()
        conveyor.get_by_text(re.compile("0.10 m/s forward")).wait_for()
        conveyor.get_by_role("button", name="backward").click()
        run.click()
        conveyor.get_by_text(re.compile("0.10 m/s backward")).wait_for()
        conveyor.get_by_role("button", name="stop", exact=True).click()
        conveyor.get_by_text(re.compile("^stands, moved")).wait_for()
