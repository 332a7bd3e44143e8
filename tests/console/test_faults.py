"""What goes wrong while somebody drives in a real browser: the robot stands soon, by the clocks of those involved."""

from __future__ import annotations

import asyncio
import re
import threading
import time
from collections import deque
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any
from urllib.parse import urlsplit

import pytest
from tests.helpers.browser import BROWSER_MARKS, WAIT, chromium, console_for, new_page, sync_api
from tests.helpers.command_line import shared_robot

import jauspy
from jauspy.codec.message import Message
from jauspy.component import ComponentOptions
from jauspy.errors import CodecError
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import QueryStatus, ReleaseControl, SetEmergency, Standby
from jauspy.messages.mobility import SetVelocityCommand, SetWrenchEffort
from jauspy.ocu import OCU
from jauspy.platform.contract import Robot
from jauspy.robot import robot_files
from jauspy.robot.realtime import RealTime
from jauspy.robot.runner import RobotRunner
from jauspy.schema import builtin_paths, load_files
from jauspy.services.service import Service
from jauspy.testing import LocalNode

pytestmark = BROWSER_MARKS
STOP_TIME = 0.2
"""Seconds of the robot's time in which it stands after a message that stops it at once."""
MAX_STATUS_QUERIES = 1
"""Periodic queries of the console, from the last message that moves the robot to the first that stops it.

The console stops a robot after 0.2 s of silence and queries its status at most twice a second, both by its own clock,
so that the number does not depend on how busy the machine is.
"""
MIN_QUERIES_OF_SILENCE = 8
"""Periodic queries of the console in the 8 s that a silent page has: one each 0.5 s, and 0.5 s for its answer."""
STANDS = 0.02
"""m/s."""
DRIVER = JausID(101, 1, 102)
LAMP = Path(__file__).parents[1] / "vendor" / "Lamp.xml"


class Background:
    """Coroutines on an event loop in a thread, beside playwright's."""

    def __init__(self) -> None:
        self.loop = asyncio.new_event_loop()
        self._thread = threading.Thread(target=self.loop.run_forever)
        self._thread.start()

    def run(self, work: Any) -> Any:
        return asyncio.run_coroutine_threadsafe(work, self.loop).result(60)

    def close(self) -> None:
        self.run(self._cancel_all())
        self.loop.call_soon_threadsafe(self.loop.stop)
        self._thread.join()
        self.loop.close()

    async def _cancel_all(self) -> None:
        tasks = asyncio.all_tasks() - {asyncio.current_task()}
        for each in tasks:
            each.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)


class RecordingRealTime(RealTime):
    """Notes the robot's time and its speed after each step."""

    def __init__(self, robot: Robot) -> None:
        self.samples: deque[tuple[float, float]] = deque(maxlen=100_000)
        super().__init__(robot)

    def _advance(self) -> None:
        super()._advance()
        snapshot = self.snapshot
        self.samples.append((snapshot.time, snapshot.twist.vx))


@dataclass(frozen=True)
class Received:
    """A message that the driver of the robot received, with the robot's time."""

    time: float
    source: JausID
    message: Message

    @property
    def moves(self) -> bool:
        """True for a command to drive."""
        return isinstance(self.message, SetVelocityCommand) and bool(self.message.velocity_x)

    @property
    def stops(self) -> bool:
        """True for a message after which the robot slows down."""
        return self.stops_at_once or (isinstance(self.message, SetVelocityCommand) and not self.moves)

    @property
    def stops_at_once(self) -> bool:
        """True for a message after which the robot brakes with all its force."""
        if isinstance(self.message, SetWrenchEffort):
            return not self.message.propulsive_linear_effort_x
        return isinstance(self.message, Standby | SetEmergency | ReleaseControl)


