"""Reading the key that node managers share."""

from __future__ import annotations

import secrets
import stat
from pathlib import Path

from jauspy.errors import ConfigError
from jauspy.protocol import authentication
from jauspy.protocol.authentication import Authenticator


def load(path: Path | None) -> Authenticator | None:
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
    if len(key) < authentication.MIN_KEY_LENGTH:
        raise ConfigError(
            f"key_file {path}: has {len(key)} bytes, needs {authentication.MIN_KEY_LENGTH}; "
            "make one with: openssl rand -hex 32"
        )
    return Authenticator(key, secrets.randbits(64))
