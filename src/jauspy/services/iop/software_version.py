"""SoftwareVersionReporting: names the software of a platform and its releases (IOP v3)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from jauspy.messages.iop import ReportSoftwareVersion
from jauspy.services.service import Service


@dataclass(frozen=True, slots=True)
class SoftwareRelease:
    """One piece of software."""

    name: str
    version: str
    description: str = ""


class SoftwareVersionReporting(Service, urn="urn:jaus:jss:iop:SoftwareVersionReporting"):
    """Reports the releases that it was made with."""

    def __init__(self, releases: Sequence[SoftwareRelease]) -> None:
        self._report = ReportSoftwareVersion(
            [
                ReportSoftwareVersion.SoftwareVersionRec(
                    name=release.name, version=release.version, description=release.description or None
                )
                for release in releases
            ]
        )

    def send_report_software_version(self) -> ReportSoftwareVersion:
        """The list of software (F999)."""
        return self._report
