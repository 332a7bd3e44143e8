"""Two sites over a bad link: the age of commands and reports between gateways by JTCP, by JUDP, and by Zenoh.

python tools/bench/sites.py [--delay 100] [--loss 0.02] [--ways jtcp judp ...] [--parts steady burst cut] [--seconds 40]
                            [--slow-motion 1] [--json FILE]

Each site is a network namespace with a gateway; a program between their Ethernet ports delays all IPv4 packets
(milliseconds, each way) and loses some at random, so that the kernels' TCP sees a bad link. A robot of the one site
reports 200 times a second (40 bytes), an operator of the other sends 20 commands a second; both go on during all of it:

    steady    nothing else
    burst     both ends also send 400 events of 1000 bytes, of the lowest priority, at once
    cut       nothing passes for 10 s; this part is always in real time

    age       from sending to arrival, ms; one clock, since one program is robot and operator
    old       commands sent before the end of the cut that arrived after it, and the age of the oldest one, s
    back      from the end of the cut to the first command, and to the first report, that was sent after it, s
    wire      kB/s on the link in the steady part, both directions, Ethernet headers included
    CPU       seconds of both gateways in the steady part, for each 1000 messages
    relay     how late the program between was with one packet in a hundred, ms: what of the ages is not the link's

On a machine that others use too, ages of tens of milliseconds are those of its scheduler. `--slow-motion 5` multiplies
the delay and divides the rates by five, and tells ages divided by five, so that these count a fifth: times of TCP
follow from the delay, except of its smallest retransmission time of 0.2 s, which then counts less. Ways may be measured
at the same time, by one process each.

`zenoh-*` are a prototype outside of the product (`_site_bridge.py`) and need the package `eclipse-zenoh`. Needs root.
`stall_ms` is the longest time for which the program with robot and operator stood still.
"""

from __future__ import annotations

import argparse
import contextlib
import importlib.util
import json
import os
import selectors
import shutil
import socket
import struct
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final

import _site_bridge_settings as bridges

from jauspy.ids import JausID
from jauspy.protocol import judp, junior
from jauspy.protocol.header import Packet, Priority

sys.path.insert(0, str(Path(__file__).parents[2]))

from tests.node.hosts.switch import Switch

ROBOT, OPERATOR = JausID(101, 1, 1), JausID(42, 1, 1)
ADDRESSES: Final = ("10.77.0.1", "10.77.0.2")
"""Of the gateways of robot and operator."""
COMMAND, REPORT, EVENT = 0x0405, 0x4402, 0x41F1
"""SetWrenchEffort, ReportLocalPose, Event."""
_BODY: Final = struct.Struct("<HId")
"""Message id, number, time of sending."""
SIZES: Final = {COMMAND: 40, REPORT: 40, EVENT: 1000}
BURST: Final = 400
"""Events of each end."""
BURST_SECONDS, CUT_SECONDS, AFTER_SECONDS = 15.0, 10.0, 20.0
WARM_UP_SECONDS: Final = 10.0
MAX_COMMAND_AGE: Final = 0.5
MAX_STALL: Final = 0.5
"""Seconds without a turn of this program after which it does not make up for what it has not sent."""
PARTS: Final = ["steady", "burst", "cut"]
GATEWAYS: Final = """
address = "{address}"
max_message_age = {max_age}
local_root = "{root}"
name = "wan"
{more}
[addresses]
{peer}
[gateway]
subsystem = {subsystem}
[[gateway.rules]]
source = "{other}.*.*"
"""


@dataclass(slots=True)
class Message:
    """One that was sent, and when it arrived."""

    code: int
    sent: float
    arrived: float | None = None

    @property
    def age(self) -> float:
        """Seconds; of one that arrived."""
        assert self.arrived is not None
        return self.arrived - self.sent


