"""The full screen: what it shows of a capture and of a node manager that runs, and what its keys do."""

from __future__ import annotations

import asyncio
import time
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from pathlib import Path
from typing import Any

import pytest
from rich.text import Text
from textual.pilot import Pilot
from textual.widgets import DataTable, Input, Static, Tree
from typer.testing import CliRunner

from jauspy.capture.reader import Datagram
from jauspy.cli.definitions import definitions
from jauspy.cli.main import app as command
from jauspy.cli.monitor import sources, texts
from jauspy.cli.monitor.app import MonitorApp
from jauspy.cli.monitor.sources import CaptureSource, LiveSource
from jauspy.cli.monitor.verb import asking
from jauspy.component import Component
from jauspy.ids import JausID
from jauspy.inspection.timeline import Timeline
from jauspy.messages import registry
from jauspy.node import NodeConfig, NodeManager
from jauspy.protocol import judp
from jauspy.protocol.header import Packet
from jauspy.testing import until

OCU, ROBOT = JausID(42, 1, 1), JausID(101, 1, 102)
ADDRESSES = ("10.0.0.1", 3794), ("10.0.0.2", 3794)
SIZES = [(80, 24), (160, 50)]
HOSTILE = "[red]x[/]\x1b[31m\x85"
SHOWN = "[red]x[/]\\x1b[31m\\x85"


def said(time: float, source: JausID, to: JausID, name: str, number: int, fields: dict[str, Any]) -> Datagram:  # noqa: PLR0917
    data = judp.pack(Packet(source, to, registry.by_name(name).from_dict(fields).encode(), number))
    return Datagram(1, time, *ADDRESSES, data)


def timeline() -> Timeline:
    """A robot of a hostile name, controlled by an OCU; twenty poses within ten seconds."""
    identity = {"query_type": 4, "type": 60001, "identification": HOSTILE}
    found = [
        said(100.0, ROBOT, OCU, "ReportIdentification", 1, identity),
        said(100.1, OCU, ROBOT, "RequestControl", 1, {"authority_code": 200}),
        said(100.2, ROBOT, OCU, "ConfirmControl", 2, {"response_code": 0}),
        said(100.3, ROBOT, OCU, "ReportStatus", 3, {"status": "READY", "reserved": 0}),
    ]
    found += [said(100.5 + n / 2, ROBOT, OCU, "ReportLocalPose", 4 + n, {"x": float(n), "y": 1.0}) for n in range(20)]
    return Timeline(found, registry)


@asynccontextmanager
async def screen(size: tuple[int, int] = (80, 24)) -> AsyncIterator[tuple[MonitorApp, Pilot[None]]]:
    """The capture of `timeline`, with its robot chosen."""
    app = MonitorApp(CaptureSource(timeline()), registry, "run.pcap", None)
    async with app.run_test(size=size) as pilot:
        await pilot.pause()
        await pilot.press("end")  # of the capture
        await pilot.press(*["down"] * 5)
        await pilot.pause()
        yield app, pilot


def plain(app: MonitorApp, selector: str) -> str:
    return str(app.screen.query_one(selector, Static).content)


def shown_rows(app: MonitorApp) -> list[list[str]]:
    table: DataTable[Text] = app.query_one("#messages", DataTable)
    return [[cell.plain.strip() for cell in table.get_row_at(number)] for number in range(table.row_count)]


async def wait(pilot: Pilot[None], condition: Callable[[], bool]) -> None:
    """Until the screen shows it; the test's own time limit ends a wait in vain."""
    while not condition():
        pilot.app.update_screen()  # type: ignore[attr-defined]
        await pilot.pause(0.01)


def visible(app: MonitorApp) -> list[str]:
    """The lines of the screen as they are drawn."""
    return ["".join(segment.text for segment in strip) for strip in app.screen._compositor.render_strips()]


