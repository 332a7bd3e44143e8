"""Texts of robots and files that are programs or markup, on all panels in a real browser: none of them runs."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from tests.helpers.browser import BROWSER_MARKS, chromium, console_for, new_page
from tests.helpers.command_line import stopped
from tools.attack.hostile_robot import IN_FILES, PAYLOADS, UNPRINTABLE

from jauspy.console.saved_files import SavedFiles
from jauspy.printable import printable
from jauspy.testing import LocalNode

pytestmark = BROWSER_MARKS
ROOT = Path(__file__).parents[2]
WATCH = """window.VIOLATIONS = [];
document.addEventListener("securitypolicyviolation", (event) =>
    window.VIOLATIONS.push(`${event.violatedDirective} ${event.blockedURI} ${event.sample}`));"""
ROBOT = f"66  {PAYLOADS[0]}"


@pytest.fixture(scope="module")
def files(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder of state with poses and trajectories whose names and joints are hostile, and a file of poses."""
    state = tmp_path_factory.mktemp("state")
    folder = SavedFiles(66, PAYLOADS[0], None, lambda _: None, state / "jauspy" / "console")._folder
    (folder / "trajectories").mkdir(parents=True)
    for number, text in enumerate(IN_FILES):
        if "/" not in text:
            (folder / "trajectories" / f"{text}.json").write_text(trajectory(text))
        (folder / "trajectories" / f"plain {number}.json").write_text(trajectory(text))
    poses = {text: dict.fromkeys(PAYLOADS, 0.5) for text in IN_FILES}
    authors = {text: {"by": text, "at": PAYLOADS[0]} for text in IN_FILES}
    saved = {"poses": {"66.1.1": poses, "66.1.2": poses}, "authors": {"66.1.1": authors}}
    (folder / "poses.json").write_text(json.dumps(saved))
    robot, joints = json.dumps(PAYLOADS[0]), "".join(f"{json.dumps(text)} = 0.5\n" for text in PAYLOADS)
    (state / "poses.toml").write_text(f"[{robot}.given]\n{joints}")
    return state


def trajectory(author: str) -> str:
    """A file of a trajectory for hostile joints, by this author."""
    rows = [{"seconds": 1.0, "positions": [0.1] * len(PAYLOADS)}] * 2
    by = {"by": author, "at": PAYLOADS[0]}
    return json.dumps({"author": by, "robot": PAYLOADS[0], "joints": PAYLOADS, "rows": rows})


@pytest.fixture(scope="module")
def page(files: Path) -> Iterator[Any]:
    """A page that shows the hostile robot after a click on its name."""
    state = {**os.environ, "XDG_STATE_HOME": str(files)}
    options = ("--poses", str(files / "poses.toml"))
    with (
        LocalNode() as node,
        hostile(node.local),
        console_for(node.local, *options, robot=None, env=state) as (url, _),
        chromium() as browser,
    ):
        page = new_page(browser)
        page.errors = []
        page.on("pageerror", lambda error: page.errors.append(str(error)))
        page.on("console", lambda said: page.errors.extend([said.text] * (said.type == "error")))
        page.on("dialog", lambda dialog: page.errors.append(f"a dialog: {dialog.message}"))
        page.add_init_script(WATCH)
        page.goto(url)
        page.get_by_role("heading", name="Choose a robot").wait_for()
        assert page.locator(".bar .title").inner_text() == ""
        page.locator(".robot .name", has_text=ROBOT).click()
        page.locator(".bar .title", has_text=ROBOT).wait_for()
        yield page


def hostile(connect: str) -> Any:
    """The hostile robot as a process."""
    process = subprocess.Popen(
        [sys.executable, "-m", "tools.attack.hostile_robot", connect], cwd=ROOT, stdout=subprocess.PIPE, text=True
    )
    assert process.stdout is not None
    assert process.stdout.readline() == "ready\n"
    return stopped(process)


@pytest.fixture(autouse=True)
def nothing_has_run(page: Any) -> Iterator[None]:
    """After each test: no text was a program, none would have been one without the policy, and no script has failed."""
    yield
    page.wait_for_timeout(1000)
    assert page.evaluate("window.PWNED") is None
    assert page.evaluate("window.VIOLATIONS") == []
    assert page.errors == []
    assert page.evaluate("document.querySelectorAll('img, iframe, object, svg[onload], style[onload]').length") == 0


def tab(page: Any, name: str) -> None:
    page.get_by_role("tab", name=name).click()
    page.locator(".tabs .chosen", has_text=name).wait_for()


def hover_all(page: Any, what: str, most: int = 40) -> None:
    """Shows the tooltips of these elements."""
    for element in page.locator(what).all()[:most]:
        if element.is_visible():
            element.hover()
            page.wait_for_timeout(50)


