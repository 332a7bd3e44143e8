"""The drives of a robot's file, matched to its URDF and their EDS files."""

from __future__ import annotations

import configparser
from collections.abc import Mapping
from pathlib import Path

from jauspy.errors import ConfigError
from jauspy.geometry.urdf import JointKind, RobotDescription
from jauspy.platform.description import GroupSetup, TrackSetup
from jauspy.platform.servo_drives import CanSetup, CanTable, DriveSetup, DriveTable
from jauspy.platform.tables import values_of
from jauspy.user_files import read_file


def can_setup(
    table: CanTable, description: RobotDescription, tracks: TrackSetup | None, groups: Mapping[str, GroupSetup]
) -> CanSetup:
    """Return the setup for the backend. Raises `ConfigError` with the key that does not match the robot."""
    drives: dict[str, DriveSetup] = {}
    moved: dict[str, str] = {}
    for name, drive in table.drives.items():
        key = f"can.drives.{name}"
        moves = _moved_by(key, drive, tracks, groups)
        what = f"{drive.track} track" if drive.track else f"joint {moves!r}"
        if what in moved:
            raise ConfigError(f"{key}: the drive {moved[what]!r} moves the {what} already")
        moved[what] = name
        if description.joint(moves).kind is JointKind.PRISMATIC and drive.travel is None:
            raise ConfigError(
                f"{key}.travel: is missing; {moves!r} is prismatic: give the metres of one turn of the gear's output"
            )
        drives[name] = _drive(name, drive, moves, key, table.temperature)
    sides = ("left", "right") if tracks else ()
    wanted = [*(f"{side} track" for side in sides), *(f"joint {j!r}" for g in groups.values() for j in g.joints)]
    if missing := [what for what in wanted if what not in moved]:
        raise ConfigError(f"can.drives: no drive moves the {missing[0]}; add a table [can.drives.NAME]")
    return CanSetup(**values_of(table, CanTable) | {"drives": drives})


def _moved_by(key: str, drive: DriveTable, tracks: TrackSetup | None, groups: Mapping[str, GroupSetup]) -> str:
    if drive.joint is not None:
        known = [joint for group in groups.values() for joint in group.joints]
        if drive.joint not in known:
            raise ConfigError(f"{key}.joint = {drive.joint!r}: is in no group; those of groups are: {', '.join(known)}")
        return drive.joint
    if tracks is None:
        raise ConfigError(f"{key}.track: the robot has no [tracks]")
    return tracks.left[0] if drive.track == "left" else tracks.right[0]


def _drive(name: str, drive: DriveTable, moves: str, key: str, temperature: int | None) -> DriveSetup:
    vendor, product = drive.vendor, drive.product
    if drive.eds is not None:
        try:
            found = identity_of(Path(drive.eds))
        except ConfigError as error:
            raise ConfigError(f"{key}.eds: {error}") from error
        vendor, product = vendor or found[0], product or found[1]
    known = {"vendor": vendor, "product": product, "temperature": drive.temperature or temperature}
    return DriveSetup(**values_of(drive, DriveTable) | known, name=name, moves=moves)


def identity_of(path: Path) -> tuple[int | None, int | None]:
    """Vendor and product code in a drive's EDS file (CiA 306); None for missing entries. Raises `ConfigError`."""
    parser = configparser.RawConfigParser(strict=False, allow_no_value=True)
    try:
        parser.read_string(read_file(path).decode("utf-8", "replace"))
    except configparser.Error as error:
        line = getattr(error, "lineno", 0)  # its text has the content of the line, which may be of any file
        raise ConfigError(f"{path}{f':{line}' if line else ''}: is not an EDS file: {type(error).__name__}") from error
    if not parser.has_section("DeviceInfo"):
        raise ConfigError(f"{path}: is not an EDS file: it has no section [DeviceInfo]")
    found = []
    for key in ("VendorNumber", "ProductNumber"):
        text = parser.get("DeviceInfo", key, fallback=None)
        try:
            found.append(int(text, 0) or None if text else None)
        except ValueError:
            raise ConfigError(f"{path}: {key}={text!r} is not a number") from None
    return found[0], found[1]
