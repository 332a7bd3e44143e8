"""The page's socket: packets and values that its elements cannot send are dropped before NiceGUI parses them."""

from __future__ import annotations

import asyncio
import json
import random
import signal
import subprocess
from types import SimpleNamespace
from typing import Any

import psutil
import pytest
from tests.helpers.command_line import robot_in_thread, start, stopped

pytest.importorskip("nicegui", reason="needs the extra 'console'")

from nicegui import Client, ui
from nicegui.page import page as make_page
from tests.helpers.console_visit import Visit, visit
from tests.helpers.nicegui_page import Loaded, PageSocket, load

from jauspy.console.browser_messages import MAX_INVALID
from jauspy.console.page_events import ENDING, MAX_EVENTS_AT_ONCE, NAME, PageEvents, can_have
from jauspy.console.users import Session, User, current

ANNA, BEN = User("anna", "operator", 127), User("ben", "observer", 0)


class Server:
    """What `PageEvents` uses of Socket.IO's server."""

    def __init__(self) -> None:
        self.passed: list[Any] = []
        self.environ: dict[str, dict[str, Any]] = {
            connection: {"asgi.scope": {ENDING: asyncio.Event()}} for connection in ("one", "two")
        }
        self.eio = SimpleNamespace(handlers={"message": self._pass})

    async def _pass(self, connection: str, data: Any) -> None:
        self.passed.append(data)

    @property
    def ended(self) -> list[str]:
        """The connections that end with their next frame."""
        return [name for name, environ in self.environ.items() if environ["asgi.scope"][ENDING].is_set()]


class Bench:
    """A page of anna with a slider, and what was refused."""

    def __init__(self) -> None:
        self.server, self.refused, self.now = Server(), list[tuple[str, str]](), 0.0
        self.events = PageEvents(self.server, lambda *what: self.refused.append(what), lambda: self.now)
        self.client = Client(make_page(""), request=None)
        with self.client:
            self.slider = ui.slider(min=0.1, max=1.5, value=0.5)
        self.events.add(self.client, ANNA)

    async def send(self, data: Any, connection: str = "one", user: User = ANNA) -> bool:
        """True if the packet was passed on."""
        current.set(Session(user, "127.0.0.1"))
        before = len(self.server.passed)
        await self.events.receive(connection, data)
        return len(self.server.passed) > before

    def handshake(self) -> str:
        content = {"client_id": self.client.id, "tab_id": "t", "document_id": "d", "next_message_id": 0}
        return f"20{json.dumps(['handshake', content])}"

    def event(self, *args: str, id: int | None = None, listener: str | None = None) -> str:
        own = next(iter(self.slider._event_listeners))
        content = {
            "client_id": self.client.id,
            "id": self.slider.id if id is None else id,
            "listener_id": listener or own,
            "args": list(args),
        }
        return f"2{json.dumps(['event', content])}"


@pytest.fixture
async def bench() -> Bench:
    return Bench()


async def test_what_a_page_sends_passes(bench: Bench) -> None:
    for packet in ("0", bench.handshake(), bench.event("1.5"), bench.event("0.1"), "1"):
        assert await bench.send(packet), packet
    assert await bench.send(f'2["ack",{{"client_id":"{bench.client.id}","next_message_id":3}}]')
    assert bench.refused == []


@pytest.mark.parametrize(
    "value",
    ["1.6", "-1", "1e999", "NaN", "Infinity", "true", '"1"', "[" * 400, "[]", "null", "9" * 400, '{"a":' * 300, "x"],
)
async def test_a_value_that_the_element_cannot_have_is_refused(bench: Bench, value: str) -> None:
    assert await bench.send(bench.handshake())
    assert not await bench.send(bench.event(value))
    assert bench.refused == [(NAME, "not valid")]


@pytest.mark.parametrize(
    "packet",
    [
        b"\x00",
        [1],
        {"a": 1},
        "",
        "9",
        "2",
        "2[",
        "2" + "[" * 5000,
        '2["event"]',
        '2["event",{}]',
        '2["event",[]]',
        '2["dance",{}]',
        '2/other,["event",{}]',
        '51-["event",{"_placeholder":true,"num":0}]',
        "0/other",
        '0{"token":"x"}',
        '2["handshake",{"client_id":1}]',
        "4",
        "3[]",
        "2" + "9" * 200 + "[]",
        '2["event",' + "9" * 5000 + "]",
    ],
)
async def test_other_packets_are_refused_and_too_many_end_the_connection(bench: Bench, packet: Any) -> None:
    for _ in range(MAX_INVALID):
        assert not await bench.send(packet)
    assert bench.server.ended == ["one"]
    assert len(bench.refused) == MAX_INVALID


async def test_a_browser_does_not_write_the_log_of_the_server(bench: Bench) -> None:
    await bench.send(bench.handshake())
    content = {"client_id": bench.client.id, "level": "error", "message": "\x1b[2J anna has logged in"}
    assert not await bench.send(f"2{json.dumps(['log', content])}")
    assert not await bench.send(f"2{json.dumps(['javascript_response', {**content, 'request_id': 'x'}])}")


