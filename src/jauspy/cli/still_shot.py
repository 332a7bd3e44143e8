"""What `jauspy still` does."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Final

from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.ocu import OCU

ENDINGS: Final = {".jpg": "jpeg", ".jpeg": "jpeg", ".png": "png"}


def format_of(file: Path) -> str:
    """The format that a file's name wants."""
    format = ENDINGS.get(file.suffix.lower())
    if format is None:
        raise ConfigError(f"cannot tell the format of {file}; end its name in {', '.join(ENDINGS)}")
    if not file.absolute().parent.is_dir():
        raise ConfigError(f"there is no folder {file.parent}; name another one with --save")
    return format


def size_of(text: str | None) -> tuple[int, int] | None:
    """Width and height out of 640x480."""
    if text is None:
        return None
    found = re.fullmatch(r"(\d{1,5})[xX](\d{1,5})", text)
    if found is None:
        raise ConfigError(f"{text!r} is no size; write --size 640x480")
    return int(found[1]), int(found[2])


async def shoot(
    ocu: OCU, camera: JausID, sensor: int, size: tuple[int, int] | None, format: str, *, file: Path, patience: float
) -> None:
    """Take the picture, and save it."""
    async with ocu:
        robot = await ocu.discover(camera.subsystem)
        service = robot.component(str(camera)).service("StillImage")
        photo = await service.still(size=size, format=format, sensor=sensor, timeout=patience)
    _write(file, photo.content)
    at = photo.taken
    when = f", taken at {at.hour:02}:{at.minutes:02}:{at.seconds:02}.{at.milliseconds:03} UTC" if at else ""
    print(f"{file}: {photo.format} by sensor {photo.sensor} of {camera}, {len(photo.content):,} bytes{when}")


def _write(file: Path, content: bytes) -> None:
    try:
        file.write_bytes(content)
    except OSError as error:
        raise ConfigError(f"cannot write {file}: {error}; name another file with --save") from error
