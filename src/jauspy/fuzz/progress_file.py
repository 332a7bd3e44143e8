"""The progress of a campaign in a file, from which an interrupted one continues."""

from __future__ import annotations

import json
import os
from dataclasses import asdict
from pathlib import Path
from typing import Final, NamedTuple

from pydantic import BaseModel, ConfigDict, Field, TypeAdapter, ValidationError

from jauspy.errors import ConfigError
from jauspy.fuzz.findings import FuzzFinding
from jauspy.user_files import read_file

MAX_SIZE: Final = 64 << 20


class SavedProgress(NamedTuple):
    """What was done: all cases below `cases`, of which `accepted` were valid messages, and the findings."""

    cases: int = 0
    accepted: int = 0
    findings: tuple[FuzzFinding, ...] = ()


class _Content(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True)

    campaign: str
    cases: int = Field(ge=0)
    accepted: int = Field(ge=0)
    findings: list[dict[str, str | int]]


_FINDING: Final = TypeAdapter(FuzzFinding)


class ProgressFile:
    """The file of one campaign; `campaign` identifies its settings, which must be the same when it continues."""

    def __init__(self, path: Path, campaign: str) -> None:
        self._path = path
        self._campaign = campaign

    def load(self) -> SavedProgress:
        """What the file has, or nothing done without one. Raises `ConfigError` for the file of another campaign."""
        if not self._path.exists():
            return SavedProgress()
        try:
            content = _Content.model_validate_json(read_file(self._path, MAX_SIZE))
            findings = tuple(_FINDING.validate_python(each) for each in content.findings)
        except ValidationError:
            raise ConfigError(f"{self._path} is not a progress file of jauspy fuzz; name another one") from None
        if content.campaign != self._campaign:
            raise ConfigError(
                f"{self._path} is of a campaign with another seed, other messages or another version of jauspy; "
                "remove it to begin anew, or name another file"
            )
        return SavedProgress(content.cases, content.accepted, findings)

    def save(self, progress: SavedProgress) -> None:
        """Replace the file; one that was interrupted keeps the earlier content."""
        content = {
            "campaign": self._campaign,
            "cases": progress.cases,
            "accepted": progress.accepted,
            "findings": [asdict(finding) for finding in progress.findings],
        }
        partial = self._path.with_name(f".{self._path.name}.part")
        try:
            self._path.parent.mkdir(parents=True, exist_ok=True)
            partial.write_text(json.dumps(content) + "\n", encoding="utf-8")
            os.replace(partial, self._path)
        except OSError as error:
            raise ConfigError(f"{self._path} cannot be written: {error.strerror}") from error
