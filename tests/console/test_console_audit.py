"""Several users of one console: its log and its audit log name who has caused what."""

from __future__ import annotations

import asyncio
import json
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("nicegui", reason="needs the extra 'console'")

from tests.helpers.browser_sockets import BrowserSocket

from jauspy.console.console import BY_ITSELF, MAX_EVENT, Console
from jauspy.console.operation import Operation
from jauspy.console.server import make_app
from jauspy.console.users import Session, User, current
from jauspy.ocu.robot import Robot
from jauspy.robot.audit import AuditLog
from jauspy.testing import VirtualNetwork

ANNA, BEN, CARL = User("anna", "operator", 127), User("ben", "observer", 0), User("carl", "operator", 127)


@dataclass
class Office:
    """A console of three users, each with one page; `tokens` by name."""

    console: Console
    app: Any
    robot: Robot
    operation: Operation
    tokens: dict[str, str]
    path: Path

    def socket(self, path: str, user: User) -> BrowserSocket:
        return BrowserSocket(self.app, f"{path}/{self.tokens[user.name]}", user)

    def audited(self) -> list[tuple[str, str]]:
        """Operator, and message or event, of each line of the audit log."""
        lines = [json.loads(line) for line in self.path.read_text().splitlines()]
        return [(line["operator"], line.get("message") or line["event"]) for line in lines if "operator" in line]


@asynccontextmanager
async def office(network: VirtualNetwork, folder: Path) -> AsyncIterator[Office]:
    path = folder / "users.toml.audit"
    with AuditLog(path, "console") as log:
        async with network.robot(), network.ocu() as ocu, network.ocu("42.1.3") as stopper:
            console, tokens = Console(ocu, stopper, log), dict[str, str]()
            robot = await ocu.discover(101)
            console.fleet.robots = {101: robot}
            for user in (ANNA, BEN, CARL):
                current.set(Session(user, "127.0.0.1"))
                browser = console.new_browser(lambda: None)
                assert browser is not None
                tokens[user.name] = browser[0]
            operation = console.operation(101)
            assert operation is not None
            try:
                yield Office(console, make_app(console), robot, operation, tokens, path)
            finally:
                current.set(None)
                await console.close()


async def as_user(user: User, action: Any) -> Any:
    """Run a coroutine as a request of this user."""

    async def act() -> Any:
        current.set(Session(user, "127.0.0.1"))
        return await action

    return await asyncio.create_task(act())


@pytest.mark.slow
async def test_each_command_has_the_user_who_has_sent_it(virtual_network: VirtualNetwork, tmp_path: Path) -> None:
    async with office(virtual_network, tmp_path) as at:
        taken = at.operation.take(at.tokens["anna"], 100, ANNA)
        assert await as_user(ANNA, taken) == ""
        held = asyncio.Event()
        send, names = at.operation._drive, list[str]()

        async def slowly(linear: float, angular: float) -> None:
            user = current.get()
            names.append(user.user.name if user is not None else BY_ITSELF)
            await held.wait()
            await send(linear, angular)

        at.operation._drive = slowly  # type: ignore[method-assign]
        async with at.socket("/ws/drive/101", ANNA) as anna:
            anna.send("[0.5, 0]")
            await anna.settled()
            assert await as_user(CARL, at.operation.take(at.tokens["carl"], 110, CARL)) == ""
            async with at.socket("/ws/drive/101", CARL) as carl:
                carl.send("[0.4, 0]")  # while the command of anna still waits
                await carl.settled()
                held.set()
                async with asyncio.timeout(5.0):
                    while len(names) < 2:
                        await asyncio.sleep(0.01)
        assert names[:2] == ["anna", "carl"]


@pytest.mark.slow
async def test_the_renewal_of_control_is_that_of_the_present_operator(
    virtual_network: VirtualNetwork, tmp_path: Path
) -> None:
    async with office(virtual_network, tmp_path) as at:
        assert await as_user(ANNA, at.operation.take(at.tokens["anna"], 100, ANNA)) == ""
        control = at.operation._control
        assert control is not None
        renewal = control._controls[0]._renewal
        assert renewal is not None
        session = renewal.get_context()[current] if hasattr(renewal, "get_context") else at.operation._renewing
        assert session is at.operation._renewing
        assert session.user == ANNA
        at.operation.ask(at.tokens["carl"], 100, CARL)
        await at.operation.answer(at.tokens["anna"], grant=True)
        assert session.user == at.operation.user == CARL


