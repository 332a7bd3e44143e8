"""Cameras in a real browser: why there is no picture, overlay, still images, recordings, settings, and a slow page."""

from __future__ import annotations

import re
import time
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import psutil
import pytest
from tests.helpers.browser import BROWSER_MARKS, console_for, new_page, page_at
from tests.helpers.command_line import RunningRobot, shared_robot

pytest.importorskip("av", reason="the extra 'video' is not installed")

pytestmark = BROWSER_MARKS
SLOW_PAGE = "setInterval(() => { const end = performance.now() + 900; while (performance.now() < end); }, 920)"


@pytest.fixture(scope="module")
def robot() -> Iterator[RunningRobot]:
    with shared_robot() as running:
        yield running


@pytest.fixture(scope="module")
def recordings(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("recordings")


@pytest.fixture(scope="module")
def url(robot: RunningRobot, recordings: Path) -> Iterator[str]:
    with console_for(robot.local, "--recordings", str(recordings)) as (address, _):
        yield address


def wait_for_pictures(page: Any, count: int = 3) -> None:
    page.wait_for_function(
        f"jauspy.video.views.size && [...jauspy.video.views.values()].every((view) => view.shown >= {count})"
    )


def workers(robot: RunningRobot) -> list[psutil.Process]:
    found = []
    for each in psutil.Process(robot.process.pid).children(recursive=True):
        with suppress(psutil.Error):  # it ends now
            if "camera_worker" in " ".join(each.cmdline()):
                found.append(each)
    return found


def test_a_browser_without_a_decoder_says_so(url: str) -> None:
    with page_at(url, "delete window.VideoDecoder") as page:
        page.get_by_text("no picture: this browser has no WebCodecs").first.wait_for()


def test_a_camera_that_hangs_is_seen_at_once(url: str, robot: RunningRobot) -> None:
    with page_at(url) as page:
        wait_for_pictures(page)
        processes = workers(robot)
        assert len(processes) == 3
        for each in processes:
            each.suspend()
        try:
            page.locator("figure.large.stale").wait_for()
            page.get_by_text(re.compile(r"this picture is \d+ s old: no further picture has arrived")).first.wait_for()
        finally:
            for each in processes:
                each.resume()
        page.locator("figure.large:not(.stale)").wait_for()


def test_a_camera_that_starts_on_a_busy_machine_says_so(url: str, robot: RunningRobot) -> None:
    """Its process is stopped before it has a picture."""
    with page_at(url) as page:
        wait_for_pictures(page)
    old = {each.pid for each in workers(robot)}
    for each in workers(robot):
        each.kill()
    deadline = time.monotonic() + 60.0
    while len(new := [each for each in workers(robot) if each.pid not in old]) < 3:
        assert time.monotonic() < deadline, "they do not start again"
    for each in new:
        each.suspend()
    try:
        with page_at(url) as page:
            page.get_by_text(re.compile("no picture: the camera says: camera arm is still starting")).first.wait_for()
            for each in new:
                each.resume()
            wait_for_pictures(page)
            page.wait_for_function("document.querySelector('figure.large .video-says').innerText === ''")
    finally:
        for each in new:
            each.resume()


def test_overlay_and_enlarging(url: str) -> None:
    with page_at(url) as page:
        wait_for_pictures(page)
        page.locator("figure.large .overlay .number").filter(has_text=re.compile(r"^\d+°$")).wait_for()
        page.locator("figure.large .numbers").get_by_text("0.0 m/s").wait_for()
        page.get_by_role("button", name="overlay").click()
        page.locator("figure.large .tape").wait_for(state="hidden")
        page.get_by_role("button", name="overlay").click()
        small = page.locator("figure:not(.large)").first
        name = small.get_attribute("aria-label")
        small.focus()
        page.keyboard.press("Enter")
        page.locator(f"figure.large[aria-label='{name}'] .tape").wait_for()


def test_a_recording_goes_on_without_the_page_that_began_it(url: str, recordings: Path) -> None:
    import av

    with page_at(url) as page:
        wait_for_pictures(page)
        page.get_by_role("button", name="record", exact=True).click()
        page.locator(".video-said").get_by_text("recording to").wait_for()
    with page_at(url) as page:
        page.get_by_text(re.compile(r"● 0:\d\d [^0]|● 0:\d\d 0\.[1-9]")).wait_for()
        page.get_by_role("button", name="stop recording").click()
        page.locator(".video-said").get_by_text(re.compile(r"recorded \d+ pictures .* to ")).wait_for()
        with page.expect_download() as download:
            page.get_by_role("button", name="still").click()
        assert download.value.path().read_bytes()[:2] == b"\xff\xd8", "a JPEG of the StillImage service"
    (film,) = recordings.iterdir()
    with av.open(str(film)) as container:
        assert sum(1 for _ in container.decode(video=0)) > 5


def test_settings_change_the_picture_and_one_who_does_not_operate_may_not(url: str) -> None:
    with page_at(url) as page:
        wait_for_pictures(page)
        page.get_by_role("button", name="settings").click()
        page.get_by_label("size").click()
        page.get_by_role("option", name="320 x 240").click()
        page.wait_for_function("document.querySelector('figure.large canvas').width === 320")
        page.get_by_text("headlights").wait_for()
        second = new_page(page.context.browser)
        second.goto(url)
        second.get_by_role("button", name="take", exact=True).click()
        second.get_by_text("you operate this robot").wait_for()
        page.get_by_label("size").click()
        page.get_by_role("option", name="640 x 480").click()
        page.get_by_text("size: another browser operates this robot").wait_for()
        second.close()
    with page_at(url) as page:
        wait_for_pictures(page)  # before it is connected, a click does nothing
        page.get_by_role("button", name="settings").click()
        page.get_by_label("size").click()
        page.get_by_role("option", name="640 x 480").click()
        page.wait_for_function("document.querySelector('figure.large canvas').width === 640")


def test_a_page_that_is_too_slow_says_what_it_leaves_out(url: str) -> None:
    with page_at(url, SLOW_PAGE) as page:
        page.get_by_text(
            re.compile(r"pictures (are \d+ ms|were) late: (small|all) cameras show key pictures only")
        ).wait_for()
        page.get_by_text("all cameras show key pictures only").wait_for()
        page.wait_for_function("[...jauspy.video.views.values()].every((view) => view.wanted === 'keys')")
        wait_for_pictures(page)


def test_small_cameras_are_reduced_first_and_only_for_what_is_late(url: str) -> None:
    """How late pictures are drawn decides, and no number of frames of the page, which is 15/s here."""
    judged = """(() => {
        const { video } = jauspy;
        clearInterval(video.judging);
        const views = [...video.views.values()];
        const large = views.find((view) => jauspy.isLarge(view.figure));
        const levels = [];
        const judge = (late, lateLarge) => {
            for (const view of views) view.lateNow = view === large ? lateLarge : late;
            for (const view of views) view.leftOutNow = 0;
            video.frames = 30;
            video.judge(2);
            levels.push(video.level);
        };
        for (let each = 0; each < 200; each += 1) judge(10, 10);  // what a busy machine has reduced before
        levels.length = 0;
        for (let each = 0; each < 9; each += 1) judge(100, 100);
        for (let each = 0; each < 3; each += 1) judge(900, 250);
        for (let each = 0; each < 4; each += 1) judge(900, 900);
        for (let each = 0; each < 3; each += 1) judge(900, 1200);
        for (let each = 0; each < 61; each += 1) judge(10, 10);
        return levels;
    })()"""
    with page_at(url) as page:
        wait_for_pictures(page)
        levels = page.evaluate(judged)
        assert levels[:9] == [0] * 9
        assert levels[9:12] == [0, 0, 1]
        assert levels[12:16] == [1] * 4, "key pictures of the large camera would be later than 0.9 s"
        assert levels[16:19] == [1, 1, 2]
        assert levels[-1] == 0


def test_a_tab_that_is_hidden_gets_no_video(url: str) -> None:
    with page_at(url) as page:
        wait_for_pictures(page)
        page.get_by_role("tab", name="Log").click()
        page.wait_for_function("[...jauspy.video.views.values()].every((view) => view.told.includes('nothing'))")
        page.get_by_role("tab", name="Video").click()
        before = page.evaluate("Math.max(...[...jauspy.video.views.values()].map((view) => view.shown))")
        wait_for_pictures(page, before + 1)


def test_each_picture_says_its_age_and_what_the_link_does(url: str) -> None:
    view = "[...jauspy.video.views.values()][0]"
    with page_at(url) as page:
        wait_for_pictures(page)
        ages = page.locator(".video-facts").filter(has_text=re.compile(r"/s {2}·.* \d+ ms|/s {2}·.* \d+ s"))
        ages.first.wait_for()
        page.evaluate(f"{view}.news({{ link: {{ missing: 0.05, lost: 0 }} }})")
        page.get_by_text("5.0 % lost, all restored").wait_for()
        page.evaluate(
            f"{view}.news({{ link: {{ missing: 0.12, lost: 0.004 }} }}); {view}.freezes.push([performance.now(), 1240])"
        )
        page.get_by_text(re.compile(r"12 % lost, 0\.4 % for good\s+·\s+stood still for 1\.2 s")).wait_for()