@dataclass(slots=True)
class End:
    """A component of one site."""

    id: JausID
    other: JausID
    root: Path
    sock: socket.socket
    sent: list[Message] = field(default_factory=list)
    refused: int = 0
    """Times that the gateway's socket was full."""

    def send(self, code: int, priority: Priority, now: float) -> bool:
        """Send one message; false if the gateway's socket is full."""
        number = len(self.sent)
        body = _BODY.pack(code, number, now).ljust(SIZES[code], b"\0")
        packet = Packet(self.id, self.other, body, number & 0xFFFF, priority=priority)
        try:
            self.sock.sendto(judp.pack(packet), str(self.root / junior.SOCKET_NAME))
        except BlockingIOError:
            self.refused += 1
            return False
        self.sent.append(Message(code, now))
        return True

    def receive(self, of: End) -> None:
        """Note what has arrived of the other end's messages."""
        while True:
            try:
                datagram = self.sock.recv(70000)
            except BlockingIOError:
                return
            now = time.monotonic()
            if junior.parse(datagram) is None:
                _, number, _ = _BODY.unpack_from(datagram, judp.first_header(datagram).payload_start)
                message = of.sent[number]
                message.arrived = message.arrived or now


class Load:
    """Robot and operator."""

    def __init__(self, roots: tuple[Path, Path], slow: float, stack: contextlib.ExitStack) -> None:
        self._slow = slow
        self._selector = stack.enter_context(selectors.DefaultSelector())
        self.robot = self._end(ROBOT, OPERATOR, roots[0], stack)
        self.operator = self._end(OPERATOR, ROBOT, roots[1], stack)
        self.stall = 0.0
        """Seconds of the longest pause of this program."""
        self._next = {COMMAND: time.monotonic(), REPORT: time.monotonic()}
        self._burst = {REPORT: 0, COMMAND: 0}

    def burst(self) -> None:
        """Have both ends send events, as fast as their gateways take them."""
        self._burst = {REPORT: BURST, COMMAND: BURST}

    def run(self, seconds: float) -> tuple[float, float]:
        """Send and receive; returns when that began and ended. The time is that of the slow motion."""
        seconds *= self._slow
        began = last = time.monotonic()
        while (now := time.monotonic()) < began + seconds:
            self.stall = max(self.stall, now - last)
            last = now
            for code, end, interval in ((REPORT, self.robot, 0.005), (COMMAND, self.operator, 0.05)):
                while self._next[code] <= now:
                    if now - self._next[code] > MAX_STALL:
                        self._next[code] = now
                    end.send(code, Priority.STANDARD, time.monotonic())
                    self._next[code] += interval * self._slow
                for _ in range(5):
                    if self._burst[code] and end.send(EVENT, Priority.LOW, time.monotonic()):
                        self._burst[code] -= 1
            until = now + 0.001 if any(self._burst.values()) else min(self._next.values())
            self._selector.select(max(0.0, until - time.monotonic()))
            self.robot.receive(self.operator)
            self.operator.receive(self.robot)
        return began, time.monotonic()

    def _end(self, id: JausID, other: JausID, root: Path, stack: contextlib.ExitStack) -> End:
        sock = stack.enter_context(socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM))
        sock.bind(str(root / str(int(id))))
        sock.sendto(junior.connect(id), str(root / junior.SOCKET_NAME))
        sock.settimeout(20)
        sock.recv(100)
        sock.setblocking(False)
        self._selector.register(sock, selectors.EVENT_READ)
        return End(id, other, root, sock)


# --- gateways --------------------------------------------------------------------------------------------------------


def node_managers(way: str, roots: tuple[Path, Path], max_age: float) -> list[list[str]]:
    """The commands of two gateways of jauspy; the operator's connects if it is by TCP."""
    commands = []
    for number, (root, subsystem, other) in enumerate(zip(roots, (101, 42), (42, 101), strict=True)):
        peer = f'"{other}.255.255" = "{way[1:]}://{ADDRESSES[1 - number]}:3794"'
        if way == "jtcp" and number == 0:
            peer = ""
        text = GATEWAYS.format(
            address=ADDRESSES[number],
            root=root,
            max_age=max_age,
            more="tcp = true" if way == "jtcp" else "",
            peer=peer,
            subsystem=subsystem,
            other=other,
        )
        path = root / "gateway.toml"
        path.write_text(text)
        commands.append(["-m", "jauspy.cli.main", "node-manager", "--config", str(path)])
    return commands


