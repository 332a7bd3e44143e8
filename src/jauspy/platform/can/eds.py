"""Electronic data sheets of drives (CiA 306): whose they are."""

from __future__ import annotations

import configparser
from pathlib import Path

from jauspy.errors import ConfigError
from jauspy.user_files import read_file


def identity_of(path: Path) -> tuple[int | None, int | None]:
    """Vendor and product code of an EDS file; None for what it does not say. Raises `ConfigError`."""
    parser = configparser.RawConfigParser(strict=False, allow_no_value=True)
    try:
        parser.read_string(read_file(path).decode("utf-8", "replace"))
    except configparser.Error as error:
        raise ConfigError(f"{path}: is not an EDS file: {' '.join(str(error).split())}") from error
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
