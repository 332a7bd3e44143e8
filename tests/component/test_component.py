"""What an author of components sees."""

from __future__ import annotations

import asyncio
import os
import signal
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

import jauspy
from jauspy.component import ComponentOptions
from jauspy.errors import ConfigError, TransportError
from jauspy.ids import EVERYONE
from jauspy.messages.core import (
    QueryHeartbeatPulse,
    QueryStatus,
    QueryTime,
    ReportHeartbeatPulse,
    ReportStatus,
    ReportTime,
)
from jauspy.messages.mobility import QueryWrenchEffort, ReportWrenchEffort, SetWrenchEffort
from jauspy.node import NodeConfig, NodeManager
from jauspy.protocol.header import Broadcast
from jauspy.services.core import Discovery, Identity, Liveness
from jauspy.testing import until
from jauspy.transport import LoopbackHub, LoopbackTransport

ME, OCU = "101.1.120", "42.1.1"


class Driver(jauspy.Service, urn="urn:jaus:jss:mobility:PrimitiveDriver"):
    def __init__(self) -> None:
        self.effort = 0.0

    def set_wrench_effort(self, msg: SetWrenchEffort) -> None:
        self.effort = msg.propulsive_linear_effort_x or 0.0

    def report_wrench_effort(self, query: QueryWrenchEffort) -> ReportWrenchEffort:
        return ReportWrenchEffort(propulsive_linear_effort_x=self.effort)

    def reset_travel_speed(self) -> None:
        self.effort = 0.0


def on(hub: LoopbackHub, id: str) -> LoopbackTransport:
    return LoopbackTransport(jauspy.JausID.parse(id), hub)


def component(hub: LoopbackHub, *services: jauspy.Service, **options) -> jauspy.Component:
    return jauspy.Component(ME, services or [Driver()], transport=on(hub, ME), **options)


async def test_component_is_discovered_controlled_and_queried():
    hub = LoopbackHub()
    async with component(hub, name="wheels") as me, jauspy.OCU(OCU, transport=on(hub, OCU)) as ocu:
        robot = await ocu.discover(101)
        assert robot.component(120).info.name == "wheels"
        driver = robot.service("PrimitiveDriver")
        async with driver.control():
            await driver.resume()
            await driver.send(SetWrenchEffort(propulsive_linear_effort_x=40.0))
            report = await driver.query(QueryWrenchEffort(0xFFFF))
            assert report.propulsive_linear_effort_x == pytest.approx(40.0, abs=0.01)
            assert me.controller == ocu.id
            assert me.state.endswith("Controlled.Available.Ready")
        assert me.service(Driver).effort == 0.0
        assert me.counters["host.received"] > 5


async def test_core_services_are_included_by_default():
    hub = LoopbackHub()
    async with component(hub), jauspy.OCU(OCU, transport=on(hub, OCU)) as ocu:
        offered = (await ocu.discover(101)).component(120).info.services
        assert {each.urn.rpartition(":")[2] for each in offered} >= {
            *("Transport", "Events", "AccessControl", "Management", "Time", "Liveness", "Discovery", "PrimitiveDriver")
        }
        assert isinstance(await ocu.query(ME, QueryTime(0xFF)), ReportTime)


def test_core_false_includes_inherited_services_only():
    names = {each.name for each in component(LoopbackHub(), Liveness(), core=False).host.definitions.values()}
    assert names == {"Liveness", "Events", "Transport"}


async def test_given_core_services_replace_the_default_ones():
    class Pulse(Liveness):
        beats = 0

        def report_heartbeat_pulse(self) -> ReportHeartbeatPulse:
            self.beats += 1
            return ReportHeartbeatPulse()

    me = component(LoopbackHub(), Driver(), Pulse(), Discovery({4: Identity("mine", 60001)}))
    assert me.service(Pulse) is me.service(Liveness)
    assert me.service(Discovery).identities[4].name == "mine"


def test_core_services_have_the_version_that_others_need():
    class Old(Driver, version="1.0"):
        pass

    versions = {each.name: each.version for each in component(LoopbackHub(), Old()).host.definitions.values()}
    assert set(versions.values()) == {"1.0"}
    assert {"Discovery", "Time", "Liveness", "Management"} <= versions.keys()


