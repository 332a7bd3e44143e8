"""Logs of CAN frames (candump and what else python-can reads), for `jauspy decode`."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import Any, Final

from jauspy.errors import ConfigError
from jauspy.printable import printable

CANDUMP: Final = re.compile(rb"\(\d+\.\d+\) +\S+ +[0-9A-Fa-f]+#")
"""The first line of a file that `candump -l` writes."""

SUFFIXES: Final = frozenset({".asc", ".blf", ".trc"})
"""Other formats of python-can, which are known by their names."""

NUMBER: Final = re.compile(r"-?\d+\.\d+")


@dataclass(frozen=True, slots=True)
class CanFrame:
    """One frame. `time` is in seconds since 1970, UTC; `text` says what it means."""

    time: float
    identifier: int
    data: bytes
    text: str
    channel: str = ""

    def as_json(self) -> dict[str, Any]:
        """The frame as a JSON object."""
        return {
            "time": self.time,
            "channel": self.channel or None,
            "can_id": f"{self.identifier:03X}",
            "hex": self.data.hex(),
            "text": self.text,
        }


def is_can_log(source: str) -> bool:
    """True for the path of a file with CAN frames."""
    path = Path(source)
    try:
        if not path.is_file():
            return False
        with path.open("rb") as file:
            return path.suffix.lower() in SUFFIXES or CANDUMP.match(file.read(200)) is not None
    except OSError:
        return False


def can_frames(source: str, robot: str) -> Iterator[CanFrame]:
    """The frames, named by the drives of `robot`. Raises `ConfigError`."""
    if find_spec("can") is None:
        raise ConfigError("CAN logs need python-can: pip install 'jauspy[can]'")
    import can

    from jauspy.modules import robot_files
    from jauspy.platform.can.names import FrameNames

    model = robot_files.robot_model(robot_files.load(robot))
    if model.can is None or isinstance(model.can, str):
        raise ConfigError(model.can or f"{robot} has no table [can] in its file")
    names = FrameNames(model, model.can)
    reader = can.CanutilsLogReader if Path(source).suffix.lower() not in SUFFIXES else can.LogReader
    try:
        with reader(source) as frames:
            for frame in frames:
                data = bytes(frame.data)
                what = "error frame" if frame.is_error_frame else names.explain(frame.arbitration_id, data)
                channel = "" if frame.channel is None else str(frame.channel)
                yield CanFrame(frame.timestamp, frame.arbitration_id, data, printable(what), channel)
    except (ValueError, OSError, IndexError) as error:
        raise ConfigError(f"{source}: is not a log of CAN frames: {error}") from error


def changes(frames: Iterable[CanFrame]) -> Iterator[CanFrame]:
    """Of the frames of each identifier those that say something else than the last one, not only another number.

    That a number becomes zero, or changes its sign, counts.
    """
    said: dict[int, str] = {}
    for frame in frames:
        gist = NUMBER.sub(lambda found: _sign(float(found[0])), frame.text)
        if said.get(frame.identifier) != gist:
            said[frame.identifier] = gist
            yield frame


def _sign(number: float) -> str:
    return "0" if not number else "+" if number > 0.0 else "-"