def choose_arm(page: Any) -> Any:
    """The panel Arm, with the arm whose joints have hostile names."""
    arm = page.locator("section.arm")
    arm.get_by_text("joints", exact=True).first.click()
    arm.locator(".q-select .q-field__control").click()
    page.get_by_role("option", name=re.compile(r"66\.1\.2$")).wait_for()
    page.get_by_role("option", name="66.1.1").first.click()
    arm.locator(".joint-value").nth(len(PAYLOADS) - 1).wait_for()
    return arm


def test_names_and_services_of_components(page: Any) -> None:
    for text in PAYLOADS:
        page.locator(".component-name").get_by_text(text, exact=True).first.wait_for(state="attached")
    for number in range(3, 3 + len(PAYLOADS)):
        page.locator(".component").filter(has=page.get_by_text(f"1.{number}", exact=True)).click()
    page.locator(".service").get_by_text(f"urn:{PAYLOADS[5]}".rpartition(":")[2]).first.wait_for()
    hover_all(page, ".service > div:first-child")
    hover_all(page, ".component-name")


def test_joints_and_poses_of_the_arm(page: Any) -> None:
    arm = choose_arm(page)
    labels = arm.locator(".joint-wanted").evaluate_all(
        "all => all.map((each) => (each.querySelector('[aria-label]') ?? each).getAttribute('aria-label'))"
    )
    assert labels == list(PAYLOADS)
    hover_all(page, ".arm .joint")
    arm.get_by_text("tool", exact=True).first.click()
    arm.get_by_text("poses", exact=True).click()
    arm.get_by_role("button", name="go to given").wait_for()
    labels = arm.get_by_role("button").evaluate_all("all => all.map((each) => each.getAttribute('aria-label'))")
    shown = {text.removeprefix("go to ") for text in labels if text and text.startswith("go to ")}
    assert shown == {"given", "constructor", "__proto__"}, "the other texts are not names of poses"
    hover_all(page, ".arm .poses .grow")
    for button in arm.get_by_role("button", name=re.compile("^go to ")).all()[:3]:
        button.click()
    page.locator(".arm .problem").first.wait_for(state="attached")
    arm.get_by_text("joints", exact=True).first.click()


def test_poses_that_the_robot_knows(page: Any) -> None:
    arm = page.locator("section.arm")
    arm.locator(".q-select .q-field__control").click()
    page.get_by_role("option", name=f"66.1.{3 + len(PAYLOADS)}").first.click()
    arm.get_by_text("poses", exact=True).click()
    arm.get_by_role("button", name=f"all to {printable(UNPRINTABLE[-1])}", exact=True).wait_for()
    labels = arm.get_by_role("button").evaluate_all("all => all.map((each) => each.getAttribute('aria-label'))")
    shown = [text.removeprefix("go to ") for text in labels if text and text.startswith("go to ")]
    assert [text for text in shown if text in PAYLOADS] == list(PAYLOADS)
    assert shown[-2:] == [r"\x1b[2Jcleared", r"two\nlines"]
    hover_all(page, ".arm .poses .grow")
    arm.get_by_role("button", name=re.compile("^go to ")).nth(5).click()
    arm.get_by_role("button", name=re.compile("^all to ")).nth(6).click()
    page.locator(".arm .problem").first.wait_for(state="attached")
    arm.get_by_text("joints", exact=True).first.click()


def test_trajectories(page: Any) -> None:
    tab(page, "Trajectory")
    panel = page.locator(".trajectory")
    for number, text in enumerate(IN_FILES):
        panel.locator(".q-select").nth(1).click()
        page.get_by_role("option", name=f"plain {number}", exact=True).click()
        panel.get_by_text(f"saved by {printable(text)}, {printable(PAYLOADS[0])}", exact=True).wait_for()
    upload = {"name": "\u2028<img src=x onerror=window.PWNED=1>.json", "mimeType": "application/json"}
    panel.locator("input[type=file]").set_input_files({**upload, "buffer": b'{"joints": "<img src=x>"}'})
    page.locator(".trajectory .problem").get_by_text("<img").first.wait_for()
    panel.locator("input[type=file]").set_input_files({**upload, "buffer": trajectory(IN_FILES[0]).encode()})
    page.locator(".trajectory .line").nth(2).wait_for()
    labels = panel.locator("[aria-label]").evaluate_all("all => all.map((each) => each.getAttribute('aria-label'))")
    assert {f"{text} of row 1" for text in PAYLOADS} <= set(labels)
    hover_all(page, ".trajectory .head .joint")
    panel.get_by_role("button", name="play", exact=True).click(force=True)
    with page.expect_download():
        panel.get_by_role("button", name="export as Python").click()