@pytest.mark.slow
@pytest.mark.parametrize("size", SIZES)
async def test_what_is_known_is_shown_at_both_sizes(size: tuple[int, int]) -> None:
    async with screen(size) as (app, _):
        about = plain(app, "#about")
        assert SHOWN in about
        assert "state READY 9.7 s ago" in about
        assert "control 42.1.1 authority 200" in about
        assert "services unknown" in about
        rows = {row[0]: row for row in shown_rows(app)}
        assert rows["ReportLocalPose"][1:4] == ["→ 42.1.1", "20", "2.0"]
        assert len(next(iter(rows.values()))) == (5 if size == (80, 24) else 7)
        lines = visible(app)
        assert {len(line) for line in lines} == {size[0]}
        assert "run.pcap" in lines[0]
        assert any("●" in line and "1x" in line for line in lines)
        assert "Quit" in lines[-1]
        assert all(line.isprintable() for line in lines)


@pytest.mark.slow
async def test_names_of_peers_are_no_markup() -> None:
    async with screen() as (app, _):
        tree: Tree[str] = app.query_one("#tree", Tree)
        labels = [str(node.label) for node in tree.root.children[1].children[0].children]
        assert labels == [f"● 102 {SHOWN} ◂ 42.1.1"]


@pytest.mark.slow
async def test_keys_move_in_time() -> None:
    async with screen() as (app, pilot):
        source = app.source
        assert isinstance(source, CaptureSource)
        await pilot.press("shift+left", "right", "left", "left")
        assert source.position == 100.0
        await wait(pilot, lambda: source.now == 100.0)
        assert "control unknown" in plain(app, "#about")
        assert "+0.0 s" in plain(app, "#slider")
        await pilot.press("right", "plus", "plus", "minus")
        assert (source.position, source.speed) == (101.0, 2.0)
        await pilot.press("space")
        assert source.playing
        await wait(pilot, lambda: source.position > 101.0)
        await pilot.press("space")
        assert not source.playing
        await pilot.press("home")
        assert source.position == 100.0


def test_playing_ends_at_the_end_and_begins_again() -> None:
    source = CaptureSource(timeline())
    source.move(105.0)
    source.play()
    source.change_speed(1)
    source.advance(1.0)
    assert source.position == 107.0
    source.advance(100.0)
    assert (source.position, source.playing) == (110.0, False)
    source.play()
    assert (source.position, source.playing) == (100.0, True)


@pytest.mark.slow
async def test_a_filter_is_typed() -> None:
    async with screen() as (app, pilot):
        await pilot.press("slash")
        app.screen.query_one(Input).value = "x >"
        await pilot.press("enter")
        await wait(pilot, lambda: "wrong at character" in plain(app, "#answer"))
        app.screen.query_one(Input).value = ""
        await pilot.press(*"x", "space", ">", "space", "1", "7")
        assert app.screen.query_one(Input).value == "x > 17"  # the keys are not those of the main screen
        await pilot.press("enter")
        await wait(pilot, lambda: len(app.screen_stack) == 1 and len(app.observed.streams) == 1)
        await wait(pilot, lambda: [row[:3] for row in shown_rows(app)] == [["ReportLocalPose", "→ 42.1.1", "2"]])
        assert "/ x > 17" in plain(app, "#head")
        assert "READY" in plain(app, "#about")


async def choose(app: MonitorApp, pilot: Pilot[None], message: str) -> None:
    """Go to a row of the table."""
    await pilot.press("tab")
    app.query_one("#messages", DataTable).move_cursor(row=[row[0] for row in shown_rows(app)].index(message))
    await pilot.pause()


@pytest.mark.slow
async def test_a_message_is_opened() -> None:
    async with screen() as (app, pilot):
        await choose(app, pilot, "ReportLocalPose")
        assert "x: 19 m" in plain(app, "#fields")
        await pilot.press("enter")
        text = str(app.screen.query_one(".dialog Static", Static).content)
        assert "101.1.102 → 42.1.1" in text
        assert "0000  03 44" in text
        await pilot.press("escape", "i")
        assert SHOWN in str(app.screen.query_one(".dialog Static", Static).content)
        await pilot.press("escape", "question_mark")
        assert "inferred" in str(app.screen.query_one(".dialog Static", Static).content)