@contextlib.contextmanager
def started(namespace: str, command: list[str], log: Path) -> Iterator[subprocess.Popen[bytes]]:
    """A Python program in a namespace that has said `ready`."""
    with (
        log.open("wb") as opened,
        subprocess.Popen(
            ["ip", "netns", "exec", namespace, sys.executable, *command],
            stdout=subprocess.PIPE,
            stderr=opened,  # nosec B607
        ) as process,
    ):
        try:
            assert process.stdout is not None
            if b"ready" not in process.stdout.readline():
                raise SystemExit(f"{' '.join(command)} did not start: {log.read_text()}")
            yield process
        finally:
            process.kill()


def cpu_seconds(pid: int) -> float:
    """The CPU time that a process has used."""
    values = Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
    return (int(values[11]) + int(values[12])) / os.sysconf("SC_CLK_TCK")


# --- one row ---------------------------------------------------------------------------------------------------------


def measure(way: str, parts: list[str], slow: float, arguments: argparse.Namespace) -> dict[str, Any]:
    """The row of one way, in slow motion or in real time (1)."""
    row: dict[str, Any] = {"way": way, "slow_motion": slow}
    with contextlib.ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory()))
        roots = folder / "a", folder / "b"
        for root in roots:
            root.mkdir()
        switch = Switch(stack, 2)
        latency = slow * arguments.delay / 1000
        relay = switch.relay(
            loss=arguments.loss, twice=0, delay=0, latency=latency, wide_area=True, seed=arguments.seed
        )
        if way.startswith("zenoh"):
            commands = bridges.commands(way, roots, ADDRESSES)
        else:
            commands = node_managers(way, roots, MAX_COMMAND_AGE * slow)
        processes = [
            stack.enter_context(started(host, command, root / "log"))
            for host, command, root in zip(switch.hosts, commands, roots, strict=True)
        ]
        load = Load(roots, slow, stack)
        load.run(WARM_UP_SECONDS)
        load.stall = 0.0
        if "steady" in parts:
            cpu, before = sum(cpu_seconds(process.pid) for process in processes), told(relay)
            steady = load.run(arguments.seconds)
            cpu, carried = sum(cpu_seconds(process.pid) for process in processes) - cpu, told(relay)
            row["wire_kB_s"] = round((carried["bytes"] - before["bytes"]) / arguments.seconds / 1000, 1)
            row["cpu_per_1000"] = round(cpu / (220 * arguments.seconds) * 1000, 3)
        if "burst" in parts:
            load.burst()
            burst = load.run(BURST_SECONDS)
            load.run(BURST_SECONDS)  # what is late
        if "cut" in parts:
            word(relay, "cut")
            load.run(CUT_SECONDS)
            word(relay, "mend")
            row["cut"] = after_cut(load, load.run(AFTER_SECONDS)[0])
        row["stall_ms"] = round(1000 * load.stall / slow)
        row["relay_ms"] = round(1000 * told(relay)["late_p99"] / slow)
    if "steady" in parts:
        row["steady"] = ages(load, steady, slow)
    if "burst" in parts:
        row["burst"] = ages(load, burst, slow) | {"events": events(load, burst, slow)}
    return row


def word(relay: subprocess.Popen[str], text: str) -> None:
    """Tell the relay."""
    assert relay.stdin is not None
    relay.stdin.write(text + "\n")
    relay.stdin.flush()


def told(relay: subprocess.Popen[str]) -> dict[str, float]:
    """What the relay has carried so far."""
    word(relay, "stop")
    assert relay.stdout is not None
    found: dict[str, float] = json.loads(relay.stdout.readline())
    return found