def test_missing_methods_raise_config_error_with_signatures():
    class Half(jauspy.Service, urn="urn:jaus:jss:mobility:PrimitiveDriver"):
        pass

    with pytest.raises(ConfigError) as caught:
        jauspy.Component(ME, [Half()])
    assert (
        "PrimitiveDriver, state Receiving.Ready.Controlled.Available.Ready: action setWrenchEffort needs a method of "
        "Half: def set_wrench_effort(self, msg: SetWrenchEffort) -> None" in str(caught.value)
    )


@pytest.mark.parametrize("id", ["101.1.0", "65535.1.1", "101.255.1", "0.0.255", "101.1"])
def test_invalid_id_is_rejected(id):
    with pytest.raises(ConfigError, match=r"101\.1\.1"):
        jauspy.Component(id, [Driver()])


def test_unknown_service_is_an_error():
    with pytest.raises(ConfigError, match="no service of the class Discovered"):
        jauspy.Component(ME, [Driver()]).service(type("Discovered", (jauspy.Service,), {}))


async def test_closed_component_error_says_how_to_open_it():
    me = component(LoopbackHub())
    for use in (me.wake, lambda: me.send(OCU, ReportHeartbeatPulse()), lambda: me.move("101.1.121")):
        with pytest.raises(ConfigError, match="async with"):
            use()
    async with me:
        await me.open()
        await me.close()
        await me.close()
    assert me.counters == {}


async def test_missing_node_manager_error_says_what_to_do(root: Path):
    with pytest.raises(TransportError, match="no node manager"):
        await jauspy.Component(ME, [Driver()], connect=f"local:{root}").open()


async def test_messages_can_be_sent_at_any_time():
    hub = LoopbackHub()
    async with component(hub) as me, jauspy.OCU(OCU, transport=on(hub, OCU)) as ocu:
        me.send(OCU, QueryHeartbeatPulse())
        await me.deliver(ocu.id, ReportHeartbeatPulse())


async def test_broadcasts_that_no_service_takes_are_only_counted():
    hub = LoopbackHub()
    other = jauspy.Component("101.1.121", [Liveness()], transport=on(hub, "101.1.121"))
    async with component(hub) as me, other, jauspy.OCU(OCU, transport=on(hub, OCU)) as ocu:
        for _ in range(3):
            other.send(EVERYONE, ReportHeartbeatPulse(), broadcast=Broadcast.GLOBAL)
        await ocu.query(ME, QueryStatus())
        assert me.counters["host.unknown_message"] == 3
        assert me.counters["endpoint.received"] == 1, "the query"
        taken: list[jauspy.JausID] = []
        me.host.expect(ReportHeartbeatPulse, lambda message, source: taken.append(source))
        other.send(EVERYONE, ReportHeartbeatPulse(), broadcast=Broadcast.GLOBAL)
        await ocu.query(ME, QueryStatus())
        assert taken == [other.id]
        other.send(EVERYONE, QueryHeartbeatPulse(), broadcast=Broadcast.GLOBAL)
        await ocu.query(ME, QueryStatus())
        assert me.counters["host.unknown_message"] == 3, "its Liveness takes queries"


def test_every_does_not_drift_and_skips_missed_calls():
    class Clock(Liveness):
        def __init__(self) -> None:
            self.ticks: list[float] = []

        def attached(self) -> None:
            self.every(0.5, self.tick)

        def tick(self) -> None:
            self.ticks.append(self.host.now)

    clock = Clock()
    host = component(LoopbackHub(), Driver(), clock, options=ComponentOptions(clock=lambda: 100.0)).host
    for now in (100.4, 100.6, 101.0, 103.2, 103.4, 103.5):
        host.handle_timeout(now)
    assert clock.ticks == [100.6, 101.0, 103.2, 103.5]
    host.cancel_timer(clock.tick)
    host.handle_timeout(110.0)
    assert len(clock.ticks) == 4


