"""Campaigns against targets on UDP that fail on certain messages, and against one that does not."""

from __future__ import annotations

import signal
import subprocess
import sys
from pathlib import Path

import psutil
import pytest

from jauspy.capture.reader import CaptureReader
from jauspy.errors import ConfigError
from jauspy.fuzz.target.address import is_isolated, target_address
from jauspy.fuzz.target.campaign import TargetPlan, TargetResult, run, run_on_cluster
from jauspy.fuzz.target.cases import EPISODE, Cases
from jauspy.fuzz.target.findings import code_of, delta_debugged, message_of
from jauspy.fuzz.target.process import TargetProcess
from jauspy.fuzz.target.session import MEBIBYTE, SAMPLES, Failure, Limits, TargetSession, steady_growth
from jauspy.ids import JausID
from jauspy.messages.core import Shutdown
from jauspy.protocol import judp

pytestmark = pytest.mark.alone

TARGET = Path(__file__).parent / "faulty_target.py"
SERVICES = frozenset(
    (f"urn:jaus:jss:core:{name}", "1.1") for name in ("Transport", "Events", "AccessControl", "Management", "Discovery")
)


def command(fault: str) -> str:
    return f"{sys.executable} {TARGET} {{port}} {fault}"


def campaign(fault: str, cases: int, *only: str, answer: float = 5.0, memory: int = 64) -> TargetResult:
    limits = Limits(answer, memory * MEBIBYTE)
    return run(TargetPlan(target_address("127.0.0.1:0"), cases, 1, restart=command(fault), only=only, limits=limits))


@pytest.mark.slow
def test_a_correct_target_has_no_findings():
    result = campaign("", 400)
    assert result.findings == {}
    assert (result.cases, result.component) == (400, "101.1.1")
    assert {state.removeprefix("Receiving.Ready.") for state in result.states} == {
        "NotControlled.Available.Standby",
        "Controlled.Available.Standby",
        "Controlled.Available.Ready",
        "NotControlled.NotAvailable.Emergency",
        "Controlled.NotAvailable.Emergency",
    }
    assert not result.unreached


@pytest.mark.slow
def test_a_target_that_dies_in_one_state_is_found_and_minimised(tmp_path):
    result = campaign("died", 400, "SetAuthority", "QueryAuthority")
    (finding,) = result.findings.values()
    assert (finding.failure, finding.is_minimised) == (Failure.DIED, True)
    assert finding.seen == "its process ended with status 3: authority out of range"
    assert [message_of(datagram) for datagram in finding.datagrams] == ["RequestControl", "Resume", "SetAuthority"]
    assert result.cases == 400  # the campaign went on behind it
    path = finding.save(tmp_path)
    assert path.name == "died-SetAuthority.pcapng"
    with path.open("rb") as file:
        read = [datagram.payload for datagram in CaptureReader(file, name=str(path), port=None)]
    assert tuple(read) == finding.datagrams
    assert symptom_of_a_new_target(read) is Failure.DIED


def symptom_of_a_new_target(datagrams: list[bytes]) -> Failure | None:
    address = target_address("127.0.0.1:0")
    process = TargetProcess(command("died").replace("{port}", str(address[1])))
    session = TargetSession(address, process, Limits(5.0))
    try:
        session.open()
        assert session.symptom() is None
        symptom = session.play(datagrams)
    finally:
        session.close()
    return symptom and symptom.failure


@pytest.mark.slow
def test_a_target_that_hangs_is_found_and_minimised():
    (finding,) = campaign("hangs", 200, "QueryEvents", answer=1.0).findings.values()
    assert (finding.failure, finding.is_minimised, len(finding.datagrams)) == (Failure.HANGS, True, 1)
    assert "though its process runs" in finding.seen
    assert finding.cause == "hangs QueryEvents"


@pytest.mark.slow
def test_a_target_that_leaks_is_found_and_minimised():
    result = campaign("leaks", 2000, "QueryTimeout", "QueryControl", memory=32)
    finding = result.findings["leaks QueryTimeout"]
    assert (finding.failure, len(finding.datagrams)) == (Failure.LEAKS, 1)


@pytest.mark.slow
def test_without_a_command_the_campaign_ends_with_all_that_was_sent():
    address = target_address("127.0.0.1:0")
    process = TargetProcess(command("died").replace("{port}", str(address[1])))
    process.restart()
    session = TargetSession(address, process, Limits(5.0))
    try:
        session.open()
        result = run(TargetPlan(address, 4000, 1, pid=process.pid, only=("SetAuthority",), limits=Limits(5.0)))
    finally:
        session.close()
    assert result.is_stopped
    (finding,) = result.findings.values()
    assert (finding.cause, finding.is_minimised) == ("died not minimised", False)
    assert len(finding.datagrams) > 3


@pytest.mark.slow
@pytest.mark.filterwarnings("default")  # of Dask, about its own processes
def test_cases_are_spread_over_a_cluster():
    distributed = pytest.importorskip("distributed", reason="needs jauspy[cell-cluster]")
    plan = TargetPlan(("127.0.0.1", 1), 1000, 1, restart=command(""), limits=Limits(5.0))
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        result = run_on_cluster(plan, cluster.scheduler_address)
    assert (result.cases, result.component, result.findings) == (1000, "101.1.1", {})


