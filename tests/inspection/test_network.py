"""Traffic of interfaces and of multicast groups: on the loopback interface, and between network namespaces."""

from __future__ import annotations

import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from itertools import islice
from pathlib import Path

import pytest
from tests.helpers.command_line import JAUSPY
from typer.testing import CliRunner

from jauspy.capture import writer
from jauspy.capture.reader import CaptureReader, Datagram
from jauspy.cli.main import app
from jauspy.errors import ConfigError, TransportError
from jauspy.ids import JausID
from jauspy.inspection import network
from jauspy.inspection.network import GroupCapture, InterfaceCapture
from jauspy.messages.mobility import ReportLocalPose
from jauspy.protocol import judp
from jauspy.protocol.header import Packet

GROUP = "239.255.76.1"
PAYLOAD = judp.pack(Packet(JausID(42, 1, 1), JausID(101, 1, 102), ReportLocalPose(x=1.0, y=1.0).encode(), 1))
needs_capturing = pytest.mark.skipif(os.geteuid() != 0, reason="capturing on an interface needs root")


@pytest.fixture
def sender() -> Iterator[socket.socket]:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sock:
        sock.setsockopt(socket.IPPROTO_IP, socket.IP_MULTICAST_IF, socket.inet_aton("127.0.0.1"))
        yield sock


@needs_capturing
def test_an_interface_shows_what_passes_the_port_also_in_fragments(sender: socket.socket, free_port: int) -> None:
    capture = InterfaceCapture("lo", free_port)
    before = time.time()
    sent = [b"small", bytes(range(256)) * 250]  # 64000 bytes: one fragment, or two, by the size of the interface
    for payload in sent:
        sender.sendto(payload, ("127.0.0.1", free_port + 1))
        sender.sendto(payload, ("127.0.0.1", free_port))
    found = list(islice(capture, len(sent)))
    assert [row.payload for row in found] == sent
    assert {row.destination for row in found} == {("127.0.0.1", free_port)}
    assert {row.source for row in found} == {("127.0.0.1", sender.getsockname()[1])}
    assert all(before - 1.0 < row.time < time.time() + 1.0 for row in found)
    assert capture.lost == 0
    capture.close()
    assert capture.lost == 0


