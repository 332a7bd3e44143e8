"""Simulated drives on a bus at 200 Hz: jitter of SYNC, time from a command to its frame, PDOs missed, share of a CPU.

    python tools/bench/can_bus.py [--bus udp_multicast:239.0.0.77,port=43277] [--seconds 30] [--cameras]

Drives and master share the machine, with --cameras also a simulated robot whose three cameras are recorded.
Beside the jitter stands that of an empty loop with the same period, measured at the same time.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import threading
import time
from contextlib import ExitStack
from dataclasses import replace
from tempfile import TemporaryDirectory

from jauspy.backends import find
from jauspy.backends.can.robot import CanRobot
from jauspy.platform.servo_drives import CanSetup
from jauspy.robot.robot_files import load, robot_model


def percentiles(values: list[float]) -> str:
    """Median and 99th percentile in milliseconds."""
    ordered = sorted(map(abs, values))
    return f"p50 {1e3 * ordered[len(ordered) // 2]:.2f} ms, p99 {1e3 * ordered[len(ordered) * 99 // 100]:.2f} ms"


def empty_loop(period: float, ending: threading.Event, late: list[float]) -> None:
    """How late a loop without work is."""
    due = time.monotonic()
    while not ending.is_set():
        due += period
        time.sleep(max(0.0, due - time.monotonic()))
        late.append(time.monotonic() - due)
        due = max(due, time.monotonic() - period)


def main() -> None:
    """Run it and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--bus", default="udp_multicast:239.0.0.77,port=43277")
    parser.add_argument("--seconds", type=float, default=30.0)
    parser.add_argument("--rate", type=float, default=200.0)
    parser.add_argument("--cameras", action="store_true")
    options = parser.parse_args()
    model = robot_model(load("inc1"))
    if not isinstance(model.can, CanSetup):
        sys.exit("inc1 has no drives")
    setup = replace(model.can, bus=options.bus, heartbeat_timeout=1.0, status_timeout=1.0, sync_rate=options.rate)
    with ExitStack() as stack:
        start(stack, "can", "simulate", "inc1", "--bus", options.bus)
        if options.cameras:
            record_cameras(stack, options.seconds)
        robot = find("can").open(replace(model, can=setup), "empty")
        assert isinstance(robot, CanRobot)
        measure(robot, options.seconds)
        robot.close()


def start(stack: ExitStack, *arguments: str, waits: bool = True) -> None:
    """Run `jauspy` with these arguments until the stack closes; returns when it has printed a line if it `waits`."""
    command = [sys.executable, "-m", "jauspy.cli.main", *arguments]
    process = stack.enter_context(subprocess.Popen(command, stdout=subprocess.PIPE, text=True))
    stack.callback(process.terminate)
    assert process.stdout is not None
    if waits:
        process.stdout.readline()


def record_cameras(stack: ExitStack, seconds: float) -> None:
    """Simulate a robot, and record its cameras, beside the measurement."""
    folder = stack.enter_context(TemporaryDirectory(prefix="jauspy-"))
    start(stack, "up", "inc1", "--backend", "sim", "--port", "3989", "--interface", "127.0.0.1", "--local-root", folder)
    for number, camera in enumerate(("101.1.106", "101.1.107", "101.1.109")):
        file = f"{folder}/{camera}.mp4"
        start(
            stack,
            "video",
            camera,
            "--save",
            file,
            "--to",
            f"127.0.0.1:{43300 + 2 * number}",
            "--seconds",
            f"{seconds}",
            "--connect",
            f"local:{folder}",
            waits=False,
        )
    time.sleep(20.0)


def measure(robot: CanRobot, seconds: float) -> None:
    """Drive, and print what was measured."""
    late = robot.measure_lateness()
    idle: list[float] = []
    delays: list[float] = []
    ending = threading.Event()
    other = threading.Thread(target=empty_loop, args=(robot.master.period, ending, idle))
    other.start()
    syncs, received = robot.master.counters["syncs"], {name: each.received for name, each in robot.drives.items()}
    cpu, begin = time.process_time(), time.monotonic()
    effort = 0.3
    while time.monotonic() < begin + seconds:
        effort = -effort
        commanded = time.monotonic()
        count = robot.master.counters["syncs"]
        robot.drive.set_effort(effort, 0.0)
        while robot.master.counters["syncs"] == count:
            time.sleep(0.0002)
        delays.append(time.monotonic() - commanded)
        for _ in range(100):
            robot.advance(0.002)
            time.sleep(0.002)
    spent, share = time.monotonic() - begin, time.process_time() - cpu
    ending.set()
    other.join()
    syncs = robot.master.counters["syncs"] - syncs
    missed = sum(max(0, syncs - (each.received - received[name])) for name, each in robot.drives.items())
    print(f"{len(robot.drives)} drives, {syncs / spent:.1f} SYNC/s")
    print(f"lateness of SYNC:  {percentiles(late)}; of an empty loop: {percentiles(idle)}")
    print(f"command to SYNC:   {percentiles(delays)}")
    print(f"PDOs missed:       {missed} of {syncs * len(robot.drives)}; not sent: {robot.master.counters['unsent']}")
    print(f"CPU of the master: {100.0 * share / spent:.0f} % of a core")


if __name__ == "__main__":
    main()