class WatchedRobot:
    """A robot beside the test, which sees what its driver receives and how it moves, on the robot's own clock.

    So a machine that is slow, or busy with other things, changes nothing: the robot's time stands when it does.
    """

    def __init__(self, background: Background) -> None:
        self._background = background
        self._node = LocalNode()
        self._node.start()
        self.local = self._node.local
        self._received: list[Received] = []
        self._runner = RobotRunner(
            robot_files.load("inc1"), self._node.transport, backend="kinematic", realtime=self._in_real_time
        )
        background.run(self._runner.open())
        (driver,) = (each for each in self._runner.components if each.id == DRIVER)
        receive = driver.host.receive

        def noting(payload: bytes, source: JausID, now: float) -> None:
            with suppress(CodecError):
                self._received.append(Received(self._realtime.snapshot.time, source, registry.decode(payload)))
            receive(payload, source, now)

        driver.host.receive = noting

    def close(self) -> None:
        self._background.run(self._runner.close())
        self._node.stop()

    def _in_real_time(self, robot: Robot) -> RealTime:
        self._realtime = RecordingRealTime(robot)
        return self._realtime

    def moves(self) -> bool:
        """True if it has driven for the last 0.2 s of its time."""
        speeds = self._last_speeds()
        return len(speeds) == 100 and min(speeds) > 0.3

    def stands(self) -> bool:
        """True if it has stood for the last 0.2 s of its time."""
        speeds = self._last_speeds()
        return len(speeds) == 100 and max(speeds) < STANDS

    def _last_speeds(self) -> list[float]:
        return [abs(speed) for _, speed in list(self._realtime.samples.copy())[-100:]]

    def wait_until_it_moves(self) -> None:
        _wait_until(self.moves, "the robot does not move")

    def wait_until_it_stands(self) -> None:
        _wait_until(self.stands, "the robot does not stand")

    def assert_stopped(self, *kinds: type[Message]) -> None:
        """Stopped by its console, soon after the last message that moved it; by a message of these kinds, if given."""

        def is_stopped() -> bool:  # at one moment: a busy console may stop it, drive on, and stop it for good
            return any(each.stops_at_once for each in self._after_last_command()) and self.stands()

        _wait_until(is_stopped, "nothing stops the robot")
        last, *after = self._after_last_command()
        before = after[: next(index for index, each in enumerate(after) if each.stops)]
        queries = [each for each in before if each.source == last.source and isinstance(each.message, QueryStatus)]
        assert len(queries) <= MAX_STATUS_QUERIES
        stop = next(each for each in after if each.stops_at_once)
        assert (stop.source.subsystem, stop.source.node) == (last.source.subsystem, last.source.node), "its console"
        assert isinstance(stop.message, kinds or Message)
        moved = [at for at, speed in self._realtime.samples.copy() if abs(speed) >= STANDS]
        assert moved[-1] >= last.time, "it moved until it was stopped"
        assert moved[-1] - stop.time <= STOP_TIME

    def assert_released_at_once(self) -> None:
        """Released by its console, long before a page that is silent counts as closed."""

        def releases() -> list[int]:
            after = self._after_last_command()
            return [index for index, each in enumerate(after) if isinstance(each.message, ReleaseControl)]

        _wait_until(lambda: bool(releases()), "nothing releases the robot")
        last, *after = self._after_last_command()
        before = after[: releases()[0] - 1]
        queries = [each for each in before if each.source == last.source and isinstance(each.message, QueryStatus)]
        assert len(queries) < MIN_QUERIES_OF_SILENCE

    def has_received(self, kind: type[Message]) -> bool:
        """True if a message of this kind has come since the last command."""
        return any(isinstance(each.message, kind) for each in self._after_last_command())

    def _after_last_command(self) -> list[Received]:
        """The last command to drive, and what came after it."""
        received = list(self._received)
        return received[max(index for index, each in enumerate(received) if each.moves) :]


def _wait_until(condition: Callable[[], bool], problem: str) -> None:
    end = time.monotonic() + WAIT / 1000
    while not condition():
        if time.monotonic() > end:
            pytest.fail(problem)
        time.sleep(0.05)


@pytest.fixture(scope="module")
def background() -> Iterator[Background]:
    made = Background()
    yield made
    made.close()


@pytest.fixture(scope="module")
def robot(background: Background) -> Iterator[WatchedRobot]:
    watched = WatchedRobot(background)
    yield watched
    watched.close()