@needs_capturing
def test_packets_that_are_not_read_in_time_are_counted(
    sender: socket.socket, free_port: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(network.multicast, "RECEIVE_BUFFER", 4096)
    capture = InterfaceCapture("lo", free_port, 0.1)
    for _ in range(200):
        sender.sendto(bytes(1000), ("127.0.0.1", free_port))
    lost = capture.lost
    assert 0 < lost < 400  # each is seen twice, as it goes out and as it comes in
    assert len(list(capture)) < 200
    capture.close()
    assert capture.lost == lost


def test_a_group_shows_what_is_sent_to_it(sender: socket.socket, free_port: int) -> None:
    with ExitStack() as stack:
        captures = [GroupCapture(GROUP, free_port, ["lo"]), GroupCapture(GROUP, free_port, ["127.0.0.1"])]
        for capture in captures:
            stack.callback(capture.close)
        sender.sendto(PAYLOAD, (GROUP, free_port))
        found: list[Datagram] = [next(iter(capture)) for capture in captures]
    origin = "127.0.0.1", sender.getsockname()[1]
    assert [row[2:] for row in found] == [(origin, (GROUP, free_port), PAYLOAD)] * 2


def test_it_ends_in_time(free_port: int) -> None:
    begin = time.monotonic()
    capture = GroupCapture(GROUP, free_port, ["lo"], 0.05)
    assert list(capture) == []
    capture.close()
    assert time.monotonic() - begin >= 0.05


@pytest.mark.parametrize(
    ("make", "error", "sentence"),
    [
        (lambda: GroupCapture("10.0.0.1", 1), ConfigError, "no IPv4 multicast group"),
        (lambda: GroupCapture("all", 1), ConfigError, "'all' is no IPv4 multicast group"),
        (lambda: GroupCapture(GROUP, 3794, ["none0"]), TransportError, "no interface none0 with"),
        (lambda: InterfaceCapture("none0", 1), TransportError, "no interface none0; there are: lo"),
    ],
)
def test_errors_are_one_sentence(make: Callable[[], object], error: type[Exception], sentence: str) -> None:
    with pytest.raises(error, match=sentence):
        make()


def test_without_the_capability_the_error_says_what_to_do(monkeypatch: pytest.MonkeyPatch) -> None:
    def refuse(*_: object) -> None:
        raise PermissionError(1, "Operation not permitted")

    monkeypatch.setattr(network.socket, "socket", refuse)
    result = CliRunner().invoke(app, ["hz", "--interface", "lo"])
    assert result.exit_code == 1
    assert "needs the capability CAP_NET_RAW: run it as root" in result.stderr


def test_options_that_contradict_each_other(tmp_path: Path) -> None:
    for arguments, sentence in (
        (["--port", "4000"], "--port needs --interface or --multicast"),
        (["--interface", "lo", "--capture", str(tmp_path)], "leave out --interface"),
    ):
        result = CliRunner().invoke(app, ["record", str(tmp_path / "x.pcapng"), *arguments])
        assert (result.exit_code, sentence in result.stderr) == (1, True)
        assert not (tmp_path / "x.pcapng").exists()


def _until_read(process: threading.Thread, send: Callable[[], object]) -> None:
    while process.is_alive():
        send()
        process.join(0.02)


def test_the_verbs_listen_to_a_group(sender: socket.socket, free_port: int, tmp_path: Path) -> None:
    where = ["--multicast", GROUP, "--interface", "lo", "--port", str(free_port)]
    results = []

    def listen() -> None:
        run = CliRunner().invoke
        results.append(run(app, ["echo", *where, "--count", "1", "--json"]))
        results.append(run(app, ["record", str(tmp_path / "run.pcapng"), *where, "--for", "0.3"]))

    thread = threading.Thread(target=listen)
    thread.start()
    _until_read(thread, lambda: sender.sendto(PAYLOAD, (GROUP, free_port)))
    assert [result.exit_code for result in results] == [0, 0], results
    assert json.loads(results[0].stdout)["message"] == "ReportLocalPose"
    with (tmp_path / "run.pcapng").open("rb") as file:
        found = list(CaptureReader(file, name="run", port=free_port))
    assert {row.payload for row in found} == {PAYLOAD}


SEND = """
import socket, sys, time
sock = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
while True:
    sock.sendto(bytes(5000), (sys.argv[1], 3794))
    time.sleep(0.05)
"""


@pytest.mark.slow
def test_fragments_are_seen_on_the_cable(cable: tuple[str, str], tmp_path: Path) -> None:
    path, end = tmp_path / "run.pcapng", cable[1].replace("jn", "jv")
    within = [str(shutil.which("ip")), "netns", "exec"]
    with subprocess.Popen([*within, cable[0], sys.executable, "-c", SEND, "10.77.0.2"]) as sending:
        try:
            command = [sys.executable, "-m", "jauspy.cli.main", "record", str(path), "--interface", end, "--for", "1"]
            subprocess.run([*within, cable[1], *command], check=True, capture_output=True, timeout=60)
        finally:
            sending.kill()
    with path.open("rb") as file:
        found = list(CaptureReader(file, name="run"))
    assert {(row.source[0], row.destination, row.payload) for row in found} == {
        ("10.77.0.1", ("10.77.0.2", 3794), bytes(5000))
    }


@needs_capturing
@pytest.mark.parametrize("tags", [b"", b"\x81\x00\x00\x07", b"\x88\xa8\x00\x09\x81\x00\x00\x07"])
def test_tags_of_vlans_are_taken_off(tags: bytes, free_port: int) -> None:
    packet = writer.ip_packet(("127.0.0.1", 9), ("127.0.0.1", free_port), b"tagged")
    capture = InterfaceCapture("lo", free_port, 0.5)
    with socket.socket(socket.AF_PACKET, socket.SOCK_RAW) as sock:
        sock.bind(("lo", 0))
        sock.send(bytes(12) + tags + b"\x08\x00" + packet)
    (found,) = capture
    capture.close()
    assert found[2:] == (("127.0.0.1", 9), ("127.0.0.1", free_port), b"tagged")


@needs_capturing
@pytest.mark.parametrize("address", ["127.0.0.1", "::1"])
def test_packets_of_jtcp_are_datagrams_and_other_connections_are_left_out(address: str, free_port: int) -> None:
    family = socket.AF_INET6 if ":" in address else socket.AF_INET
    stream = judp.pack(Packet(JausID(1, 1, 1), JausID(2, 1, 1), b"\x02\x20", 1)) + PAYLOAD[1:]
    capture = InterfaceCapture("lo", free_port, 5.0)
    with ExitStack() as stack:
        stack.callback(capture.close)
        for port in (0, free_port):  # the first is another one
            server = stack.enter_context(socket.create_server((address, port), family=family))
            client = stack.enter_context(socket.create_connection(server.getsockname()[:2]))
            for byte in (stream[:9], stream[9:]):
                client.sendall(byte)
        found = list(islice(capture, 2))
        assert [row.payload for row in found] == [stream[: len(stream) - len(PAYLOAD) + 1], PAYLOAD]
        assert {row.destination for row in found} == {(address, free_port)}
        assert {row.source for row in found} == {client.getsockname()[:2]}
        assert found[-1].number < 20  # frames that the kernel has let pass


@needs_capturing
def test_datagrams_over_ipv6_are_seen(free_port: int) -> None:
    capture = InterfaceCapture("lo", free_port)
    with socket.socket(socket.AF_INET6, socket.SOCK_DGRAM) as sock:
        sock.sendto(PAYLOAD, ("::1", free_port + 1))
        sock.sendto(PAYLOAD, ("::1", free_port))
    (found,) = islice(capture, 1)
    capture.close()
    assert (found.destination, found.payload) == (("::1", free_port), PAYLOAD)


@needs_capturing
@pytest.mark.parametrize(
    ("kind", "packet"),
    [
        (b"\x86\xdd", b"\x60" + bytes(3) + b"\x00\x08\x3a\x40" + bytes(40)),  # ICMPv6
        (b"\x86\xdd", b"\x60"),
        (b"\x86\xdd", b"\x60" + bytes(5) + b"\x2c\x40" + bytes(32)),  # a fragment without its header
        (b"\x86\xdd", b"\x60" + bytes(5) + b"\x11\x40" + bytes(34)),
        (b"\x08\x00", b"\x45" + bytes(8) + b"\x06" + bytes(12)),  # TCP without ports
        (b"\x08\x06", bytes(40)),
        (b"\x81\x00", b"\x00"),
    ],
)
def test_frames_that_are_cut_off_or_of_others_are_left_out(kind: bytes, packet: bytes, free_port: int) -> None:
    capture = InterfaceCapture("lo", free_port, 0.3)
    with socket.socket(socket.AF_PACKET, socket.SOCK_RAW) as sock:
        sock.bind(("lo", 0))
        sock.send(bytes(12) + kind + packet)
    assert list(capture) == []
    capture.close()


SEND_IPV6 = """
import socket, sys, time
sock = socket.socket(socket.AF_INET6, socket.SOCK_DGRAM)
index = socket.if_nametoindex(sys.argv[1])
while True:
    try:
        sock.sendto(bytes(5000), ("ff02::1", 3794, 0, index))
    except OSError:  # the interface has no address yet
        pass
    time.sleep(0.05)
"""


@pytest.mark.slow
def test_fragments_of_ipv6_are_seen_on_the_cable(cable: tuple[str, str], tmp_path: Path) -> None:
    path = tmp_path / "run.pcapng"
    within = [str(shutil.which("ip")), "netns", "exec"]
    near, far = (name.replace("jn", "jv") for name in cable)
    with subprocess.Popen([*within, cable[0], sys.executable, "-c", SEND_IPV6, near]) as sending:
        try:
            verb = ["-m", "jauspy.cli.main", "record", str(path), "--interface", far, "--for", "4"]
            subprocess.run([*within, cable[1], sys.executable, *verb], check=True, capture_output=True, timeout=60)
        finally:
            sending.kill()
    with path.open("rb") as file:
        found = list(CaptureReader(file, name="run"))
    assert {(row.destination, row.payload) for row in found} == {(("ff02::1", 3794), bytes(5000))}


@pytest.mark.slow
@pytest.mark.parametrize("number", [signal.SIGTERM, signal.SIGINT])
def test_a_recording_ends_in_order_at_a_signal(
    sender: socket.socket, free_port: int, tmp_path: Path, number: signal.Signals
) -> None:
    path = tmp_path / "run.pcapng"
    where = ("--multicast", GROUP, "--interface", "lo", "--port", str(free_port))
    with subprocess.Popen([*JAUSPY, "record", str(path), *where], stderr=subprocess.PIPE, text=True) as process:
        assert process.stderr is not None
        assert "recording" in process.stderr.readline()
        sender.sendto(PAYLOAD, (GROUP, free_port))
        end = time.monotonic() + 60.0
        while not (found := path.stat().st_size > len(writer.preamble())) and time.monotonic() < end:
            time.sleep(0.05)  # it is written although nothing follows
        process.send_signal(number)
        assert found
        assert "1 datagrams" in process.stderr.read()
    assert process.returncode == 0
    with path.open("rb") as file:
        assert [row.payload for row in CaptureReader(file, name="run", port=free_port)] == [PAYLOAD]
