"""The progress of a campaign in a file, from which an interrupted one continues."""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path
from typing import Final, NamedTuple

from jauspy.errors import ConfigError
from jauspy.fuzz.findings import FuzzFinding
from jauspy.user_files import read_file

MAX_SIZE: Final = 64 << 20


class SavedProgress(NamedTuple):
    """What was done: all cases below `cases`, of which `accepted` were valid messages, and the findings."""

    cases: int = 0
    accepted: int = 0
    findings: tuple[FuzzFinding, ...] = ()


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
            content = json.loads(read_file(self._path, MAX_SIZE))
            campaign, cases, accepted = str(content["campaign"]), int(content["cases"]), int(content["accepted"])
            findings = tuple(FuzzFinding(**each) for each in content["findings"])
            assert min(cases, accepted) >= 0
            assert all(finding.data for finding in findings)
        except (ValueError, KeyError, TypeError, AssertionError):
            raise ConfigError(f"{self._path} is not a progress file of jauspy fuzz; name another one") from None
        if campaign != self._campaign:
            raise ConfigError(
                f"{self._path} is of a campaign with another seed, other messages or another version of jauspy; "
                "remove it to begin anew, or name another file"
            )
        return SavedProgress(cases, accepted, findings)

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
            partial.replace(self._path)
        except OSError as error:
            raise ConfigError(f"{self._path} cannot be written: {error.strerror}") from error