def test_repeated_calls_of_a_robot_come_together():
    calls: list[tuple[str, float]] = []
    hosts = [component(LoopbackHub(), options=ComponentOptions(clock=lambda at=at: at)).host for at in (100.0, 100.03)]
    for name, host in zip("ab", hosts, strict=True):
        host.repeat("check", 0.1, lambda name=name, host=host: calls.append((name, host.now)))
    dues = [host.next_timeout() for host in hosts]
    assert dues[0] is not None
    assert abs(dues[1] - dues[0]) < 1e-9 or abs(dues[1] - dues[0] - 0.1) < 1e-9
    for now in (dues[0] + 0.11, dues[0] + 0.55):
        for host in hosts:
            host.handle_timeout(now)
    assert [name for name, _ in calls] == ["a", "b"] * 2, "missed calls are skipped"
    hosts[0].repeat("check", 0.1, lambda: calls.append(("again", 0.0)))
    hosts[0].handle_timeout(dues[0] + 0.75)
    assert calls[-1] == ("again", 0.0), "the same key replaces"
    assert len(calls) == 5


class Buggy(Liveness):
    def report_heartbeat_pulse(self) -> ReportHeartbeatPulse:
        raise RuntimeError("a bug of the author")


@pytest.mark.parametrize(("on_error", "status"), [("stay", "STANDBY"), ("failure", "FAILURE")])
async def test_exceptions_do_not_affect_other_components(on_error, status, caplog):
    hub = LoopbackHub()
    other = jauspy.Component("101.1.121", [Liveness()], transport=on(hub, "101.1.121"))
    me = component(hub, Buggy(), on_action_error=on_error)
    async with me, other, jauspy.OCU(OCU, transport=on(hub, OCU)) as ocu:
        await until(lambda: me.host.status == ReportStatus.Status.STANDBY)
        with pytest.raises(jauspy.ResponseTimeout):
            await ocu.query(ME, QueryHeartbeatPulse(), timeout=0.05, retries=0)
        assert me.counters["host.action_failed"] == 1
        assert (await ocu.query(ME, QueryStatus())).status.name == status
        assert (await ocu.query("101.1.121", QueryStatus())).status.name == "STANDBY"
    (record,) = [each for each in caplog.records if each.levelname == "ERROR"]
    assert "QueryHeartbeatPulse" in record.getMessage()
    assert "42.1.1" in record.getMessage()
    assert "a bug of the author" in caplog.text


PROGRAM = """
import jauspy
from jauspy.services.core import Liveness

class Loud(Liveness):
    def attached(self):
        self.every(0.01, self.tell)

    def tell(self):
        self.host.cancel_timer(self.tell)
        print("runs", flush=True)

    def control_lost(self):
        print("ends in order", flush=True)

jauspy.run(*(jauspy.Component(id, [Loud()], connect="local:ROOT") for id in ("101.1.120", "101.1.121")))
print("ended", flush=True)
"""


@pytest.mark.slow
@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
async def test_program_ends_in_order(root: Path, number: int):
    async with NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root)):
        command = [sys.executable, "-W", "error", "-c", textwrap.dedent(PROGRAM).replace("ROOT", str(root))]
        child = await asyncio.create_subprocess_exec(*command, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        assert child.stdout is not None
        async with asyncio.timeout(20):
            assert [await child.stdout.readline() for _ in range(2)] == [b"runs\n"] * 2
            os.kill(child.pid, number)
            out, problems = await child.communicate()
        assert out.decode().split("\n") == ["ends in order"] * 2 + ["ended", ""]
        assert (child.returncode, problems) == (0, b"")
        assert not list(root.glob("[0-9]*"))


@pytest.mark.parametrize("ignored", [True, False])
def test_hangup_stays_ignored_under_nohup(ignored: bool):
    seen = []

    class Probe(jauspy.Component):
        async def run(self) -> None:
            seen.append(signal.getsignal(signal.SIGHUP))

    before = signal.signal(signal.SIGHUP, signal.SIG_IGN if ignored else signal.SIG_DFL)
    try:
        jauspy.run(Probe("101.1.120", []))
    finally:
        signal.signal(signal.SIGHUP, before)
    assert (seen[0] is signal.SIG_IGN) == ignored


def test_failed_start_prints_one_sentence(root: Path):
    command = [sys.executable, "-c", textwrap.dedent(PROGRAM).replace("ROOT", str(root))]
    child = subprocess.run(command, capture_output=True, text=True, timeout=60, check=False)
    *trace, problem = child.stderr.splitlines()
    assert child.returncode == 1
    assert f"no node manager answers on {root}/JuniorRTE; start one with" in problem
    assert len(trace) < 8, child.stderr
