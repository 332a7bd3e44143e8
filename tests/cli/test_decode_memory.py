"""The memory of `jauspy decode` does not depend on the size of the file."""

from __future__ import annotations

import re
import struct
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from jauspy.capture import writer
from jauspy.ids import JausID
from jauspy.messages.mobility import ReportLocalPose
from jauspy.protocol import judp
from jauspy.protocol.header import Packet
from jauspy.recording.run_files import CHUNK_SIZE, DATAGRAMS, ENCODING

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(not Path("/proc/self/status").exists(), reason="peaks are read in /proc"),
]

HOSTS = ("10.0.0.7", 3794), ("10.0.0.2", 3794)
SMALL, LARGE = 30_000_000, 120_000_000
"""Bytes of the files."""
BOUND = 15_000
"""KiB by which the peak may grow."""
OWN_CODE = b"\x01\xe0"
"""A message id that is left to vendors; decode prints its bytes."""
VERB = """
import sys
from pathlib import Path
from jauspy.cli.main import main
try:
    main()
finally:
    sys.stdout.flush()
    sys.stderr.write(Path("/proc/self/status").read_text())
"""


def ip_packets(size: int) -> Iterator[tuple[int, bytes]]:
    """Times (ns) and IP packets of datagrams of 1.2 kB, and of a pose in every tenth, until a file has this size."""
    payloads = [ReportLocalPose(x=1.5, yaw=0.5).encode(), *[OWN_CODE + bytes(range(240)) * 5] * 9]
    written = number = 0
    while written < size:
        datagram = judp.pack(Packet(JausID(1, 1, 1), JausID(2, 1, 1), payloads[number % 10], number & 0xFFFF))
        packet = writer.ip_packet(*HOSTS, datagram)
        yield number * 1_000_000, packet
        written += len(packet)
        number += 1


def write_pcap(path: Path, size: int) -> None:
    with path.open("wb") as file:
        file.write(struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 65535, writer.LINKTYPE_RAW))
        for time, packet in ip_packets(size):
            seconds, rest = divmod(time, 10**9)
            file.write(struct.pack("<IIII", seconds, rest // 1000, len(packet), len(packet)) + packet)


def write_pcapng(path: Path, size: int) -> None:
    with path.open("wb") as file:
        file.write(writer.preamble())
        for time, packet in ip_packets(size):
            file.write(writer.packet(*HOSTS, packet[28:], time))


def write_mcap(path: Path, size: int) -> None:
    mcap = pytest.importorskip("mcap.writer", reason="mcap is of the extra `recording`")
    with path.open("wb") as file:
        run = mcap.Writer(file, chunk_size=CHUNK_SIZE, compression=mcap.CompressionType.NONE)
        run.start("jaus", "test")
        channel = run.register_channel(DATAGRAMS, ENCODING, 0)
        for time, packet in ip_packets(size):
            run.add_message(channel, time, packet, time)
        run.finish()


def peak(path: Path, *options: str) -> int:
    """KiB of memory that decoding the file took at most."""
    command = [sys.executable, "-c", VERB, "decode", str(path), *options]
    done = subprocess.run(
        command, check=False, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, timeout=300
    )
    found = re.search(r"^VmHWM:\s+(\d+) kB", done.stderr, re.MULTILINE)
    assert done.returncode == 0, done.stderr
    assert found is not None, done.stderr
    return int(found[1])


@pytest.mark.parametrize(
    ("write", "options"),
    [
        pytest.param(write_pcap, ["--json"], marks=pytest.mark.long),
        (write_pcapng, ["--format", "csv", "--filter", "msg == ReportLocalPose"]),
        (write_mcap, ["--json"]),
    ],
)
def test_the_peak_does_not_grow_with_the_file(
    tmp_path: Path, write: Callable[[Path, int], None], options: list[str]
) -> None:
    peaks = []
    for size in (SMALL, LARGE):
        path = tmp_path / f"{size}.capture"
        write(path, size)
        assert path.stat().st_size >= size
        peaks.append(peak(path, *options))
        path.unlink()
    assert peaks[1] - peaks[0] < BOUND, peaks