@pytest.fixture(scope="module")
def url(robot: WatchedRobot) -> Iterator[str]:
    with console_for(robot.local) as (address, _):
        yield address


@pytest.fixture
def browser() -> Iterator[Any]:
    """The browser of all tests; pages of a test that fails do not drive on during the next one."""
    with chromium() as launched:
        yield launched


@pytest.fixture
def page(browser: Any) -> Iterator[Any]:
    opened = new_page(browser)
    yield opened
    opened.close()


def take(page: Any, key: str = "") -> None:
    """Take control, again when it is refused: on a busy machine a component may not be Ready in time.

    With a click on its button, or with this key, if the focus is on the button.
    """
    operates = page.get_by_text("you operate this robot")
    button = page.get_by_role("button", name=re.compile("^take( over)?$"))
    operates.or_(button).first.wait_for()
    press = partial(page.keyboard.press, key) if key else partial(button.click, timeout=1_000)

    def is_taken() -> bool:
        if operates.is_visible():
            return True
        with suppress(sync_api.TimeoutError):
            press()  # a button that is away has granted control meanwhile
            operates.wait_for(timeout=5_000)
        return bool(operates.is_visible())

    _wait_until(is_taken, "control is not granted")


def clear_emergency(page: Any) -> None:
    """Clear it, again until all components have answered in time."""
    cleared = page.locator("#stop-answer", has_text=re.compile(r"^(\d+) of \1 components released"))

    def is_cleared() -> bool:
        page.get_by_role("button", name="clear emergency").click()
        with suppress(sync_api.TimeoutError):
            cleared.wait_for(timeout=5_000)
        return bool(cleared.is_visible())

    _wait_until(is_cleared, "the emergency is not cleared")


def drive(page: Any, url: str, robot: WatchedRobot) -> None:
    """Take control, and hold a key until the robot moves."""
    page.goto(url)
    page.get_by_text("101 inc1").first.wait_for()
    take(page)
    page.keyboard.down("KeyW")
    robot.wait_until_it_moves()


def note_what_is_sent_after(page: Any, event: str) -> None:
    """Have the page keep what it sends once this event has come to it, and in the handler of which event."""
    page.evaluate(
        f"""() => {{
            const send = WebSocket.prototype.send;
            WebSocket.prototype.send = function (data) {{
                if (/^\\[|^stop/.test(data)) {{ // NiceGUI's begin with a digit
                    window.sentAfter?.push(data);
                    window.sentDuring?.push(window.event?.type ?? "another task");
                }}
                return send.call(this, data);
            }};
            addEventListener('{event}', () => {{
                window.sentAfter ??= [];
                window.sentDuring ??= [];
            }}, true);
        }}"""
    )


def sent_after(page: Any) -> list[str]:
    """What the page has sent for the robot."""
    page.wait_for_function("window.sentAfter?.length")
    sent: list[str] = page.evaluate("window.sentAfter")
    return sent


@pytest.mark.parametrize("event", ["keyup", "blur"])
def test_the_robot_stands_when_the_key_is_up_or_the_focus_is_lost(
    page: Any, url: str, robot: WatchedRobot, event: str
) -> None:
    drive(page, url, robot)
    note_what_is_sent_after(page, event)
    if event == "blur":
        page.evaluate("window.sentAfter = []; window.sentDuring = []; window.dispatchEvent(new Event('blur'))")
    else:
        page.keyboard.up("KeyW")
    robot.assert_stopped(SetWrenchEffort)
    assert set(sent_after(page)) == {"[0,0]"}
    assert set(page.evaluate("sentDuring")) == {event}


def test_the_robot_stands_when_the_tab_is_closed(browser: Any, url: str, robot: WatchedRobot) -> None:
    tab = new_page(browser)
    drive(tab, url, robot)
    tab.close()
    robot.assert_stopped()


