"""What `jauspy record` and `jauspy live` share: descriptions of robots, and cameras whose video is taken along."""

from __future__ import annotations

import asyncio
import re
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import AsyncExitStack, contextmanager
from typing import TYPE_CHECKING, Annotated, Final, NamedTuple

import typer

from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.recording.described_robot import DescribedRobot
from jauspy.recording.recorder import Picture

if TYPE_CHECKING:
    from jauspy.ocu import OCU

Robots = Annotated[
    list[str] | None,
    typer.Option(
        "--robot",
        metavar="ROBOT",
        help="A robot's name, as in inc1, or the path of its .toml file, for its meshes and frames. May be repeated.",
    ),
]
Cameras = Annotated[
    list[str] | None,
    typer.Option(
        "--video",
        metavar="ID",
        help="A camera whose video is taken along, as in 101.1.106 or 101.1.106/SENSOR. May be repeated.",
    ),
]
MAX_CAMERAS: Final = 8
START_TIMEOUT: Final = 20.0
"""Seconds until all cameras have agreed to send."""


class Camera(NamedTuple):
    """A camera, by its component and its sensor id."""

    component: JausID
    sensor: int

    def __str__(self) -> str:
        return str(self.component) if self.sensor == 1 else f"{self.component}/{self.sensor}"


def described(names: Sequence[str] | None) -> dict[int, DescribedRobot]:
    """The descriptions of robots, by subsystem. Raises `ConfigError`."""
    if not names:
        return {}
    from jauspy.robot import robot_files

    found: dict[int, DescribedRobot] = {}
    for name in names:
        config = robot_files.load(name)
        if config.subsystem in found:
            raise ConfigError(f"--robot {name}: another --robot has the same subsystem, {config.subsystem}")
        found[config.subsystem] = DescribedRobot(config.subsystem, robot_files.robot_model(config), config.movers)
    return found


def cameras(names: Sequence[str] | None) -> list[Camera]:
    """The cameras of `--video`. Raises `ConfigError`."""
    if not names:
        return []
    from jauspy.cli import client  # takes seconds

    found = []
    for name in names:
        component, slash, sensor = name.partition("/")
        camera = client.destination(component)
        if camera.is_wildcard or (slash and not re.fullmatch(r"[1-9]\d{0,4}", sensor)):
            raise ConfigError(f"--video {name}: name one camera, as 101.1.106 or 101.1.106/2")
        found.append(Camera(camera, int(sensor or 1)))
    if len(found) > MAX_CAMERAS:
        raise ConfigError(f"--video: at most {MAX_CAMERAS} cameras")
    return found


async def take_pictures(
    ocu: OCU, wanted: Sequence[Camera], add: Callable[[Picture], None], started: Callable[[], None]
) -> None:
    """Have cameras send their video here, and hand over each picture as it came, until cancelled."""
    from jauspy.cli.video import registered, url_of
    from jauspy.video.h264_payload import join_nals
    from jauspy.video.receiver import RtpReceiver

    loop = asyncio.get_running_loop()
    async with AsyncExitStack() as stack:
        await stack.enter_async_context(ocu)
        for camera in wanted:
            await ocu.discover(camera.component.subsystem)
            host = await ocu.address_towards(camera.component)
            receiver = stack.enter_context(RtpReceiver(host))

            def take(receiver: RtpReceiver = receiver, name: str = str(camera)) -> None:
                for picture in receiver.take():
                    add(Picture(name, time.time(), join_nals(picture.nals), picture.is_idr))

            loop.add_reader(receiver.fileno(), take)
            stack.callback(loop.remove_reader, receiver.fileno())
            url = url_of((host, receiver.port))
            await stack.enter_async_context(registered(ocu, camera.component, camera.sensor, url))
        started()
        await asyncio.Event().wait()


@contextmanager
def pictures_taken(ocu: OCU | None, wanted: Sequence[Camera], add: Callable[[Picture], None]) -> Iterator[None]:
    """The same in a thread while the context is open; entered when all cameras send."""
    if ocu is None:
        yield
        return
    started = threading.Event()
    problems: list[BaseException] = []
    loop = asyncio.new_event_loop()
    task = loop.create_task(take_pictures(ocu, wanted, add, started.set))

    def work() -> None:
        asyncio.set_event_loop(loop)
        try:
            loop.run_until_complete(task)
        except asyncio.CancelledError:
            pass
        except BaseException as error:  # noqa: BLE001 - raised in the thread that waits
            problems.append(error)
        finally:
            loop.close()
            started.set()

    thread = threading.Thread(target=work, name="video", daemon=True)
    thread.start()
    try:
        if not started.wait(START_TIMEOUT):
            raise ConfigError(f"the cameras have not answered within {START_TIMEOUT:g} s")
        if not problems:
            yield
    finally:
        if thread.is_alive():
            loop.call_soon_threadsafe(task.cancel)
        thread.join()
    if problems:
        raise problems[0]