async def test_nobody_acts_on_the_page_of_another_user(bench: Bench) -> None:
    assert await bench.send(bench.handshake())
    assert not await bench.send(bench.event("1.0"), "two", BEN), "without a handshake"
    assert not await bench.send(bench.handshake(), "two", BEN)
    assert not await bench.send(bench.event("1.0"), "two", BEN)
    assert bench.refused == [(NAME, "not valid")] * 3
    environ = bench.server.environ["two"]
    environ["QUERY_STRING"] = f"implicit_handshake=true&client_id={bench.client.id}&tab_id=t&document_id=d"
    assert not await bench.send("0", "two", BEN)
    environ["QUERY_STRING"] = "implicit_handshake=true"
    assert not await bench.send("0", "two", BEN)


async def test_elements_that_have_gone_are_no_mistake_of_the_browser(bench: Bench) -> None:
    await bench.send(bench.handshake())
    assert not await bench.send(bench.event("1.0", id=999_999))
    assert not await bench.send(bench.event("1.0", listener="gone"))
    assert bench.refused == []


async def test_a_flood_ends_the_connection(bench: Bench) -> None:
    await bench.send(bench.handshake())
    for _ in range(MAX_EVENTS_AT_ONCE):
        await bench.send(bench.event("1.0"))
    assert bench.server.ended == ["one"]
    assert bench.refused == [(NAME, "too many")]


async def test_values_of_all_kinds_of_elements() -> None:
    with Client(make_page(""), request=None):
        number, toggle = ui.number(), ui.toggle(["a", "b"])
        one, several = ui.select(["a", "b"]), ui.select(["a", "b"], multiple=True)
        fits = [
            (number, [None, "", 1.5, "1e3"], ["nan", "inf", [], True, "x", 1e300]),
            (toggle, [0, 1], [2, -1, "0", True, None, 0.5]),
            (one, [None, {"value": 1, "label": "b"}], [{"value": 2}, {}, "a", 1, [1]]),
            (several, [[], None, [{"value": 0}]], [[None], ["a"], {"value": 0}, [{"value": 9}]]),
            (ui.checkbox(), [True], [1, None, "true"]),
            (ui.input(), ["x" * 200, None], ["x" * 201, 1, {}]),
            (ui.label(), [], [1, None]),
        ]
    for element, good, bad in fits:
        assert all(can_have(element, value) for value in good), element
        assert not any(can_have(element, value) for value in bad), element


PARTS = ["[", "{", '"', "NaN", "-1e999", "9" * 50, "null", "\\ud800", "\x1b]0;x\x07", ",", "[" * 300]
VALUES = ["0", "1.5", "true", "null", '"x"', "[]", '{"value":1}', '{"what":"add","x":1e9,"y":1}']


def mutated(chance: random.Random, text: str) -> str:
    """The text with a few of its parts replaced, removed or repeated."""
    for _ in range(chance.randrange(4)):
        at = chance.randrange(len(text) + 1)
        part = chance.choice(PARTS)
        text = text[:at] + part + text[at + chance.randrange(3) :]
    return text


async def new_page(visitor: Visit) -> Loaded:
    """A page that has a place; those of browsers that have left keep theirs for some seconds."""
    async with asyncio.timeout(60.0):
        while not (loaded := await load(visitor)).has_place:
            await asyncio.sleep(0.2)
    return loaded


async def fuzz(visitor: Visit, process: subprocess.Popen[str], cases: int, seed: int) -> None:
    """Send packets of all kinds and mutations of them; the console answers at the end, and has not grown."""
    chance, memory = random.Random(seed), psutil.Process(process.pid).memory_info
    grown = 0
    for number in range(max(1, cases // 100)):
        loaded = await new_page(visitor)
        async with PageSocket(visitor, loaded.client) as page:
            for _ in range(100):
                if page.is_closed:
                    break
                value = chance.choice(VALUES)
                content = {
                    "client_id": loaded.client,
                    "id": chance.randrange(400),
                    "listener_id": str(chance.randrange(400)),
                    "args": [value] * chance.randrange(3),
                }
                name = chance.choice(["event"] * 6 + ["log", "ack", "javascript_response", "handshake"])
                await page.raw(mutated(chance, f"42{json.dumps([name, content])}"))
                if chance.random() < 0.02:
                    await page.raw(chance.choice([b"\x00", "451-[]", "4[[[", "x", "", "49"]))
                await asyncio.sleep(0.0)
        if number == 2:
            grown = memory().rss
    await new_page(visitor)
    if grown:
        assert memory().rss - grown < 150 << 20


@pytest.mark.slow
@pytest.mark.parametrize(
    ("cases", "seed"), [pytest.param(300, 1, id="short"), pytest.param(800, 2, id="long", marks=pytest.mark.slow)]
)
async def test_noise_on_the_socket_of_the_page_leaves_no_traceback(cases: int, seed: int) -> None:
    with (
        robot_in_thread() as robot,
        stopped(start("console", "--no-browser", "--port", "0", "--connect", robot.local)) as process,
    ):
        assert process.stdout is not None
        url = process.stdout.readline().strip().rpartition(" ")[2]
        async with asyncio.timeout(600.0):
            await fuzz(visit(url), process, cases, seed)
        process.send_signal(signal.SIGINT)
        _, errors = await asyncio.to_thread(process.communicate, timeout=30)
    assert "Traceback" not in errors, errors[:4000]
    assert "\x1b" not in errors
    assert errors.count("\n") < 30, errors[:4000]
