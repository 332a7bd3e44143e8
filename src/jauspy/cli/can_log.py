"""Logs of CAN frames (candump and what else python-can reads), line by line, for `jauspy decode`."""

from __future__ import annotations

import re
from collections.abc import Iterator
from importlib.util import find_spec
from pathlib import Path
from typing import Final

from jauspy.errors import ConfigError
from jauspy.printable import printable

CANDUMP: Final = re.compile(rb"\(\d+\.\d+\) +\S+ +[0-9A-Fa-f]+#")
"""The first line of a file that `candump -l` writes."""

SUFFIXES: Final = frozenset({".asc", ".blf", ".trc"})
"""Other formats of python-can, which are known by their names."""


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


def can_lines(source: str, robot: str) -> Iterator[str]:
    """Time, identifier and meaning of each frame, with the drives of `robot`. Raises `ConfigError`."""
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
                what = "error frame" if frame.is_error_frame else names.explain(frame.arbitration_id, bytes(frame.data))
                yield printable(f"{frame.timestamp:.6f}  {frame.arbitration_id:03X}  {what}")
    except (ValueError, OSError, IndexError) as error:
        raise ConfigError(f"{source}: is not a log of CAN frames: {error}") from error
