"""A finding: what went wrong, named by its cause, in a small JSON file."""

from __future__ import annotations

import json
import re
from dataclasses import asdict, dataclass, replace
from pathlib import Path

from jauspy.errors import ConfigError


@dataclass(frozen=True, slots=True)
class Problem:
    """What a check has to say; `what` is the exception type or field path that makes it this problem and no other."""

    check: str
    what: str
    seen: str


@dataclass(frozen=True, slots=True)
class Finding:
    """A problem and the bytes that show it. `seed` and `case` say which campaign made them."""

    check: str
    message: str
    service: str
    version: str
    what: str
    seen: str
    hex: str
    seed: int
    case: int

    @property
    def cause(self) -> str:
        """The name of the problem: the same for all bytes that show it."""
        return " ".join(part for part in (self.check, self.message, self.version, self.what) if part)

    @property
    def data(self) -> bytes:
        """The bytes."""
        return bytes.fromhex(self.hex)

    def smaller(self, data: bytes, seen: str) -> Finding:
        """The same problem, shown by other bytes."""
        return replace(self, hex=data.hex(), seen=seen)

    def save(self, folder: Path) -> Path:
        """Write `<cause>.json` into a folder that is made when it is not there."""
        folder.mkdir(parents=True, exist_ok=True)
        path = folder / (re.sub(r"[^\w.]+", "-", self.cause).strip("-.") + ".json")
        path.write_text(json.dumps({"cause": self.cause, **asdict(self)}, indent=2) + "\n", encoding="utf-8")
        return path


def load_finding(path: Path) -> Finding:
    """The inverse of `Finding.save`; raises `ConfigError`."""
    try:
        data = json.loads(path.read_text(encoding="utf-8"))
        finding = Finding(**{name: data[name] for name in Finding.__slots__})
        assert len(finding.data) >= 2
    except OSError as error:
        raise ConfigError(f"{path} cannot be read: {error.strerror}") from None
    except (ValueError, KeyError, TypeError, AssertionError):
        raise ConfigError(f"{path} is not a finding of jauspy fuzz") from None
    return finding
