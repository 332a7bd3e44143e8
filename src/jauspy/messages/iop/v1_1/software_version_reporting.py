"""urn:jaus:jss:iop:SoftwareVersionReporting 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:SoftwareVersionReporting", "1.1")


@jd.message(_SERVICE, 0xF999)
class ReportSoftwareVersion(jd.Message):
    """ReportSoftwareVersion (0xF999): Gives the list of software releases.

    software_version_list: 0..255 items. One entry for each piece of software
    """

    @jd.record("B")
    class SoftwareVersionRec(jd.Struct):
        """name: up to 255 characters. What the software is called
        description: up to 255 characters, optional. What the software does
        version: up to 255 characters, optional. Release of the software
        build_id: optional. Number of the build
        copyright: up to 65535 characters, optional. Who holds the rights
        """
        name: str = jd.field("Name", jd.Text(count=jd.Count("B", 0, 255)))
        description: str | None = jd.field("Description", jd.Text(count=jd.Count("B", 0, 255)), default=None)
        version: str | None = jd.field("Version", jd.Text(count=jd.Count("B", 0, 255)), default=None)
        build_id: int | None = jd.field("BuildID", jd.Number("H"), default=None)
        copyright: str | None = jd.field("Copyright", jd.Text(count=jd.Count("H", 0, 65535)), default=None)
        reserved_presence: int = 0

    software_version_list: list[ReportSoftwareVersion.SoftwareVersionRec] = jd.field("SoftwareVersionList", lambda: jd.Repeat(jd.Count("B", 0, 255), ReportSoftwareVersion.SoftwareVersionRec.layout()))


@jd.message(_SERVICE, 0xE999, query=True)
class QuerySoftwareVersion(jd.Message):
    """QuerySoftwareVersion (0xE999): Asks for the list of software releases."""
    REPORT = ReportSoftwareVersion
