"""LeaderManagement: the vehicles that follow this one, and their wishes for another speed (IOP v3)."""

from __future__ import annotations

import math
from collections.abc import Hashable
from typing import Final

from jauspy.ids import JausID
from jauspy.messages.iop import RegisterFollower, RegisterFollowerResponse, ReportFollowers, RequestSpeedOverride
from jauspy.services.iop.convoy import Convoy
from jauspy.services.mobility.pilot import NO_OVERRIDE, SpeedOverride
from jauspy.services.mobility.vehicle import Vehicle
from jauspy.services.service import Service

TIMEOUT: Final = 5
"""Seconds within which a follower registers anew."""
MAX_FOLLOWERS: Final = 16
"""Registered followers; the next one takes the place of one that the convoy does not name, if it is named itself."""


class LeaderManagement(Service, urn="urn:jaus:jss:iop:LeaderManagement"):
    """Registers followers of the vehicle, and slows the vehicle down as they wish: the smallest wish holds.

    Anybody may register, as the profile says, but the wish of a vehicle counts only if the component's `Convoy` has it
    as a follower of this one: the client in control sets that. Others are counted. A wish ends with its registration.
    """

    def __init__(self, vehicle: Vehicle) -> None:
        self._pilot = vehicle.pilot
        self._wishes: dict[JausID, SpeedOverride] = {}

    @property
    def followers(self) -> tuple[JausID, ...]:
        """The registered followers, in the order in which they registered first."""
        return tuple(self._wishes)

    def control_lost(self) -> None:
        """End all wishes: the next client finds the vehicle as if nobody followed it."""
        self._wishes = dict.fromkeys(self._wishes, NO_OVERRIDE)
        self._apply()

    # --- actions

    def send_report_followers(self) -> ReportFollowers:
        """The registered followers (FFD4)."""
        return ReportFollowers(
            [
                ReportFollowers.FollowerRec(
                    ReportFollowers.Follower_ID(
                        component_id=follower.component, node_id=follower.node, subsystem_id=follower.subsystem
                    )
                )
                for follower in self._wishes
            ]
        )

    def add_follower_to_registration_list(self, msg: RegisterFollower, source: JausID) -> None:
        """Register the sender, or renew its registration; DISCONNECT, for which the profile has no row, ends it."""
        if msg.request_type == RegisterFollower.RequestType.DISCONNECT:
            self._remove(source)
        elif source in self._wishes or self._has_place(source):
            self._wishes.setdefault(source, NO_OVERRIDE)
            self.host.set_timer(_timer(source), self.host.now + TIMEOUT, lambda: self._expire(source))
        else:
            self.host.count("followers_full", f"{source} is one more than {MAX_FOLLOWERS}")

    def send_register_follower_response_connected(self, source: JausID) -> RegisterFollowerResponse:
        """Whether the sender is registered now, and for how long (FFD5)."""
        results = RegisterFollowerResponse.Result
        return RegisterFollowerResponse(
            results.CONNECTED if source in self._wishes else results.DISCONNECTED, timeout=TIMEOUT
        )

    def remove_follower_to_registration_list(self, source: JausID) -> None:
        """Remove the follower whose registration has ended."""
        self._remove(source)

    def send_register_follower_response_not_connected(self) -> RegisterFollowerResponse:
        """Notify the follower that its registration has ended (FFD5)."""
        return RegisterFollowerResponse(RegisterFollowerResponse.Result.DISCONNECTED, timeout=TIMEOUT)

    def is_registered(self, source: JausID) -> bool:
        """True for a registered follower (guard of RequestSpeedOverride); others are counted."""
        found = source in self._wishes
        if not found:
            self.host.count("speed_override_unregistered", f"{source}")
        return found

    def set_override(self, msg: RequestSpeedOverride, source: JausID) -> None:
        """Take the wish of a follower that the convoy names (FFD1)."""
        if not self._is_named(source):
            self.host.count("speed_override_refused", f"{source} follows nobody here, as far as the convoy says")
            return
        wish = msg.override_type
        if isinstance(wish, RequestSpeedOverride.PercentRec):
            self._wishes[source] = SpeedOverride(share=wish.speed_override_percent / 100.0)
        else:
            self._wishes[source] = SpeedOverride(bound=wish.speed_override_absolute)
        self._apply()

    # --- the list

    def _is_named(self, follower: JausID) -> bool:
        convoy = self.host.service(Convoy)
        return convoy is not None and convoy.leader_of(follower.subsystem) == self.host.id.subsystem

    def _has_place(self, follower: JausID) -> bool:
        """True if one more may register; one that the convoy does not name may lose its place."""
        if len(self._wishes) < MAX_FOLLOWERS:
            return True
        if not self._is_named(follower):
            return False
        stranger = next((other for other in self._wishes if not self._is_named(other)), None)
        if stranger is None:
            return False
        self.host.count("follower_replaced", f"{stranger} gives way to {follower}")
        self._remove(stranger)
        return True

    def _expire(self, follower: JausID) -> None:
        self.host.fire("RegistrationTimeout", source=follower)

    def _remove(self, follower: JausID) -> None:
        self.host.cancel_timer(_timer(follower))
        if self._wishes.pop(follower, None) is not None:
            self._apply()

    def _apply(self) -> None:
        share = min((wish.share for wish in self._wishes.values()), default=1.0)
        bound = min((wish.bound for wish in self._wishes.values()), default=math.inf)
        wanted = SpeedOverride(share, bound)
        self._pilot.override = NO_OVERRIDE if wanted == NO_OVERRIDE else wanted


def _timer(follower: JausID) -> Hashable:
    return "follower", follower