@pytest.mark.slow
@pytest.mark.filterwarnings("default")  # of Dask, about its own processes
def test_findings_survive_a_killed_worker_and_its_target_ends(tmp_path):
    distributed = pytest.importorskip("distributed", reason="needs jauspy[cell-cluster]")
    ids = tmp_path / "ids"
    restart = f"{command('lost')} {ids}"
    only = ("SetAuthority", "QueryAuthority")
    plan = TargetPlan(("127.0.0.1", 1), 100, 1, restart=restart, only=only, limits=Limits(5.0), tries=1)
    with distributed.LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        result = run_on_cluster(plan, cluster.scheduler_address)
        for pid in map(int, ids.read_text().split()):  # the target, and the worker that was lost
            assert is_gone(pid)
    (finding,) = result.findings.values()
    assert (result.cases, finding.failure) == (100, Failure.DIED)
    assert "SetAuthority" in map(message_of, finding.datagrams)


def test_a_target_ends_with_the_process_that_started_it():
    starter = (
        "import os, signal, sys\n"
        "from jauspy.fuzz.target.process import TargetProcess\n"
        "process = TargetProcess('sleep 600')\n"
        "process.restart()\n"
        "print(process.pid, flush=True)\n"
        "os.kill(os.getpid(), signal.SIGKILL)\n"
    )
    done = subprocess.run([sys.executable, "-c", starter], stdout=subprocess.PIPE, text=True, check=False)
    assert done.returncode == -signal.SIGKILL
    assert is_gone(int(done.stdout))


def test_a_target_that_is_closed_leaves_no_guard():
    before = set(psutil.Process().children(recursive=True))
    process = TargetProcess("sleep 600")
    process.restart()
    children = set(psutil.Process().children(recursive=True)) - before
    assert len(children) == 2
    process.close()
    assert not any(child.is_running() for child in children)


def is_gone(pid: int) -> bool:
    """True once the process has ended, within ten seconds."""
    try:
        psutil.Process(pid).wait(10.0)
    except psutil.NoSuchProcess:
        return True
    except psutil.TimeoutExpired:
        return psutil.Process(pid).status() == psutil.STATUS_ZOMBIE
    return True


def test_nothing_that_answers_is_an_error():
    with pytest.raises(ConfigError, match="does the target run"):
        run(TargetPlan(target_address("127.0.0.1:0"), 1, limits=Limits(0.1)))


def test_a_target_that_does_not_start_is_an_error():
    with pytest.raises(ConfigError, match="does not start: its process ended with status 7"):
        run(TargetPlan(target_address("127.0.0.1:0"), 1, restart=f"{sys.executable} -c 'raise SystemExit(7)'"))


def test_cases_depend_on_seed_and_number_only():
    one, same, other = (Cases(JausID(101, 1, 1), SERVICES, seed) for seed in (1, 1, 2))
    cases = [one.datagrams(number) for number in range(200)]
    assert cases == [same.datagrams(number) for number in range(200)]
    assert cases != [other.datagrams(number) for number in range(200)]
    assert any(len(case) > 1 for case in cases)
    assert {bool(judp.unpack_all(datagram)[1]) for case in cases for datagram in case} == {True, False}


def test_no_case_ends_the_target_by_right():
    cases = Cases(JausID(101, 1, 1), SERVICES, 3)
    sent = {code_of(datagram) for number in range(2000) for datagram in cases.datagrams(number)}
    assert len(sent) > 20
    assert Shutdown.CODE not in sent


def test_states_come_in_turn():
    cases = Cases(JausID(101, 1, 1), SERVICES, 0)
    paths = [cases.stop(number).path for number in range(0, 5 * EPISODE, EPISODE)]
    assert paths[0] == ()
    assert (("RequestControl", "controller"), ("Resume", "controller")) in paths


@pytest.mark.parametrize("text", ["10.1.2.3", "192.0.2.1:3794", "0.0.0.0:3794"])
def test_other_networks_are_refused(text):
    if is_isolated():
        pytest.skip("this is a network namespace without a default route, where they are allowed")
    with pytest.raises(ConfigError, match="--i-own-this-network"):
        target_address(text)
    assert target_address(text, is_own_network=True)[1] == 3794


@pytest.mark.parametrize("text", ["", "127.0.0.1:99999", "a b", "127.0.0.1:x", "::1"])
def test_wrong_addresses_are_refused(text):
    with pytest.raises(ConfigError):
        target_address(text)


def test_loopback_addresses_are_allowed():
    assert target_address("127.0.0.1") == ("127.0.0.1", 3794)
    assert target_address("udp://127.8.0.1:4000") == ("127.8.0.1", 4000)


def test_an_isolated_namespace_has_another_number_and_no_default_route(tmp_path):
    own, first, routes = (tmp_path / name for name in ("own", "first", "routes"))
    own.touch()
    first.touch()
    head, subnet = "Iface Destination Gateway Flags RefCnt Use Metric Mask\n", "v 0000000A 0 1 0 0 0 00FFFFFF\n"
    routes.write_text(head + subnet)
    assert is_isolated(routes, own, first)
    assert not is_isolated(routes, own, own)
    assert not is_isolated(routes, own, tmp_path / "missing")
    routes.write_text(head + subnet + "v 00000000 0100000A 3 0 0 0 00000000\n")
    assert not is_isolated(routes, own, first)


@pytest.mark.parametrize(
    ("samples", "growth"),
    [
        (range(40), 30),
        ([5] * 40, 0),
        ([*range(20), *[20] * 20], 0),  # a cache that has filled up
        (range(SAMPLES - 1), 0),
        (range(40, 0, -1), 0),
    ],
)
def test_only_steady_growth_counts(samples, growth):
    assert steady_growth(list(samples)) == growth


def test_delta_debugging_keeps_what_is_needed():
    data = [bytes([number]) for number in range(50)]
    needed = {b"\x03", b"\x11", b"\x29"}
    assert set(delta_debugged(data, lambda found: needed <= set(found))) == needed
