"""Who of an OCU listens to which event: a component has one for equal subscriptions, or commands, of one client."""

from __future__ import annotations

from jauspy.ids import JausID


class EventUsers:
    """By component and number of the event; for a command by its bytes, known before there is a number."""

    def __init__(self) -> None:
        self._users: dict[tuple[JausID, int | bytes], set[object]] = {}

    def join(self, id: JausID, event: int | bytes, user: object) -> set[object]:
        """`user` listens to this event; who else does."""
        users = self._users.setdefault((id, event), set())
        users.add(user)
        return users - {user}

    def is_known(self, id: JausID, event: int) -> bool:
        """True when somebody listens to this event."""
        return (id, event) in self._users

    def users(self, id: JausID, event: int | bytes) -> frozenset[object]:
        """Who listens to this event."""
        return frozenset(self._users.get((id, event), ()))

    def leave(self, id: JausID, event: int | bytes | None, user: object) -> bool:
        """`user` does not any more; true when it was the last, so that the event can be cancelled."""
        users = self._users.get((id, event)) if event is not None else None
        if event is None or users is None:
            return False
        users.discard(user)
        if not users:
            del self._users[id, event]
        return not users
