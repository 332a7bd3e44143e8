"""A follower as the client of its leader: registers with LeaderManagement, and asks for another speed (IOP v3)."""

from __future__ import annotations

from typing import Final

from jauspy.ids import JausID
from jauspy.messages.iop import RegisterFollower, RegisterFollowerResponse, RequestSpeedOverride
from jauspy.services.service import ServiceHost

PERIOD: Final = 1.0
"""Seconds between two registrations, each followed by the present wish; leaders allow several seconds."""


class LeaderRequests:
    """Wishes of the vehicle for the speed of its leader, repeated until they end; without one it does not register."""

    def __init__(self, host: ServiceHost) -> None:
        self._host = host
        self._leader: JausID | None = None
        self._wish: RequestSpeedOverride.PercentRec | RequestSpeedOverride.AbsoluteRec | None = None
        self.is_registered = False
        """True after the leader has confirmed the registration."""
        host.expect(RegisterFollowerResponse, self._on_response)

    def begin(self, leader: JausID) -> None:
        """Register with this leader, and keep registered."""
        if self._leader != leader:
            self.end()
            self._leader = leader
            self._repeat()

    def end(self) -> None:
        """End the registration, and with it the wish. May be called twice."""
        self._host.cancel_timer(self._repeat)
        if self._leader is not None:
            self._host.send(self._leader, RegisterFollower(RegisterFollower.RequestType.DISCONNECT))
        self._leader = self._wish = None
        self.is_registered = False

    def stop(self) -> None:
        """Ask the leader to stop."""
        self._ask(RequestSpeedOverride.AbsoluteRec(0.0))

    def slow(self, share: float) -> None:
        """Ask for a share of its speed, 0..1."""
        self._ask(RequestSpeedOverride.PercentRec(round(100.0 * share)))

    def _ask(self, wish: RequestSpeedOverride.PercentRec | RequestSpeedOverride.AbsoluteRec) -> None:
        if self._leader is not None and wish != self._wish:
            self._wish = wish
            self._send_wish()

    def _repeat(self) -> None:
        if self._leader is None:
            return
        self._host.send(self._leader, RegisterFollower(RegisterFollower.RequestType.CONNECT))
        self._send_wish()
        self._host.set_timer(self._repeat, self._host.now + PERIOD, self._repeat)

    def _send_wish(self) -> None:
        if self._leader is not None and self._wish is not None and self.is_registered:
            self._host.send(self._leader, RequestSpeedOverride(self._wish))

    def _on_response(self, msg: RegisterFollowerResponse, source: JausID) -> None:
        if source != self._leader:
            self._host.count("unrequested_registration", f"{source}")
            return
        before = self.is_registered
        self.is_registered = msg.result == RegisterFollowerResponse.Result.CONNECTED
        if self.is_registered and not before:
            self._send_wish()