def quantile(values: list[float], part: float) -> float | None:
    """A quantile in ms; None of nothing."""
    values = sorted(values)
    return round(1000 * values[min(len(values) - 1, int(part * len(values)))]) if values else None


def ages(load: Load, span: tuple[float, float], slow: float) -> dict[str, Any]:
    """Ages and losses of what was sent meanwhile."""
    row: dict[str, Any] = {}
    for name, code, end in (("commands", COMMAND, load.operator), ("reports", REPORT, load.robot)):
        sent = [message for message in end.sent if message.code == code and span[0] <= message.sent < span[1]]
        found = [message.age / slow for message in sent if message.arrived is not None]
        row[name] = {f"p{round(100 * part)}_ms": quantile(found, part) for part in (0.5, 0.95, 0.99)}
        row[name] |= {"max_ms": quantile(found, 1.0), "lost": round(1 - len(found) / max(1, len(sent)), 4)}
    return row


def events(load: Load, span: tuple[float, float], slow: float) -> dict[str, Any]:
    """How many events of a burst arrived, and when the last one did."""
    found = [
        message
        for end in (load.robot, load.operator)
        for message in end.sent
        if message.code == EVENT and message.arrived is not None
    ]
    last = max((message.arrived or 0.0 for message in found), default=span[0])
    return {"sent": 2 * BURST, "arrived": len(found), "seconds": round((last - span[0]) / slow, 1)}


def after_cut(load: Load, mended: float) -> dict[str, Any]:
    """What arrived after the cut, which ended then, and when."""
    row: dict[str, Any] = {}
    old = [
        message.age
        for message in load.operator.sent
        if message.sent < mended and message.arrived is not None and message.arrived > mended
    ]
    row["old_commands"], row["oldest_s"] = len(old), round(max(old, default=0.0), 2)
    for name, code, end in (("commands", COMMAND, load.operator), ("reports", REPORT, load.robot)):
        arrived = [
            message.arrived
            for message in end.sent
            if message.code == code and message.sent >= mended and message.arrived is not None
        ]
        row[f"{name}_back_s"] = round(min(arrived) - mended, 2) if arrived else None
    return row


def why_not(way: str) -> str | None:
    """Reason why a way cannot be measured here."""
    if way.startswith("zenoh") and importlib.util.find_spec("zenoh") is None:
        return "the package eclipse-zenoh is not installed"
    if way.startswith("zenoh-quic") and importlib.util.find_spec("cryptography") is None:
        return "certificates need the extra 'operators'"
    return None


def main() -> None:
    """Measure all."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ways = ["jtcp", "judp", *bridges.WAYS]
    parser.add_argument("--delay", type=float, default=100.0, help="ms, each way")
    parser.add_argument("--loss", type=float, default=0.02)
    parser.add_argument("--ways", nargs="+", choices=ways, default=ways)
    parser.add_argument("--seconds", type=float, default=40.0, help="of the steady part")
    parser.add_argument("--parts", nargs="+", choices=PARTS, default=PARTS)
    parser.add_argument("--slow-motion", type=float, default=1.0, help="factor, not of the cut")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--json", type=Path)
    arguments = parser.parse_args()
    if os.geteuid() or not shutil.which("ip"):
        print("skipped: network namespaces need root and the program ip")
        return
    rows = []
    for way in arguments.ways:
        if (reason := why_not(way)) is not None:
            print(f"{way}: skipped: {reason}", flush=True)
            continue
        slow = arguments.slow_motion
        timed = [part for part in arguments.parts if part != "cut" or slow == 1.0]
        if timed:
            rows.append(measure(way, timed, slow, arguments))
            print(json.dumps(rows[-1]), flush=True)
        if timed != arguments.parts:
            rows.append(measure(way, ["cut"], 1.0, arguments))
            print(json.dumps(rows[-1]), flush=True)
    if arguments.json:
        arguments.json.write_text(json.dumps(rows, indent=2))


if __name__ == "__main__":
    main()
