"""`jauspy still`: take a picture with a camera and save it."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Annotated, Final

import typer

from jauspy.cli import client, console
from jauspy.cli.options import Connect, OperatorKey, OwnId, Timeout
from jauspy.cli.processes import run
from jauspy.errors import ConfigError, ResponseTimeout
from jauspy.ids import JausID
from jauspy.ocu import OCU
from jauspy.ocu.stills import LARGE_IMAGE_DELIVERY


def still(
    *,
    camera: Annotated[str, typer.Argument(metavar="ID", help="The component of the camera, as in 101.1.106.")],
    output: Annotated[
        Path, typer.Option("-o", "--output", "--save", metavar="FILE", help="The file: .jpg, .jpeg or .png.")
    ],
    size: Annotated[
        str | None,
        typer.Option(
            "--size", metavar="WxH", help="Size of the picture, as in 1280x720.  [default: the camera's setting]"
        ),
    ] = None,
    sensor: Annotated[int, typer.Option("--sensor", min=1, max=65535, help="The sensor id of the camera.")] = 1,
    connect: Connect = None,
    own_id: OwnId = None,
    operator_key: OperatorKey = None,
    timeout: Timeout = 20.0,
) -> None:
    """Take a picture with a camera and save it.

    The suffix of the file selects JPEG or PNG. If the size or format differs from the camera's settings, control is
    taken, the settings are changed for this picture, and restored.

    Examples:
      jauspy still 101.1.106 -o arm.jpg
      jauspy still 101.1.107 -o front.png --size 1280x720
    """
    component = client.destination(camera)
    if component.is_wildcard:
        raise ConfigError(f"{component} has wildcards; name one component")
    wanted = size_of(size), format_of(output)
    ocu = OCU(client.own_id(own_id, connect), connect, delivery=LARGE_IMAGE_DELIVERY, operator=operator_key)
    run(take_picture(ocu, component, sensor, *wanted, file=output, max_wait=timeout))


FORMATS: Final = {".jpg": "jpeg", ".jpeg": "jpeg", ".png": "png"}


def format_of(file: Path) -> str:
    """The format of a file, from its suffix."""
    format = FORMATS.get(file.suffix.lower())
    if format is None:
        raise ConfigError(f"the format of {file} is unknown; use a suffix of {', '.join(FORMATS)}")
    if not file.absolute().parent.is_dir():
        raise ConfigError(f"the directory {file.parent} does not exist")
    return format


def size_of(text: str | None) -> tuple[int, int] | None:
    """Width and height from text such as 640x480."""
    if text is None:
        return None
    found = re.fullmatch(r"(\d{1,5})[xX](\d{1,5})", text)
    if found is None:
        raise ConfigError(f"{text!r} is not a size, as in --size 640x480")
    return int(found[1]), int(found[2])


async def take_picture(
    ocu: OCU, camera: JausID, sensor: int, size: tuple[int, int] | None, format: str, *, file: Path, max_wait: float
) -> None:
    """Take a picture and save it."""
    async with ocu:
        robot = await ocu.discover(camera.subsystem)
        service = robot.component(str(camera)).service("StillImage")
        try:
            photo = await service.still(size=size, format=format, sensor=sensor, timeout=max_wait)
        except ResponseTimeout as error:
            from jauspy.cli.video import said_by

            note = await said_by(ocu, camera, sensor)
            raise ResponseTimeout(f"{error}; {camera} says: {note}" if note else str(error)) from None
    _write(file, photo.content)
    taken = photo.taken
    when = f", taken at {taken:%H:%M:%S}.{taken.microsecond // 1000:03} UTC" if taken else ""
    what = f"{photo.format} by sensor {photo.sensor} of {camera}, {len(photo.content):,} bytes{when}"
    console.print_lines(f"{file}: {what}")


def _write(file: Path, content: bytes) -> None:
    try:
        file.write_bytes(content)
    except OSError as error:
        raise ConfigError(f"cannot write {file}: {error}") from error
