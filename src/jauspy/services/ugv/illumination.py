"""IlluminationService: switches and reports the lights of the platform (AS6091)."""

from __future__ import annotations

from dataclasses import fields
from typing import Final

from jauspy.messages.ugv import ReportIlluminationConfiguration, ReportIlluminationState, SetIlluminationState
from jauspy.platform.lights import Lamp, Switch
from jauspy.services.service import Service

LEVELS: Final = 15
"""Highest level of a variable light."""

_State = ReportIlluminationState.Illumination
_LIGHTS: Final = tuple(field.name for field in fields(_State) if not field.name.startswith("reserved"))
"""Fields of the messages, one for each light that JAUS knows."""


class IlluminationService(Service, urn="urn:jaus:jss:ugv:IlluminationService"):
    """The lamps of the robot; lamps with the same switch are switched together.

    A command that switches a light on that the platform does not have is ignored, as the service's guard asks.
    """

    def __init__(self, lamps: tuple[Lamp, ...]) -> None:
        self._lamps = lamps
        self._switches = {lamp.setup.switch for lamp in lamps}

    def is_supported(self, msg: SetIlluminationState) -> bool:
        """True if the platform has every light that the message switches on."""
        wanted = msg.illumination
        supported = {switch.value for switch in self._switches}
        return all(name in supported or not getattr(wanted, name) for name in _LIGHTS)

    def set_illumination_state(self, msg: SetIlluminationState) -> None:
        """Switch all lamps as the message says."""
        wanted = msg.illumination
        for lamp in self._lamps:
            switch = lamp.setup.switch
            level = getattr(wanted, switch.value)
            lamp.set(level / LEVELS if switch.is_variable else float(level))

    def send_report_illumination_state(self) -> ReportIlluminationState:
        """Return the states of the lights; variable ones with their level."""
        states = dict.fromkeys(_LIGHTS, 0) | {switch.value: self._state(switch) for switch in self._switches}
        return ReportIlluminationState(_State(**states))

    def send_report_illumination_configuration(self) -> ReportIlluminationConfiguration:
        """Return the lights that the platform has."""
        supported = {switch.value for switch in self._switches}
        types = ReportIlluminationConfiguration.Types
        return ReportIlluminationConfiguration(types(**{name: int(name in supported) for name in _LIGHTS}))

    def _state(self, switch: Switch) -> int:
        level = max(lamp.level for lamp in self._lamps if lamp.setup.switch is switch)
        return round(LEVELS * level) if switch.is_variable else int(level > 0.0)
