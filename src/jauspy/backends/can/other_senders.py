"""Evidence that another program sends on the bus: what only the master sends, or frames of its drives.

CAN has no addresses of senders, so this is found by counting: each drive answers each SYNC of this master once, and a
bus that echoes returns each frame of this master once.
"""

from __future__ import annotations

from typing import Final

from jauspy.platform.servo_drives import CanSetup

TOLERANCE: Final = 3
"""Frames that this process did not send, after which there is another master."""

LATE_CYCLES: Final = 40
"""Cycles whose echoes may arrive later, as when the receiver was blocked."""

NMT_START: Final = 1


class Balance:
    """Frames received beyond those that are due. One thread writes `received`, another one calls the methods."""

    def __init__(self, late: int) -> None:
        self.received = 0
        self._due = 0
        self._late = late

    def add_due(self) -> None:
        """One more frame is due."""
        self._due += 1

    def excess(self) -> int:
        """Frames too many. Frames that were lost do not count for longer than they could be late."""
        found = self.received - self._due
        if found < -self._late:
            self._due = self.received + self._late
        return found

    def forgive(self) -> None:
        """Forget one frame too many."""
        if self.received > self._due:
            self._due += 1

    def reset(self) -> None:
        """Begin again: no frame is due."""
        self._due = self.received

    def restart(self) -> None:
        """Begin again, but wait for frames that are due and not later than they could be.

        A program or drive that was held up answers all that waited for it one after the other, when it runs again.
        """
        self._due = self.received + min(max(self._due - self.received, 0), self._late)


class OtherMasters:
    """Finds other masters by frames that only a master sends. `echoes`: the bus returns what is sent on it."""

    def __init__(self, setup: CanSetup, *, echoes: bool) -> None:
        self._setup = setup
        self._echoes = echoes
        self._syncs = Balance(LATE_CYCLES)
        self._commands = Balance(LATE_CYCLES * len(setup.drives))
        self._heartbeats = Balance(LATE_CYCLES)
        self._nodes = {0, *(drive.node for drive in setup.drives.values())}
        self._nmt = 0
        """NMT commands that end the operation of drives."""

    # --- received ---------------------------------------------------------------------------------------------------

    def receive_sync(self, _data: bytes) -> bool:
        """Count a SYNC that was received."""
        self._syncs.received += 1
        return True

    def receive_command(self, _data: bytes) -> bool:
        """Take a command to a drive."""
        self._commands.received += 1
        return True

    def receive_heartbeat(self, _data: bytes) -> bool:
        """Take a heartbeat of the master's own node."""
        self._heartbeats.received += 1
        return True

    def receive_nmt(self, data: bytes) -> bool:
        """Take an NMT command; this master sends none while it supervises, except that one which starts nodes."""
        if data[0] != NMT_START and data[1] in self._nodes:
            self._nmt += 1
        return True

    # --- sent -------------------------------------------------------------------------------------------------------

    def sent_sync(self) -> None:
        """Count an own SYNC."""
        if self._echoes:
            self._syncs.add_due()

    def sent_command(self) -> None:
        """Count an own command."""
        if self._echoes:
            self._commands.add_due()

    def sent_heartbeat(self) -> None:
        """Count an own heartbeat."""
        if self._echoes:
            self._heartbeats.add_due()

    def sends_nmt(self) -> None:
        """Forget NMT commands, because own ones may be among them."""
        self._nmt = 0

    # --- found ------------------------------------------------------------------------------------------------------

    def reset(self) -> None:
        """Begin again, as after Reset."""
        for balance in (self._syncs, self._commands, self._heartbeats):
            balance.reset()
        self._nmt = 0

    def found(self, tolerance: int = TOLERANCE) -> str:
        """A description of what another master sends, as in `SYNC on socketcan:can0`; empty if there is none."""
        bus = self._setup.bus
        if self._nmt:
            return f"NMT commands on {bus}"
        if self._syncs.excess() > tolerance:
            return f"SYNC on {bus}"
        if self._commands.excess() > tolerance:
            return f"commands on {bus}"
        if self._heartbeats.excess() > (tolerance if self._echoes else 0):
            return f"heartbeats of node {self._setup.node} on {bus}"
        return ""
