"""VacuumConnector: attaches parts to the connectors of one part, and releases them. Numbers count from 1."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Final

from jauspy.messages.cell import (
    QueryConnectorState,
    ReportConnectorSpecification,
    ReportConnectorState,
    ScheduleConnector,
    SetConnector,
)
from jauspy.platform.modular.connector import ConnectorError, VacuumConnector
from jauspy.platform.modular.holding import Holding
from jauspy.platform.modular.parts import ConnectorLimits
from jauspy.services.core import present_authority
from jauspy.services.service import Service
from jauspy.services.units import sent_text

LONGEST_DELAY: Final = 60.0
"""Seconds after which a scheduled command takes effect at most."""

_Error: Final = ReportConnectorState.Error
_ERRORS: Final = {
    ConnectorError.NONE: _Error.NO_ERROR,
    ConnectorError.NO_CONTACT: _Error.NO_CONTACT,
    ConnectorError.TOO_FAR: _Error.TOO_FAR,
    ConnectorError.NOT_ALIGNED: _Error.NOT_ALIGNED,
    ConnectorError.FAILED: _Error.ATTACHMENT_FAILED,
    ConnectorError.OVERLOADED: _Error.OVERLOADED,
    ConnectorError.NO_POWER: _Error.NO_POWER,
    ConnectorError.OTHER: _Error.OTHER_ERROR,
}


class VacuumConnectorService(Service, urn="urn:jauspy:cell:VacuumConnector"):
    """The connectors of a part. They keep holding their load when the component ends or its client is lost.

    A load is released only for a client with at least the authority of the client that attached it.
    """

    def __init__(
        self, part: str, type: str, connectors: Sequence[VacuumConnector], limits: ConnectorLimits, strength: Holding
    ) -> None:
        """`strength` is that of a connection between two parts like this one."""
        self._part = part
        self._strength = strength
        self._type = type
        self._connectors = dict(enumerate(connectors, start=1))
        self._limits = limits
        self._refusals: dict[int, str] = {}
        """Reasons why connectors were not vented when they were last told to, by number."""

    def set_connector(self, msg: SetConnector) -> None:
        """Switch a connector on (pump) or off (vent); an unknown number is ignored and counted.

        Venting a load that a client with a higher authority attached is refused, counted, and reported as an error.
        """
        enabled = msg.enabled == SetConnector.Enabled.ENABLED
        if (connector := self._permitted(msg, enabled)) is None:
            return
        if not enabled:
            connector.attached_with = None
        connector.set(enabled)

    def schedule_connector(self, msg: ScheduleConnector) -> None:
        """Do the same after a delay, by the robot's clock; one that is outside of 0..60 s is ignored and counted."""
        if not 0.0 <= msg.delay <= LONGEST_DELAY:
            self.host.count("bad_delay", f"{msg}")
            self.host.begin_command()(False)
            return
        enabled = msg.enabled == ScheduleConnector.Enabled.ENABLED
        if (connector := self._permitted(msg, enabled)) is not None:
            connector.schedule(enabled, msg.delay)

    def _permitted(self, msg: SetConnector | ScheduleConnector, enabled: bool) -> VacuumConnector | None:
        """The connector of a command, if there is one and the client may set it so."""
        number = msg.connector
        if (connector := self._connectors.get(number)) is None:
            self.host.count("unknown_connector", f"{msg}")
            return None
        authority, load = present_authority(self.host), connector.state().attached_to
        needed = connector.attached_with if load else None
        self._refusals.pop(number, None)
        if enabled:
            connector.attached_with = authority if needed is None else max(needed, authority)
        elif needed is not None and authority < needed:
            why = f"not released: a client with authority {needed} attached {load}, and this one has {authority}"
            self._refusals[number] = why
            self.host.count("load_held", f"connector {number}: {why}")
            self.host.begin_command()(False)
            return None
        return connector

    def cancel_schedule(self) -> None:
        """Cancel what is scheduled, because Ready is left: what is held stays held."""
        for connector in self._connectors.values():
            connector.cancel()

    def report_connector_state(self, query: QueryConnectorState) -> ReportConnectorState | None:
        """The state of a connector; no answer for an unknown number."""
        if (connector := self._connectors.get(query.connector)) is None:
            self.host.count("unknown_connector", f"{query}")
            return None
        state = connector.state()
        offset = state.offset.to_pose()
        known = math.isfinite(state.mass_deviation)
        refusal = self._refusals.get(query.connector) if state.attached_to else None
        return ReportConnectorState(
            connector=query.connector,
            enabled=ReportConnectorState.Enabled(state.enabled),
            attached_to=sent_text(state.attached_to),
            offset_x=offset.x,
            offset_y=offset.y,
            offset_z=offset.z,
            offset_roll=offset.roll,
            offset_pitch=offset.pitch,
            offset_yaw=offset.yaw,
            force=state.force,
            moment=state.moment,
            utilisation=state.utilisation,
            vacuum=state.vacuum,
            latched=ReportConnectorState.Latched(state.latched),
            broken_off=min(state.broken_off, 0xFFFF),
            error=_ERRORS[state.error] if refusal is None else _Error.OTHER_ERROR,
            error_text=sent_text(state.last_error if refusal is None else refusal),
            load_mass=state.mass if known else None,
            load_mass_deviation=state.mass_deviation if known else None,
        )

    def report_connector_specification(self) -> ReportConnectorSpecification:
        """Names and limits."""
        report = ReportConnectorSpecification
        limits = report.ConnectorLimitsRec(
            name=sent_text(self._part),
            type=sent_text(self._type),
            max_distance=self._limits.max_distance,
            max_angle=self._limits.max_angle,
            max_force=self._strength.force,
            max_moment=self._strength.moment,
        )
        names = [connector.name.rpartition("/")[2] for connector in self._connectors.values()]
        return report(limits, [report.ConnectorNameRec(sent_text(name)) for name in names])