def test_a_page_that_is_closed_releases_the_robot_at_once(browser: Any, url: str, robot: WatchedRobot) -> None:
    tab, other = new_page(browser), new_page(browser)
    drive(tab, url, robot)
    other.goto(url)
    other.get_by_text("another browser operates it").or_(other.get_by_text("observing", exact=True)).first.wait_for()
    take(tab)  # a busy machine may have lost control meanwhile
    other.get_by_text("another browser operates it").wait_for()
    tab.close()
    robot.assert_released_at_once()
    other.get_by_text("observing", exact=True).wait_for()
    other.close()


class Proxy:
    """A network between browser and console, which can be cut: nothing passes, and nobody is told."""

    def __init__(self, port: int) -> None:
        self._port = port
        self._passes = asyncio.Event()
        self._passes.set()
        self._writers: list[asyncio.StreamWriter] = []

    async def open(self) -> int:
        self._server = await asyncio.start_server(self._serve, "127.0.0.1", 0)
        return int(self._server.sockets[0].getsockname()[1])

    async def cut(self) -> None:
        self._passes.clear()

    async def close(self) -> None:
        self._server.close()
        self._passes.set()
        for writer in self._writers:
            writer.transport.abort()
        await asyncio.sleep(0)

    async def _serve(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        there, back = await asyncio.open_connection("127.0.0.1", self._port)
        self._writers += [writer, back]
        await asyncio.gather(self._pump(reader, back), self._pump(there, writer))

    async def _pump(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        try:
            while data := await reader.read(1 << 16):
                await self._passes.wait()
                writer.write(data)
                await writer.drain()
        except ConnectionError:
            pass
        finally:
            writer.close()


def test_the_robot_stands_when_the_network_is_away(
    browser: Any, url: str, robot: WatchedRobot, background: Background
) -> None:
    parts = urlsplit(url)
    assert parts.port is not None
    proxy = Proxy(parts.port)
    port = background.run(proxy.open())
    page = new_page(browser)
    try:
        drive(page, parts._replace(netloc=f"127.0.0.1:{port}").geturl(), robot)
        background.run(proxy.cut())
        robot.assert_stopped(SetWrenchEffort)
        page.keyboard.press("Escape")
        page.get_by_text("NOT CONFIRMED: the console does not answer").wait_for()
    finally:
        background.run(proxy.close())
        page.close()


FLOOD = """() => {
    setInterval(() => {
        for (let i = 0; i < 200; i++) document.querySelector('.centre').append(document.createElement('p'));
        const end = performance.now() + 100; while (performance.now() < end);
    }, 120);
}"""
"""Keeps a page busy with tasks of 100 ms."""


def test_the_robot_stands_soon_after_the_emergency_stop_while_the_page_is_flooded(
    browser: Any, url: str, robot: WatchedRobot, background: Background
) -> None:
    async def flood() -> None:
        async with OCU("42.7.9", robot.local) as ocu:
            while True:
                for _ in range(5):
                    await ocu.send("101.1.102", QueryStatus())
                await asyncio.sleep(0.01)

    async def begin() -> asyncio.Task[None]:
        return asyncio.create_task(flood())

    page = new_page(browser)
    drive(page, url, robot)
    page.get_by_role("tab", name="Log").click()
    page.get_by_text("routine", exact=True).click()
    flooding = background.run(begin())
    try:
        note_what_is_sent_after(page, "keydown")
        page.evaluate(FLOOD)
        page.keyboard.press("Escape")
        robot.assert_stopped(SetWrenchEffort, SetEmergency)
    finally:
        background.loop.call_soon_threadsafe(flooding.cancel)
    assert sent_after(page)[:2] == ["[0,0]", "stop all"]
    assert page.evaluate("sentDuring")[:2] == ["keydown", "keydown"], "in the first task after the key"
    _wait_until(lambda: robot.has_received(SetEmergency), "no emergency stop comes")
    page.locator("#stop-answer", has_text=re.compile("components stopped|no component answered")).wait_for()
    clear_emergency(page)
    page.close()


def test_the_robot_stands_when_the_server_is_killed(browser: Any, robot: WatchedRobot) -> None:
    page = new_page(browser)
    with console_for(robot.local) as (address, process):
        drive(page, address, robot)
        process.kill()
        robot.assert_stopped(Standby)
    page.keyboard.press("Escape")
    page.get_by_text("NOT STOPPED: no connection to the console").wait_for()
    page.close()


def test_a_robot_that_is_killed_is_reported_and_found_again(page: Any) -> None:
    with shared_robot(few_pictures=True) as doomed, console_for(doomed.local) as (address, _):
        page.goto(address)
        take(page)
        doomed.process.kill()
        page.locator(".alarm-text", has_text="robot 101 inc1 does not answer any more").wait_for()
        page.get_by_text("Looking for robots").wait_for()
        page.get_by_text("jauspy up inc1").wait_for()


def test_a_robot_of_a_vendor_shows_what_it_offers_and_nothing_else(page: Any, background: Background) -> None:
    own = jauspy.load(LAMP)

    class Lamp(Service, urn="urn:example:vendor:Lamp"):
        def set_lamp(self, msg: Any) -> None:
            """The test sets none."""

        def report_lamp(self) -> Any:
            return own.by_name("ReportLamp")(10)

    async def serve(connect: str) -> jauspy.Component:
        options = ComponentOptions(schema=load_files([LAMP, *builtin_paths()]), registry=own)
        component = jauspy.Component(
            "55.1.1", [Lamp()], name="lamp <b>of</b> a vendor", connect=connect, options=options
        )
        await component.open()
        return component

    with LocalNode() as node, console_for(node.local, robot=55) as (address, _):
        component = background.run(serve(node.local))
        try:
            page.goto(address)
            page.locator(".component", has_text="lamp <b>of</b> a vendor").click()
            page.locator(".service").get_by_text("Lamp", exact=True).wait_for()
            page.locator(".tabs .chosen", has_text="Plots").wait_for()
            page.get_by_role("tab", name="Video").click()
            page.get_by_text("this robot has no camera").wait_for()
            assert not page.locator("#stick").is_visible()
            assert not page.get_by_text("Arm", exact=True).is_visible()
        finally:
            background.run(component.close())


UNNAMED = """() => {
    const text = (each) => each?.innerText?.trim() || '';
    const named = (each) => each.getAttribute('aria-label') || each.title || text(each)
        || [...(each.labels ?? []), each.closest('label')].map(text).join('')
        || text(document.getElementById(each.getAttribute('aria-labelledby')));
    const all = document.querySelectorAll(
        'button, a[href], input, select, textarea, [tabindex="0"], [role="slider"], [role="img"]');
    return [...all].filter((each) => each.checkVisibility() && !each.closest('[aria-hidden="true"]') && !named(each))
        .map((each) => each.outerHTML.slice(0, 200));
}"""


def test_the_keyboard_alone(page: Any, url: str, robot: WatchedRobot) -> None:
    page.goto(url)
    page.get_by_text("101 inc1").first.wait_for()
    page.get_by_role("button", name=re.compile("^take( over)?$")).wait_for()
    _wait_until(lambda: page.evaluate(UNNAMED) == [], f"without a name: {page.evaluate(UNNAMED)}")

    seen: list[str] = []
    for _ in range(60):
        page.keyboard.press("Tab")
        name, outline = page.evaluate(
            "() => { const at = document.activeElement; const style = getComputedStyle(at);"
            " const ring = getComputedStyle(at.closest('.q-field') ?? at);"
            " return [(at.getAttribute('aria-label') || at.innerText || at.tagName).trim().split('\\n')[0],"
            " style.outlineStyle !== 'none' || ring.outlineStyle !== 'none'"
            " || style.boxShadow !== 'none' || at === document.body]; }"
        )
        seen.append(name)
        assert outline, f"the focus on {name!r} is visible"
        if name in ("take", "take over"):
            break
    assert [each for each in ("STOP ALL", "Video", "Plots", "Log") if not any(each in name for name in seen)] == []
    take(page, "Enter")
    page.keyboard.down("ArrowUp")
    robot.wait_until_it_moves()
    page.keyboard.up("ArrowUp")
    robot.wait_until_it_stands()
