"""ManipulatorListDriver: what the list drivers of a manipulator have in common (AS6057)."""

from __future__ import annotations

from jauspy.messages.manipulator import ReportActiveElement
from jauspy.services.core.list_manager import ListManager
from jauspy.services.manipulator.arm import ArmDriver


class ManipulatorListDriver(ArmDriver, urn="urn:jaus:jss:manipulator:ManipulatorListDriver"):
    """Says how far the list has been carried out; the services that inherit from it do that."""

    def report_active_element(self) -> ReportActiveElement:
        """The element that is being carried out, 0 for none."""
        elements = self.host.service(ListManager)
        return ReportActiveElement(element_uid=elements.active if elements else 0)