@pytest.mark.slow
async def test_a_release_that_comes_late_does_not_end_control_of_another_user(
    virtual_network: VirtualNetwork, tmp_path: Path
) -> None:
    async with office(virtual_network, tmp_path) as at:
        await at.operation.take(at.tokens["anna"], 100, ANNA)
        taking = asyncio.create_task(at.operation.take(at.tokens["carl"], 110, CARL))
        await asyncio.sleep(0.0)
        await at.operation.release(at.tokens["anna"])
        assert await taking == ""
        assert at.operation.operator == at.tokens["carl"]
        assert at.operation.is_controlled


@pytest.mark.slow
async def test_an_observer_stops_in_the_own_name_and_causes_nothing_else(
    virtual_network: VirtualNetwork, tmp_path: Path
) -> None:
    async with office(virtual_network, tmp_path) as at:
        await as_user(ANNA, at.operation.take(at.tokens["anna"], 100, ANNA))
        async with at.socket("/ws/stop", BEN) as ben, at.socket("/ws/drive/101", BEN) as drive:
            drive.send("[1, 1]")
            ben.send("release all")
            ben.send("stop 101")
            async with asyncio.timeout(10.0):
                while len(ben.said) < 2:
                    await asyncio.sleep(0.01)
            assert drive.said == ["another browser operates this robot"]
            assert ben.said[0] == "ben may stop robots, and not release them (observer)"
        theirs = BrowserSocket(at.app, f"/ws/drive/101/{at.tokens['anna']}", BEN)
        async with theirs:
            assert theirs.code == 4403
        stop = at.console.events[-1]
        assert (stop.user, stop.text.partition(":")[0]) == ("ben", "emergency stop of 101")
        assert " [ben] emergency stop of 101" in stop.line
        current.set(Session(ANNA, "127.0.0.1"))
        at.console.files(at.robot).delete_pose("101.1.104", "none")
    audited = at.audited()
    assert {name for name, what in audited if what == "SetEmergency"} == {"ben"}
    assert {name for name, what in audited if what.startswith("emergency stop of 101")} == {"ben"}
    assert {name for name, what in audited if what == "RequestControl"} == {"anna"}
    assert all(name in ("anna", "ben", BY_ITSELF) for name, _ in audited)


async def test_saving_and_deleting_is_in_the_log_with_the_user(
    virtual_network: VirtualNetwork, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("XDG_STATE_HOME", str(tmp_path / "state"))

    async with office(virtual_network, tmp_path) as at:

        async def save() -> None:
            files = at.console.files(at.robot)
            files.save_pose("101.1.104", "stow", {"elbow": 1.0})
            files.delete_pose("101.1.104", "stow")

        await as_user(CARL, save())
        lines = [(event.user, event.text) for event in at.console.events]
        assert ("carl", "robot 101: saved the pose stow of 101.1.104") in lines
        assert ("carl", "robot 101: deleted the pose stow of 101.1.104") in lines
        shown = at.console.traffic.lines("deleted", "event")
        assert [(line.user, line.source) for line in shown] == [("carl", "")]
    assert ("carl", "robot 101: saved the pose stow of 101.1.104") in at.audited()


@pytest.mark.slow
async def test_texts_of_robots_do_not_pass_as_lines_of_users(virtual_network: VirtualNetwork, tmp_path: Path) -> None:
    async with office(virtual_network, tmp_path) as at:
        at.console.note("robot 101: no video: \x1b[2J\n[anna] saved the pose stow " + "x" * 10_000)
        event = at.console.events[-1]
        assert event.line.isprintable()
        assert event.user == ""
        assert len(event.text) <= MAX_EVENT
        assert "  [" not in event.line
