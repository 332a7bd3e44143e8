"""Reading the key that node managers share."""

from __future__ import annotations

import secrets
import stat
from pathlib import Path

from jauspy.errors import ConfigError
from jauspy.protocol import seal
from jauspy.protocol.seal import Seal


def load(path: Path | None) -> Seal | None:
    """A seal with the key in this file, without white space around it; None without a file.

    Raises `ConfigError` when the key is short, or when everybody may read it.
    """
    if path is None:
        return None
    try:
        mode = path.stat().st_mode
        key = path.read_bytes().strip()
    except OSError as error:
        raise ConfigError(f"key_file {path}: {error.strerror}") from error
    if mode & stat.S_IROTH:
        raise ConfigError(f"key_file {path}: everybody may read it; do: chmod o-rwx {path}")
    if len(key) < seal.MIN_KEY:
        raise ConfigError(
            f"key_file {path}: has {len(key)} bytes, needs {seal.MIN_KEY}; make one with: openssl rand -hex 32"
        )
    return Seal(key, secrets.randbits(64))