@pytest.mark.slow
@pytest.mark.parametrize("size", SIZES)
async def test_a_field_is_plotted(size: tuple[int, int]) -> None:
    async with screen(size) as (app, pilot):
        await choose(app, pilot, "ReportLocalPose")
        await pilot.press("p", "enter")
        await wait(pilot, lambda: app.source.series is not None)
        series = app.source.series
        assert series is not None
        assert (series.path, len(series.points)) == ("x", 20)
        await wait(pilot, lambda: app.query_one("#plot").content_size.width > 0)
        await wait(pilot, lambda: plain(app, "#plot").startswith("x"))
        assert "▲" in plain(app, "#plot")
        await pilot.press("p")
        await wait(pilot, lambda: app.source.series is None)


@pytest.mark.slow
async def test_messages_are_sorted() -> None:
    async with screen() as (app, pilot):
        await pilot.press("s")
        assert shown_rows(app)[0][0] == "ReportLocalPose"
        await pilot.press("s", "s", "s")
        assert [row[0] for row in shown_rows(app)] == sorted(row[0] for row in shown_rows(app))


@pytest.mark.slow
async def test_the_chosen_message_stays_chosen_when_rows_move() -> None:
    async with screen() as (app, pilot):
        await choose(app, pilot, "ReportStatus")
        for _ in range(4):
            await pilot.press("s")
            await pilot.pause()
            assert app._route is not None
            assert app._route.message == "ReportStatus"
            table: DataTable[Text] = app.query_one("#messages", DataTable)
            assert shown_rows(app)[table.cursor_row][0] == "ReportStatus"


@pytest.mark.slow
async def test_components_come_in_order_and_do_not_move_what_is_chosen() -> None:
    async with screen() as (app, pilot):
        tree: Tree[str] = app.query_one("#tree", Tree)
        source = app.source
        assert isinstance(source, CaptureSource)
        source.ids += [JausID(7, 1, 1), JausID(101, 1, 9), JausID(101, 1, 200)]
        app.update_screen()
        await pilot.pause()
        assert [node.data for node in tree.root.children] == ["7", "42", "101"]
        leaves = [node.data for node in tree.root.children[2].children[0].children]
        assert leaves == ["101.1.9", "101.1.102", "101.1.200"]
        assert tree.cursor_node is not None
        assert tree.cursor_node.data == "101.1.102"


@pytest.mark.slow
async def test_a_capture_has_no_queries() -> None:
    async with screen() as (app, pilot):
        await pilot.press("a")
        assert len(app.screen_stack) == 1


@pytest.fixture
async def node(tmp_path: Path) -> AsyncIterator[NodeManager]:
    manager = NodeManager(NodeConfig(port=0, address="127.0.0.1", local_root=tmp_path))
    await manager.open()
    try:
        yield manager
    finally:
        await manager.close()


@pytest.mark.slow
async def test_a_running_node_manager(node: NodeManager, tmp_path: Path) -> None:
    """A query is asked, seen, and its answer tells the state; standing still hides what comes."""
    source = await asyncio.to_thread(LiveSource, tmp_path, registry)
    try:
        await until(lambda: bool(node._mirrors))
        async with Component(ROBOT, [], connect=f"local:{tmp_path}"):
            app = MonitorApp(source, registry, "live", asking(tmp_path, None, definitions(None)))
            async with app.run_test(size=(80, 24)) as pilot:
                answer = await asking(tmp_path, None, definitions(None))(ROBOT, "QueryStatus")
                assert answer.plain.startswith("ReportStatus\nstatus: STANDBY (2)\n")
                await wait(
                    pilot, lambda: ROBOT in app.observed.components and app.observed.components[ROBOT].state is not None
                )
                await pilot.press("end")
                await wait(pilot, lambda: plain(app, "#about").startswith("101.1.102"))
                await pilot.press("space", "a", "enter")
                await wait(pilot, lambda: "ReportStatus" in plain(app, "#answer"))
                await pilot.press("escape")
                assert "PAUSED" in plain(app, "#head")
                before = app.observed.count
                await wait(pilot, lambda: source._all.count > before)
                assert app.observed.count == before
                await pilot.press("space")
                assert app.observed.count > before
    finally:
        await asyncio.to_thread(source.close)


