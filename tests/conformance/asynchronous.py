"""A component whose services notify each other with delay, as those of other vendors do in separate processes.

A service handles its messages in order, and each message up to `LATE` seconds after it came. Management learns late who
is in control, and ignores what it receives until then. Answers come late, in any order.
"""

from __future__ import annotations

import heapq
import random
from itertools import count
from typing import Final

from jauspy.conformance import TargetComponent
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import ConfirmControl, Reset, Resume, Shutdown, Standby
from jauspy.services.messaging import Outgoing

LATE: Final = 0.05
CONFIRMED: Final = ConfirmControl(ConfirmControl.ResponseCode.CONTROL_ACCEPTED).encode()
OF_MANAGEMENT: Final = frozenset(kind.CODE for kind in (Resume, Standby, Reset, Shutdown))


def asynchronous(seed: int) -> type[TargetComponent]:
    """The class of such a component; equal seeds give equal delays."""

    class Asynchronous(TargetComponent):
        def __init__(self, *given, **options) -> None:
            super().__init__(*given, **options)
            self._random = random.Random(seed)
            self._order = count()
            self._handled: list[tuple[float, int, bytes, JausID]] = []
            self._said: list[tuple[float, int, Outgoing]] = []
            self._last: dict[str, float] = {}
            self._unaware_until = 0.0

        def _delay(self) -> float:
            return self._random.uniform(0.0, LATE)

        def receive(self, payload: bytes, source: JausID, now: float) -> None:
            kinds = registry.by_code(int.from_bytes(payload[:2], "little"))
            service = kinds[0].SERVICE if kinds else ""
            at = self._last[service] = max(now + self._delay(), self._last.get(service, 0.0))
            heapq.heappush(self._handled, (at, next(self._order), payload, source))

        def send(self, outgoing: Outgoing, now: float) -> None:
            if outgoing.payload == CONFIRMED:
                self._unaware_until = now + self._delay() + LATE
            heapq.heappush(self._said, (now + self._delay(), next(self._order), outgoing))

        def work(self, now: float) -> list[bytes]:
            while self._handled and self._handled[0][0] <= now:
                _, _, payload, source = heapq.heappop(self._handled)
                if int.from_bytes(payload[:2], "little") not in OF_MANAGEMENT or now >= self._unaware_until:
                    super().receive(payload, source, now)
            while self._said and self._said[0][0] <= now:
                _, _, outgoing = heapq.heappop(self._said)
                super().send(outgoing, now)
            return super().work(now)

        def next_timeout(self) -> float | None:
            due = [super().next_timeout(), *(queue[0][0] for queue in (self._handled, self._said) if queue)]
            return min((at for at in due if at is not None), default=None)

    return Asynchronous
