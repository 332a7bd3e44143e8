"""PlatformState and PlatformMode: state and mode of a platform with all of its components (IOP v3)."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import Final

from jauspy.codec.message import Message
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages.core import ClearEmergency, ReportStatus, RequestControl, Reset, SetEmergency, Shutdown
from jauspy.messages.iop import (
    ConfirmPlatformStateRequest,
    ReportPlatformMode,
    ReportPlatformState,
    ReportSupportedPlatformModes,
    SetPlatformMode,
    SetPlatformState,
)
from jauspy.services.core import Management
from jauspy.services.service import Service

State = ReportPlatformState.PlatformState
Wanted = SetPlatformState.PlatformState
Mode = ReportPlatformMode.PlatformMode
STOP: Final = SetEmergency.EmergencyCode.STOP
HIGHEST_AUTHORITY: Final = 255

STATES: Final = {
    ReportStatus.Status.INITIALIZE: State.INITIALIZE,
    ReportStatus.Status.READY: State.OPERATIONAL,
    ReportStatus.Status.STANDBY: State.OPERATIONAL,
    ReportStatus.Status.SHUTDOWN: State.SHUTDOWN,
    ReportStatus.Status.FAILURE: State.SYSTEM_ABORT,
    ReportStatus.Status.EMERGENCY: State.EMERGENCY,
}
"""State of the platform by the status of the component that has this service."""


class PlatformState(Service, urn="urn:jaus:jss:iop:PlatformState"):
    """Brings the component itself and `components`, the others of the platform, into a state.

    Emergency stops all of them at once and needs no control of theirs. Initialization and shutdown take their control
    first, with the highest authority. A platform cannot be rendered useless.
    """

    def __init__(self, components: Iterable[JausID] = ()) -> None:
        self._components = tuple(components)
        self._requester: JausID | None = None
        self._emergency_client: JausID | None = None
        """The client whose request has set the emergency, which its end must name."""

    @property
    def _management(self) -> Management:
        management = self.host.service(Management)
        if management is None:
            raise ConfigError(f"{self.host.id} offers PlatformState, which needs Management beside it")
        return management

    @property
    def state(self) -> ReportPlatformState.PlatformState:
        """The state of the platform."""
        return STATES[self._management.status]

    # --- predicates

    def is_id_stored(self, source: JausID) -> bool:
        """The sender has set the emergency."""
        return source == self._emergency_client or self._management.is_id_stored(source)

    def set_to_initialize(self, msg: SetPlatformState) -> bool:
        """The message asks for initialization."""
        return msg.platform_state == Wanted.INITIALIZE

    def set_to_operational(self, msg: SetPlatformState) -> bool:
        """The message asks for operation, which ends an emergency."""
        return msg.platform_state == Wanted.OPERATIONAL

    def set_to_emergency(self, msg: SetPlatformState) -> bool:
        """The message asks for an emergency."""
        return msg.platform_state == Wanted.EMERGENCY

    def set_to_shutdown(self, msg: SetPlatformState) -> bool:
        """The message asks for shutdown."""
        return msg.platform_state == Wanted.SHUTDOWN

    def set_to_render_useless(self, msg: SetPlatformState) -> bool:
        """The message asks to make the platform unusable."""
        return msg.platform_state == Wanted.RENDER_USELESS

    # --- actions

    def store_requester(self, source: JausID) -> None:
        """Keep who asked, for the answer."""
        self._requester = source

    def trigger_emergency(self) -> None:
        """Stop everything: the other components first, as the own one moves nothing."""
        self._emergency_client = self._requester
        self._send_all(SetEmergency(STOP))
        self._perform(SetEmergency(STOP), Wanted.EMERGENCY, self._requester)

    def trigger_recover_emergency(self) -> None:
        """End the emergency that was set here; those that clients have set at components last until they clear them."""
        if self.state is State.OPERATIONAL:
            self._confirm(self._requester, Wanted.OPERATIONAL, accepted=True)
            return
        self._perform(
            ClearEmergency(STOP),
            Wanted.OPERATIONAL,
            self._emergency_client or self._requester,
            then=lambda: self._send_all(ClearEmergency(STOP)),
        )

    def trigger_reset(self) -> None:
        """Initialize all components."""
        self._perform(Reset(), Wanted.INITIALIZE, self._requester, then=lambda: self._command_all(Reset()))

    def trigger_shutdown(self) -> None:
        """Shut all components down."""
        self._perform(Shutdown(), Wanted.SHUTDOWN, self._requester, then=lambda: self._command_all(Shutdown()))

    def trigger_render_useless(self) -> None:
        """Refuse: nothing here can be destroyed."""
        self._confirm(self._requester, Wanted.RENDER_USELESS, accepted=False)

    def send_report_platform_state(self) -> ReportPlatformState:
        """The state of the platform."""
        return ReportPlatformState(platform_state=self.state)

    # --- inside

    def _perform(
        self,
        command: Message,
        wanted: SetPlatformState.PlatformState,
        source: JausID | None,
        then: Callable[[], None] = lambda: None,
    ) -> None:
        """Have the own component carry out a command; then the others, and tell the requester."""
        requester = self._requester

        def ended(done: bool) -> None:
            if done:
                then()
            self._confirm(requester, wanted, accepted=done)

        if source is not None:
            self.host.perform(command, source, ended)

    def _confirm(self, requester: JausID | None, wanted: SetPlatformState.PlatformState, *, accepted: bool) -> None:
        codes = ConfirmPlatformStateRequest.ResponseCode
        if requester is not None:
            answer = ConfirmPlatformStateRequest(
                platform_state=wanted, response_code=codes.TRANSITIONING if accepted else codes.INVALID_STATE
            )
            self.host.send(requester, answer)

    def _send_all(self, message: Message) -> None:
        for component in self._components:
            self._deliver(component, message)

    def _command_all(self, command: Message) -> None:
        """Take control of each component, and then send it a command."""
        for component in self._components:
            self._deliver(component, RequestControl(HIGHEST_AUTHORITY), command)

    def _deliver(self, component: JausID, message: Message, *others: Message) -> None:
        """Send messages one after the other, each repeated until it is acknowledged."""

        def acknowledged(delivered: bool) -> None:
            if not delivered:
                self.host.count("platform_state_not_delivered", f"{message.NAME} to {component}")
            elif others:
                self._deliver(component, *others)

        self.host.send(component, message, on_acknowledged=acknowledged)


class PlatformMode(Service, urn="urn:jaus:jss:iop:PlatformMode"):
    """Switches between the modes that a platform has; `on_change` is called with the new one.

    The first of `modes` is the mode at the start.
    """

    def __init__(
        self,
        modes: Sequence[ReportPlatformMode.PlatformMode] = (Mode.STANDARD_OPERATING,),
        on_change: Callable[[ReportPlatformMode.PlatformMode], None] = lambda mode: None,  # noqa: ARG005 - nothing to do
    ) -> None:
        if not modes:
            raise ConfigError("platform mode: modes is empty; a platform has one mode or more")
        self.modes = tuple(modes)
        self.mode = self.modes[0]
        self._on_change = on_change

    def set_platform_mode(self, msg: SetPlatformMode) -> None:
        """Change the mode; one that the platform lacks is counted and ignored."""
        wanted = next((mode for mode in self.modes if mode == msg.platform_mode), None)
        if wanted is None:
            self.host.count("platform_mode_unsupported", f"mode {int(msg.platform_mode)}")
        elif wanted is not self.mode:
            self.mode = wanted
            self._on_change(wanted)

    def report_platform_mode(self) -> ReportPlatformMode:
        """The mode, which is changed at once."""
        return ReportPlatformMode(platform_mode=self.mode, status=ReportPlatformMode.Status.ACTIVE)

    def report_supported_platform_modes(self) -> ReportSupportedPlatformModes:
        """The modes that there are."""
        return ReportSupportedPlatformModes(
            [ReportSupportedPlatformModes.PlatformModeRec(platform_mode=mode) for mode in self.modes]
        )