async def test_what_cannot_be_asked() -> None:
    ask = asking(Path("/nonexistent"), None, definitions(None))
    for line, reason in (("SetEmergency", "is not a query"), ("QueryStatuss", "QueryStatus"), ("'", "quotation")):
        assert reason in (await ask(ROBOT, line)).plain


async def test_messages_that_the_screen_is_too_slow_for_are_counted(
    node: NodeManager, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(sources, "MAX_WAITING", 5)
    source = await asyncio.to_thread(LiveSource, tmp_path, registry)
    try:
        await until(lambda: bool(node._mirrors))
        where = f"local:{tmp_path}"
        async with Component(OCU, [], connect=where) as component, Component(ROBOT, [], connect=where):
            for _ in range(20):
                component.send(ROBOT, registry.by_name("QueryStatus")())
            await until(lambda: source.dropped > 0)
        source.poll()
        assert source.observed.count == 5
        assert source.lost == source.dropped
    finally:
        await asyncio.to_thread(source.close)


def test_without_a_terminal_it_says_what_prints(tmp_path: Path) -> None:
    result = CliRunner().invoke(command, ["monitor", str(tmp_path / "run.pcap")])
    assert result.exit_code == 1
    assert "needs a terminal" in result.output


def test_short_forms() -> None:
    assert [texts.age(seconds) for seconds in (-1.0, 0.25, 60.0, 600.0, 7200.0, 1e6)] == [
        "0.0 s", "0.2 s", "60 s", "10 min", "2 h", "12 d",
    ]  # fmt: skip
    assert [texts.amount(number) for number in (0, 9999, 12_345, 4.5e6, 1e13)] == [
        "0",
        "9999",
        "12.3k",
        "4.5M",
        ">999G",
    ]
    assert texts.clock(1e30) == "1000000000000000019884624838656.0"
    assert texts.clock(time.time()).count(":") == 2
    assert texts.bars([0, 1, 8]) == " ▁█"


@pytest.mark.slow
async def test_what_is_known_of_an_implementation_is_said_of_its_components_and_subsystem() -> None:
    priority_0 = bytes.fromhex("02001200ff0101650009016400000102030100")  # of the JAUS Toolset, 100.1.9 to 101.1.1
    other = said(100.5, ROBOT, OCU, "QueryHeartbeatPulse", 1, {})._replace(source=("10.0.0.7", 3794))
    found = [Datagram(1, 100.0, *ADDRESSES, priority_0), other]
    app = MonitorApp(CaptureSource(Timeline(found, registry)), registry, "run.pcap", None)
    async with app.run_test(size=(160, 50)) as pilot:
        await pilot.press("end")
        ids = [str(id) for id in app.source.ids]
        for scope in ("100", "100.1", "100.1.9"):
            app._scope = scope
            app.update_screen()
            assert "10.0.0.1 looks like JTS: a control byte of FF" in plain(app, "#about"), ids
        app._scope = "100.1.9"
        app.action_about()
        await pilot.pause()
        page = str(app.screen.query_one("TextDialog Static", Static).content)
        assert "known of JTS" in page
        assert "priority 0 is sent with a control byte of FF (J7)" in page
        await pilot.press("escape")
        app._scope = str(ROBOT)
        app.update_screen()
        assert "looks like" not in plain(app, "#about")
