"""A person plays recordings in a real browser: a run with video, map, values and events; a damaged file; a download."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from tests.helpers.browser import BROWSER_MARKS, console_for, page_at
from tests.helpers.command_line import shared_robot

pytest.importorskip("foxglove", reason="needs the extra 'recording'")
pytest.importorskip("av", reason="the extra 'video' is not installed")

from tests.helpers.recorded_run import write_run

pytestmark = BROWSER_MARKS


@pytest.fixture
def url(tmp_path: Path) -> Iterator[str]:
    run = write_run(tmp_path / "circle.mcap")
    (tmp_path / "cut.mcap").write_bytes(run.read_bytes()[:5000])
    for name in ("50%.mp4", "a&b?c#d.mp4", " film.mp4", "notes.txt"):
        (tmp_path / name).touch()
    with (
        shared_robot(few_pictures=True) as robot,
        console_for(robot.local, "--recordings", str(tmp_path)) as (address, _),
    ):
        yield address


def test_a_run_is_played_and_downloaded(url: str, tmp_path: Path) -> None:
    with page_at(url) as page:
        page.get_by_role("tab", name="Recordings").click()
        page.get_by_text("Not listed for their names: 3. Names begin with a letter or digit").wait_for()
        page.get_by_text("Not listed as they are no recordings: 1").wait_for()
        page.get_by_role("button", name="play circle.mcap").click()
        canvas = page.locator("canvas[data-topic='/101.1.106/video']")
        canvas.wait_for()
        page.wait_for_function("+document.querySelector('canvas[data-topic]').dataset.pictures > 0")
        slider = page.get_by_role("slider", name="time of the run in seconds")
        slider.evaluate("each => { each.value = 5.3; each.dispatchEvent(new Event('input')); }")
        page.wait_for_function("Math.abs(document.querySelector('canvas[data-topic]').dataset.time - 5.3) < 0.11")
        assert "0:05.3 / 0:07.9" in page.locator(".run-clock").inner_text()
        assert "STANDBY" in page.locator(".run-event.now").inner_text()
        place = page.evaluate("jauspy.recordings.run.at(Object.values(jauspy.recordings.run.run.tracks)[0])")
        assert place == 53
        page.locator(".run-event").nth(1).click()
        page.wait_for_function("Math.abs(document.querySelector('canvas[data-topic]').dataset.time - 2) < 0.11")
        page.get_by_role("button", name="play", exact=True).click()
        page.wait_for_function("document.querySelector('canvas[data-topic]').dataset.time > 3.5")
        page.locator(".run-bar").get_by_role("button", name="pause").click()
        page.get_by_label("add a value").select_option(label="101.1.102 LocalPose.yaw [rad]")
        page.get_by_role("button", name="remove 101.1.102 LocalPose.yaw").wait_for()
        with page.expect_download() as download:
            page.get_by_role("link", name="download circle.mcap").click()
        assert download.value.path().read_bytes() == (tmp_path / "circle.mcap").read_bytes()
        page.get_by_role("button", name="play cut.mcap").click()
        page.get_by_text("cut.mcap is no complete MCAP file").wait_for()
