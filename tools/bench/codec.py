"""How fast the codec is, as ratios to other code that is measured in the same run.

python tools/bench/codec.py [--seconds 0.3] [--rows 2]
"""

from __future__ import annotations

import argparse
import json
import statistics
import subprocess
import sys
import time
import timeit
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import _by_hand as hand
import _models
from _construct import compiled
from pymavlink.dialects.v20 import common as mavlink

from jauspy.codec.message import Message
from jauspy.messages import registry
from jauspy.messages.core import ReportServices
from jauspy.messages.mobility import ReportVelocityState
from jauspy.schema import load_builtin

ROOT = Path(__file__).parents[2]
Call = Callable[[], object]


def compare(own: Call, theirs: Call, seconds: float) -> tuple[float, float]:
    """Nanoseconds per call of both, by turns, because a machine is not equally fast all the time; the best counts."""
    timers = [timeit.Timer(call, timer=time.process_time) for call in (own, theirs)]
    numbers = [max(1, int(seconds / 15 / max(timer.timeit(20) / 20, 1e-9))) for timer in timers]
    rounds = [[timer.timeit(number) / number for timer, number in zip(timers, numbers, strict=True)] for _ in range(15)]
    best = [min(column) * 1e9 for column in zip(*rounds, strict=True)]
    return best[0], best[1]


def show(name: str, own: float, theirs: float, ratio: float, goal: str) -> None:
    """One line."""
    print(f"{name:34}{own:9.0f} ns{theirs:9.0f} ns{ratio:8.2f}  {goal}")


def head(title: str, theirs: str) -> None:
    """What the columns are."""
    print(f"\n{title:34}{'generated':>12}{theirs:>12}{'ratio':>8}  goal")


def against_hand(seconds: float) -> None:
    """Three messages for which the code is written by hand."""
    velocity = bytes.fromhex("0444ff01" + "78563412" * 4 + "3412" * 4 + "e7effbfd")
    uri = b"urn:jaus:jss:mobility:PrimitiveDriver"
    component = b"\x01\x00\x04" + (bytes([len(uri)]) + uri + b"\x01\x01") * 4
    services = b"\x03\x4b\x02" + (b"\x01\x03" + component * 3) * 2
    efforts = b"\x01\xd6\x06" + bytes.fromhex("000034127856bc9adef0ffff")
    set_efforts = _models.registry().by_name("SetEfforts")
    rows: tuple[tuple[type[Message], bytes, Callable[[bytes], Any], Callable[[Any], bytes]], ...] = (
        (ReportVelocityState, velocity, hand.velocity_decode, hand.velocity_encode),
        (set_efforts, efforts, hand.efforts_decode, hand.efforts_encode),
        (ReportServices, services, hand.services_decode, hand.services_encode),
    )
    head("against code written by hand", "by hand")
    for cls, data, decode, encode in rows:
        own, theirs = cls.decode(data), decode(data)
        assert own.encode() == encode(theirs) == data
        for verb, mine, other in (
            ("decode", partial(cls.decode, data), partial(decode, data)),
            ("encode", own.encode, partial(encode, theirs)),
        ):
            a, b = compare(mine, other, seconds)
            show(f"{cls.NAME} {verb}", a, b, a / b, "at most 1.2")


def golden(most: int) -> Iterator[tuple[type[Message], bytes]]:
    """Messages of the committed golden rows: of each kind the longest ones."""
    found: dict[type[Message], set[bytes]] = {}
    for file in sorted((ROOT / "tests" / "golden").glob("*-*.jsonl")):
        for line in file.read_text("utf-8").splitlines():
            row = json.loads(line)
            for cls in registry.by_code(int(row["code"], 16)):
                if (row["message"], row["version"]) == (cls.NAME, cls.VERSION):
                    found.setdefault(cls, set()).add(bytes.fromhex(row["hex"]))
    for cls, messages in found.items():
        for data in sorted(messages, key=lambda data: (-len(data), data))[:most]:
            yield cls, data


def against_construct(seconds: float, most: int) -> None:
    """The mix of all messages, with the same values, and without scaling, names, strings and bit fields."""
    models = {(s.id, s.version, msg.name): msg for s in load_builtin().services for msg in s.messages}
    rows = list(golden(most))
    head(f"{len(rows)} golden messages, median", "construct")
    for values in (True, False):
        times: dict[str, list[tuple[float, float]]] = {"decode": [], "encode": []}
        for cls, data in rows:
            peer = compiled(models[cls.SERVICE, cls.VERSION, cls.NAME], values=values)
            own, theirs = cls.decode(data), peer.parse(data)
            assert peer.build(theirs) == own.encode() == data
            for verb, mine, other in (
                ("decode", partial(cls.decode, data), partial(peer.parse, data)),
                ("encode", own.encode, partial(peer.build, theirs)),
            ):
                times[verb].append(compare(mine, other, seconds))
        for verb, found in times.items():
            a, b = (statistics.median(column) for column in zip(*found, strict=True))
            ratios = [theirs / mine for mine, theirs in found]
            what = "the same values" if values else "raw structure only"
            goal = f"{'at least 8 ' if values else ''}(here {min(ratios):.1f} to {max(ratios):.1f})"
            show(f"{verb}, {what}", a, b, statistics.median(ratios), goal)


