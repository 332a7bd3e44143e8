"""What many tests share: short socket folders, free ports, two hosts on one cable, time limits for slow machines."""

import contextlib
import gc
import os
import shutil
import socket
import subprocess
import tempfile
import time
from collections.abc import Callable, Iterator, Mapping
from functools import cache
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings
from tests.helpers.ports import unused_port
from tests.node.hosts.switch import Switch

from jauspy.geometry.urdf import RobotDescription
from jauspy.logs import LIMIT
from jauspy.robot import robot_files, urdf_files
from jauspy.robot.missing_parts import MissingPolicy
from jauspy.robot.urdf_paths import PackagePaths
from jauspy.transport import age
from jauspy.video import camera_process

pytest_plugins = ("tools.second_try",)

for name in ("FORCE_COLOR", "PY_COLORS", "GITHUB_ACTIONS"):
    os.environ.pop(name, None)  # what tests read of a command has no colours

settings.register_profile("any machine", deadline=None, suppress_health_check=[HealthCheck.too_slow])
settings.load_profile("any machine")


def _reading_once() -> None:
    """Read each robot that comes with jauspy once in a test run: its files do not change, and it takes 0.2 s."""
    read, folder = urdf_files.read_urdf, str(robot_files._FOLDER)

    @cache
    def known(path: str, arguments: frozenset[tuple[str, str]]) -> RobotDescription:
        return read(path, PackagePaths(), dict(arguments))

    def instead(
        path: str,
        packages: PackagePaths,
        arguments: Mapping[str, str] | None = None,
        policy: MissingPolicy = urdf_files.STRICT,
        *,
        tell: Callable[[str], None] = urdf_files._warn,
    ) -> RobotDescription:
        if path.startswith(folder):
            return known(path, frozenset((arguments or {}).items()))
        return read(path, packages, arguments, policy, tell=tell)

    robot_files.read_urdf = instead


_reading_once()

gc.disable()  # until all tests are collected: nothing of that is garbage, and searching it takes a third of the time


MANY = 6
"""Slow cases of one test of which `make test-slow` runs every third; the others are `long`."""


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark two of three cases as long, where a slow test has many."""
    cases: dict[str, list[pytest.Item]] = {}
    for item in items:
        if item.get_closest_marker("slow") is not None:
            cases.setdefault(item.nodeid.partition("[")[0], []).append(item)
    for ones in cases.values():
        if len(ones) >= MANY:
            for number, item in enumerate(ones):
                if number % 3:
                    item.add_marker("long")


def pytest_collection_finish() -> None:
    """Do not search again and again what has been collected, some million objects."""
    gc.enable()
    gc.freeze()


def pytest_unconfigure() -> None:
    """Search them once more, or libraries in C report what is left at exit as leaked."""
    gc.unfreeze()


camera_process.NICENESS = 0
"""Processes of cameras do not wait until other tests leave them the processor, which took up to 25 s for a picture."""


@pytest.fixture(autouse=True)
def _unlimited_log() -> None:
    """No test is short of lines because of those of another one."""
    LIMIT.reset()


@pytest.fixture
def root() -> Iterator[Path]:
    """A folder for local sockets; short, because a socket's path has at most 107 bytes."""
    folder = Path(tempfile.mkdtemp(prefix="j"))
    yield folder
    shutil.rmtree(folder)


@pytest.fixture
def free_port() -> int:
    """A port that nobody uses now, for UDP and TCP on any address."""
    return unused_port()


@pytest.fixture
def kernel_stamps() -> Iterator[None]:
    """The kernel stamps datagrams; it begins to do so a moment after the first socket has asked for stamps."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as receiver:
        receiver.bind(("127.0.0.1", 0))
        receiver.setsockopt(socket.SOL_SOCKET, age._SO_TIMESTAMPNS, 1)
        deadline = time.monotonic() + 20
        waited = 0.0
        while waited < 0.002:
            assert time.monotonic() < deadline
            receiver.sendto(b"stamped", receiver.getsockname())
            time.sleep(0.003)
            _, control, *_ = receiver.recvmsg(16, 64)
            waited = age._age(control)
        yield


@pytest.fixture
def shared() -> Path:
    """The folder of vectors, captures and facts beside the repository; skips when it is not there."""
    folder = Path(__file__).resolve().parents[2] / "shared"
    if not folder.is_dir():
        pytest.skip("needs the folder 'shared' beside the repository")
    return folder


@pytest.fixture
def cable() -> Iterator[tuple[str, str]]:
    """Two namespaces, 10.77.0.1 on jv<pid>a and 10.77.0.2 on jv<pid>b, with a route for multicasts."""
    if os.geteuid() or not shutil.which("ip"):
        pytest.skip("needs root and the program ip to make network namespaces")
    names = (f"jn{os.getpid()}a", f"jn{os.getpid()}b")
    ends = (f"jv{os.getpid()}a", f"jv{os.getpid()}b")
    with contextlib.ExitStack() as stack:
        try:
            for name in names:
                _run("ip", "netns", "add", name)
                stack.callback(_run, "ip", "netns", "del", name)
            _run("ip", "link", "add", ends[0], "netns", names[0], "type", "veth", "peer", ends[1], "netns", names[1])
            for number, (name, end) in enumerate(zip(names, ends, strict=True), 1):
                _run("ip", "-n", name, "addr", "add", f"10.77.0.{number}/24", "dev", end)
                _run("ip", "-n", name, "link", "set", end, "up")
                _run("ip", "-n", name, "route", "add", "default", "dev", end)
        except subprocess.CalledProcessError as error:
            pytest.skip(f"this system makes no network namespaces: {error.stderr.decode().strip()}")
        yield names


def _run(*command: str) -> None:
    subprocess.run(command, check=True, capture_output=True, timeout=20)


@pytest.fixture
def switch() -> Iterator[Callable[[int], Switch]]:
    """Makes a number of hosts on one switch."""
    if os.geteuid() or not shutil.which("ip"):
        pytest.skip("needs root and the program ip to make network namespaces")
    with contextlib.ExitStack() as stack:

        def make(count: int) -> Switch:
            try:
                return Switch(stack, count)
            except subprocess.CalledProcessError as error:
                pytest.skip(f"this system makes no network namespaces: {error.stderr.decode().strip()}")

        yield make
