"""`jauspy echo`, `hz`, `bw` and `graph`: of a capture, and of a node manager that runs."""

from __future__ import annotations

import asyncio
import json
import socket
import threading
import time
from contextlib import ExitStack
from pathlib import Path

import pytest
from typer.testing import CliRunner

from jauspy.capture import writer
from jauspy.cli.main import app
from jauspy.ids import JausID
from jauspy.inspection.live import LiveCapture
from jauspy.messages.core import ReportStatus
from jauspy.messages.mobility import ReportLocalPose
from jauspy.node import NodeConfig, NodeManager
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Packet
from jauspy.testing import until

OCU, ROBOT = JausID(42, 1, 1), JausID(101, 1, 102)


def run(*arguments: object, status: int = 0):
    result = CliRunner().invoke(app, [*map(str, arguments)])
    assert result.exit_code == status, result.output
    return result


@pytest.fixture
def capture(tmp_path: Path) -> Path:
    """Ten poses in a second, and one status."""
    path = tmp_path / "run.pcapng"
    blocks = [writer.preamble()]
    for number in range(10):
        payload = judp.pack(Packet(ROBOT, OCU, ReportLocalPose(x=float(number), y=1.0).encode(), number))
        blocks.append(writer.packet(("10.0.0.1", 3794), ("10.0.0.2", 3794), payload, 100_000_000_000 + number * 10**8))
    status = judp.pack(Packet(OCU, ROBOT, ReportStatus.from_dict({"status": "READY", "reserved": 0}).encode(), 1))
    blocks.append(writer.packet(("10.0.0.2", 3794), ("10.0.0.1", 3794), status, 101_000_000_000))
    path.write_bytes(b"".join(blocks))
    return path


def test_echo(capture: Path) -> None:
    lines = run("echo", "42.*", "--capture", capture).stdout.splitlines()
    assert lines[0].endswith("42.1.1 → 101.1.102  ReportStatus")
    assert lines[1].strip() == "status: READY (1)"
    assert len(lines) == 3


def test_echo_of_fields_rates_and_counts(capture: Path) -> None:
    rows = [json.loads(line) for line in run(
        "echo", "*", "Report*", "--capture", capture, "--field", "x", "--rate", 5, "--count", 3, "--json"
    ).stdout.splitlines()]  # fmt: skip
    assert [row["x"] for row in rows] == [0.0, 2.0, 4.0]
    assert rows[0] == {"time": 100.0, "source": "101.1.102", "message": "ReportLocalPose", "x": 0.0}
    text = run("echo", "--capture", capture, "--filter", "x == 9", "--field", "x", "--field", "y").stdout
    assert text.endswith("ReportLocalPose  x: 9  y: 1\n")


def test_rates(capture: Path) -> None:
    rows = [json.loads(line) for line in run("hz", "--capture", capture, "--json").stdout.splitlines()]
    assert [(row["message"], row["count"]) for row in rows] == [("ReportLocalPose", 10), ("ReportStatus", 1)]
    assert rows[0]["hz"] == pytest.approx(10.0)
    table = run("hz", "--capture", capture).stdout.splitlines()
    assert table[1].split()[:5] == ["ReportLocalPose", "101.1.102", "42.1.1", "10", "10.00"]
    table = run("bw", "101", "--capture", capture).stdout.splitlines()
    assert len(table) == 3
    assert table[-1].endswith("bytes/s in all")


def test_graph(capture: Path, tmp_path: Path) -> None:
    assert "101.1.102 → 42.1.1" in run("graph", "--capture", capture).stdout
    for name, start in (("talks.dot", "digraph jaus {\n"), ("talks.svg", "<svg")):
        run("graph", "--capture", capture, "-o", tmp_path / name)
        assert (tmp_path / name).read_text().startswith(start)
    assert "neither a .svg nor a .dot" in run("graph", "--capture", capture, "-o", "x.png", status=1).stderr
    assert "cannot be written" in run("graph", "--capture", capture, "-o", tmp_path / "no" / "x.svg", status=1).stderr


@pytest.mark.parametrize("verb", ["echo", "hz", "bw", "graph"])
def test_errors_are_one_sentence(verb: str, tmp_path: Path) -> None:
    missing = tmp_path / "missing"
    assert "No such file" in run(verb, "--capture", missing, status=1).stderr
    assert "no node manager shows its traffic" in run(verb, "--local-root", missing, status=1).stderr


def test_a_wrong_filter_is_said_before_anything_is_printed(capture: Path) -> None:
    assert "'gate' is no id" in run("echo", "gate", "--capture", capture, status=1).stderr
    assert "did you mean ReportStatus?" in run("hz", "*", "ReportStatu", "--capture", capture, status=1).stderr


async def test_traffic_of_a_running_node_manager(root: Path) -> None:
    with ExitStack() as stack:
        node = NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root))
        component = stack.enter_context(socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM))
        peer = stack.enter_context(socket.socket(socket.AF_INET, socket.SOCK_DGRAM))
        await node.open()
        component.bind(str(root / str(int(ROBOT))))
        component.sendto(junior.connect(ROBOT), str(node.path))
        await until(lambda: node.components == (ROBOT,))
        found: list[str] = []

        def listen() -> None:
            found.append(run("hz", "--local-root", root, "--for", 1.5, "--json").stdout)

        thread = threading.Thread(target=listen)
        thread.start()
        await until(lambda: bool(node._mirrors))
        sent = 0
        while thread.is_alive():
            payload = ReportLocalPose(x=1.0, y=1.0).encode()
            peer.sendto(judp.pack(Packet(OCU, ROBOT, payload, sent % 65536)), ("127.0.0.1", node.port))
            sent += 1
            await asyncio.sleep(0.02)
        await node.close()
    (row,) = [json.loads(line) for line in found[0].splitlines()]
    assert row["message"] == "ReportLocalPose"
    assert 5 <= row["count"] <= sent


async def test_a_live_capture_ends_with_its_node_manager_or_in_time(root: Path) -> None:
    node = NodeManager(NodeConfig(address="127.0.0.1", port=0, local_root=root))
    await node.open()
    endless = await asyncio.to_thread(LiveCapture, root)
    limited = await asyncio.to_thread(LiveCapture, root, 0.05)
    begin = time.monotonic()
    assert await asyncio.to_thread(list, limited) == []
    assert time.monotonic() - begin >= 0.04
    reading = asyncio.create_task(asyncio.to_thread(list, endless))
    await node.close()
    assert await reading == []
    for capture in (endless, limited):
        capture.close()