def against_mavlink(seconds: float) -> None:
    """The same fields in both formats."""
    mav = mavlink.MAVLink(None)
    six = (1.0, 2.0, 3.0, 4.0, 5.0, 6.0)
    covariance = [float(number) for number in range(21)]
    attitude = mav.attitude_encode(1000, *six).pack(mav)
    pose = (10**15, 1, 2, 0.5, 1.5, 2.5, [1.0, 0.0, 0.0, 0.0])
    odometry = mav.odometry_encode(*pose, *six, covariance, covariance, 3, 1, 90).pack(mav)
    models = _models.registry()
    own_attitude = models.by_name("Attitude").from_dict(
        dict(
            zip(
                ("time_boot_ms", "roll", "pitch", "yaw", "roll_speed", "pitch_speed", "yaw_speed"),
                (1000, *six),
                strict=True,
            )
        )
    )
    own_odometry = models.by_name("Odometry").from_dict(
        {
            **dict(zip(("time_usec", "frame_id", "child_frame_id", "x", "y", "z", "q"), pose, strict=True)),
            **dict(zip(("vx", "vy", "vz", "roll_speed", "pitch_speed", "yaw_speed"), six, strict=True)),
            "pose_covariance": covariance,
            "velocity_covariance": covariance,
            "reset_counter": 3,
            "estimator_type": 1,
            "quality": 90,
        }
    )
    velocity = ReportVelocityState.decode(bytes.fromhex("0444ff01" + "78563412" * 4 + "3412" * 4 + "e7effbfd"))
    head("decoding against pymavlink", "pymavlink")
    for name, packed, message in (
        ("ATTITUDE, the same fields", attitude, own_attitude),
        ("ATTITUDE, ReportVelocityState", attitude, velocity),
        ("ODOMETRY, the same fields", odometry, own_odometry),
    ):
        data, cls = message.encode(), type(message)
        assert mav.decode(bytearray(packed)) is not None
        a, b = compare(partial(cls.decode, data), partial(mav.decode, bytearray(packed)), seconds)
        show(name, a, b, b / a, "at least 2")


def first_use() -> None:
    """What the first encode and decode of a message cost more than the next ones, as their code is made then."""
    rows = [(cls, data) for cls, data in golden(1) if cls.__mro__[1] is Message]  # the others use the code of these
    rows[0][0].decode(rows[0][1]).encode()  # imports what makes code
    print(f"\n{f'first use of {len(rows)} messages':34}{'median':>12}{'largest':>12}")
    times: dict[str, list[float]] = {"decode": [], "encode": []}
    for cls, data in rows[1:]:
        times["decode"].append(once(partial(cls.decode, data)))
        times["encode"].append(once(cls.decode(data).encode))
    times["both"] = [sum(pair) for pair in zip(times["decode"], times["encode"], strict=True)]
    for verb, found in times.items():
        goal = "median under 1 ms, largest under 10 ms" if verb == "both" else ""
        print(f"{verb:34}{statistics.median(found) * 1e3:9.2f} ms{max(found) * 1e3:9.2f} ms{'':>8}  {goal}")


def once(call: Call) -> float:
    """Seconds of the first call beyond those of the second."""
    start = time.process_time()
    call()
    middle = time.process_time()
    call()
    return middle - start - (time.process_time() - middle)


def start(code: str) -> float:
    """Milliseconds that Python takes for some code, in a process of its own; the best of five."""
    timed = f"import time; start = time.perf_counter(); {code}; print(time.perf_counter() - start)"
    runs = [subprocess.run([sys.executable, "-c", timed], check=True, capture_output=True, text=True) for _ in range(5)]
    return min(float(run.stdout) for run in runs) * 1e3


def starting() -> None:
    """What it costs to get going, and how much source there is."""
    print(f"\n{'starting':34}{'':>12}{'':>12}{'':>8}  goal")
    rows = (
        ("import jauspy", "import jauspy", "under 150 ms"),
        ("first message", "from jauspy.messages.mobility import SetWrenchEffort", ""),
        ("first message, used", "from jauspy.messages.core import Standby as M; M.decode(M().encode())", ""),
        ("all messages", "from jauspy.messages import registry; list(registry)", ""),
        ("load all schemas", "from jauspy.schema import load_builtin; load_builtin()", "under 1000 ms"),
    )
    for name, code, goal in rows:
        print(f"{name:34}{start(code):9.0f} ms{'':>20}  {goal}")
    loading()
    files = sorted((ROOT / "src" / "jauspy" / "messages").rglob("*.py"))
    size = sum(file.stat().st_size for file in files)
    each = f"{size / len(registry):.0f} bytes for each of {len(registry)} messages"
    print(f"{'generated source':34}{size / 1e3:9.0f} kB, {each}")


def loading() -> None:
    """What a message of the definitions costs that are loaded, with and without those of IOP and AEODRS."""
    imports = "from jauspy.schema.loader import builtin_paths, load_files"
    others = "[path for path in builtin_paths() if not {'iop', 'exp'} & set(path.parts)]"
    found = []
    for paths in ("builtin_paths()", others):
        count = f"{imports}; print(sum(len(service.messages) for service in load_files({paths}).services))"
        run = subprocess.run([sys.executable, "-c", count], check=True, capture_output=True, text=True)
        found.append(start(f"{imports}; load_files({paths})") * 1e6 / int(run.stdout))
    every, before = found
    print(f"{'for each message':34}{every:9.0f} ns{before:9.0f} ns{every / before:8.2f}  at most 1.1 (without IOP)")


def main() -> None:
    """Print one line per figure."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--seconds", type=float, default=0.5, help="time for each figure (%(default)s s)")
    parser.add_argument("--rows", type=int, default=2, help="golden messages of each kind (%(default)s)")
    options = parser.parse_args()
    first_use()
    against_hand(options.seconds)
    against_construct(options.seconds / 10, options.rows)
    against_mavlink(options.seconds)
    starting()


if __name__ == "__main__":
    main()
