"""How fast `jauspy decode` prints a capture, as whole processes, and as ratios to decoding alone in the same run.

python tools/bench/decode.py [--messages 100000] [--runs 3]

The capture has what a robot on tracks with an arm sends and is sent, one message a datagram. The start of the process
is measured with a capture of one message, and subtracted.
"""

from __future__ import annotations

import argparse
import resource
import subprocess
import sys
import tempfile
import time
from itertools import cycle, islice
from pathlib import Path

from jauspy.capture.writer import packet as block, preamble
from jauspy.codec.message import Message
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import QueryHeartbeatPulse, ReportHeartbeatPulse, ReportStatus
from jauspy.messages.manipulator import JointPositionRec, ReportJointPositions
from jauspy.messages.mobility import (
    QueryLocalPose,
    ReportLocalPose,
    ReportVelocityState,
    ReportWrenchEffort,
    SetWrenchEffort,
)
from jauspy.protocol import judp
from jauspy.protocol.header import Packet

ROBOT, OPERATOR = JausID(101, 1, 102), JausID(42, 1, 1)
HOSTS = (("10.0.0.7", 3794), ("10.0.0.2", 3794))
FORMATS = {"JSON": ["--json"], "text": []}
GOALS = {"JSON": 50_000, "text": 20_000}
"""Messages a second."""


def messages() -> list[Message]:
    """A cycle of traffic: poses, velocities and joints with all their fields, commands, and small messages."""
    return [
        ReportLocalPose(x=12.3, y=-4.5, z=0.1, position_rms=0.02, roll=0.01, pitch=-0.02, yaw=1.2, attitude_rms=0.01),
        ReportVelocityState(velocity_x=0.8, yaw_rate=0.1, velocity_rms=0.01),
        ReportJointPositions([JointPositionRec(joint_position=_angle(0.3 * number)) for number in range(5)]),
        SetWrenchEffort(propulsive_linear_effort_x=40.0, propulsive_rotational_effort_z=-5.0),
        ReportWrenchEffort(propulsive_linear_effort_x=40.0, propulsive_rotational_effort_z=-5.0),
        QueryLocalPose(),
        QueryHeartbeatPulse(),
        ReportHeartbeatPulse(),
        ReportStatus(status=ReportStatus.Status.READY, reserved=0),
        ReportLocalPose(x=1.0, y=2.0, yaw=0.5),
    ]


def _angle(value: float) -> JointPositionRec.JointPosition:
    return JointPositionRec.JointPosition(JointPositionRec.JointPositionChoice(1), value)


def capture(path: Path, payloads: list[bytes]) -> None:
    """Write a pcapng file, a millisecond between two datagrams."""
    with path.open("wb") as file:
        file.write(preamble())
        for number, payload in enumerate(payloads):
            datagram = judp.pack(Packet(ROBOT, OPERATOR, payload, sequence=number & 0xFFFF))
            file.write(block(*HOSTS, datagram, 1_790_000_000_000_000_000 + number * 1_000_000))


def processor_seconds(path: Path, options: list[str]) -> float:
    """Of one whole process, whose output is a file."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with path.with_suffix(".out").open("wb") as output:
        subprocess.run(
            [sys.executable, "-m", "jauspy.cli.main", "decode", str(path), *options], stdout=output, check=True
        )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def decoding_alone(payloads: list[bytes]) -> float:
    """Seconds that the codec needs for the messages."""
    began = time.process_time()
    for payload in payloads:
        registry.decode(payload)
    return time.process_time() - began


def main() -> None:
    """Print a line for each format."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--messages", type=int, default=100_000)
    parser.add_argument("--runs", type=int, default=3, help="the fastest counts")
    options = parser.parse_args()
    payloads = list(islice(cycle([message.encode() for message in messages()]), options.messages))
    alone = min(decoding_alone(payloads) for _ in range(options.runs))
    print(f"{'format':8}{'messages/s':>12}{'start':>9}{'codec alone':>14}{'ratio':>8}  goal")
    with tempfile.TemporaryDirectory() as folder:
        path, one = Path(folder, "run.pcapng"), Path(folder, "one.pcapng")
        capture(path, payloads)
        capture(one, payloads[:1])
        for name, arguments in FORMATS.items():
            start = min(processor_seconds(one, arguments) for _ in range(options.runs))
            taken = min(processor_seconds(path, arguments) for _ in range(options.runs)) - start
            print(
                f"{name:8}{len(payloads) / taken:12.0f}{start:7.2f} s{len(payloads) / alone:10.0f} /s"
                f"{taken / alone:8.1f}  {GOALS[name]}/s"
            )


if __name__ == "__main__":
    main()