def test_the_names_of_cameras(page: Any) -> None:
    tab(page, "Video")
    page.locator("figcaption").get_by_text(PAYLOADS[0]).wait_for()
    page.get_by_role("button", name="settings").click()
    page.get_by_role("button", name="still").click()
    page.wait_for_timeout(1500)


def test_parts_and_frames_of_the_world(page: Any) -> None:
    tab(page, "World")
    page.wait_for_function("jauspy.world.model?.joints.length > 5 || jauspy.world.model?.shapes.length > 0")
    page.get_by_text("frames", exact=True).click()
    page.wait_for_timeout(1500)


def test_names_in_the_lists_of_plots(page: Any) -> None:
    tab(page, "Plots")
    panel = page.locator(".plots:visible")
    for number in (1, 3, 8):
        panel.locator(".q-select").nth(0).click()
        page.get_by_role("option", name=f"66.1.{number} ").first.click()
        panel.locator(".q-select").nth(1).click()
        page.get_by_role("option").first.wait_for()
        page.keyboard.press("Escape")
    panel.locator(".q-select").nth(0).click()
    page.get_by_role("option", name="66.1.1 ").first.click()
    panel.locator(".q-select").nth(1).click()
    page.get_by_role("option", name="ModularArmState").click()
    panel.locator(".q-select").nth(2).click()
    page.get_by_role("option").nth(1).click()
    page.get_by_role("option").nth(2).click()
    page.keyboard.press("Escape")
    panel.get_by_role("button", name="add", exact=True).click()
    page.locator(".trace").first.wait_for()
    page.wait_for_timeout(1500)
    page.locator(".chart").hover()
    page.wait_for_timeout(500)


def test_the_log_and_its_messages(page: Any) -> None:
    choose_arm(page)
    tab(page, "World")
    tab(page, "Log")
    page.get_by_text("routine", exact=True).click()
    for name in ("ReportModularArmState", "ReportServices", "ReportIdentification", "ReportPartObservations"):
        page.get_by_label("filter").fill(name)
        page.locator(".traffic tbody tr").filter(has_text=name).first.click()
        page.locator(".fields .value").first.wait_for()
    for text in (PAYLOADS[0], PAYLOADS[5]):
        page.get_by_label("filter").fill(text)
        page.wait_for_timeout(700)
    page.get_by_label("filter").fill("has appeared")
    page.locator(".traffic").get_by_text("has appeared").first.wait_for()


def test_the_events(page: Any) -> None:
    tab(page, "Plots")
    page.locator(".log .lines").get_by_text(f"robot 66 {PAYLOADS[0]} has appeared").wait_for()


INJECTED = """setTimeout(() => {
    const tries = [
        () => { mounted_app.elements[Object.keys(mounted_app.elements).at(-1)].props[":data-x"] = "window.PWNED = 1"; },
        () => runJavascript("window.PWNED = 1"),
        () => runJavascript("jauspy.say(window.PWNED = 1)"),
        () => runJavascript("return runMethod(window.PWNED = 1)"),
        () => new Function("window.PWNED = 1")(),
        () => setTimeout("window.PWNED = 1"),
        () => place.querySelector("a").click(),
        () => place.querySelector("button").click(),
        () => place.append(Object.assign(document.createElement("script"), {textContent: "window.PWNED = 1"})),
        () => place.append(Object.assign(document.createElement("script"), {src: "http://127.0.0.2:9/x.js"})),
        () => fetch("http://127.0.0.2:9/").catch(() => {}),
        () => { new Image().src = "http://127.0.0.2:9/x.png"; },
    ];
    const place = document.createElement("div");
    document.body.append(place);
    place.innerHTML = `<img src="x" onerror="window.PWNED = 1"><svg onload="window.PWNED = 1"></svg>
        <iframe srcdoc="<script>parent.PWNED = 1</` + `script>"></iframe><a href="javascript:window.PWNED = 1">x</a>
        <form action="http://127.0.0.2:9/"><button>x</button></form>`;
    for (const each of tries) try { each(); } catch { /* refused */ }
    window.TRIED = tries.length;
});"""


def test_what_the_policy_refuses(page: Any) -> None:
    """A text that becomes a property, a handler, a script, or an address after all is not run, loaded or sent."""
    page.evaluate(INJECTED)
    page.wait_for_timeout(1500)
    assert page.evaluate("window.TRIED") == INJECTED.count("() =>") - 1 - INJECTED.count("catch(() =>")
    assert page.evaluate("window.PWNED") is None
    found = page.evaluate("window.VIOLATIONS")
    for directive in ("script-src-attr", "form-action", "connect-src", "img-src", "require-trusted-types-for"):
        assert any(each.startswith(directive) for each in found), found
    page.reload()
    page.locator(".bar .title", has_text=ROBOT).wait_for()
    page.errors.clear()
