"""What a component sends: packed by its endpoint, handed to its transport."""

from __future__ import annotations

import logging
from collections import Counter
from typing import Final

from jauspy.component.acknowledgements import Acknowledgements
from jauspy.errors import ProtocolError
from jauspy.protocol.endpoint import Endpoint
from jauspy.protocol.header import Ack
from jauspy.services.messaging import Outgoing
from jauspy.transport.base import Transport

_LOG: Final = logging.getLogger("jauspy.component")


class Outlet:
    """`deliveries` hears of every outcome."""

    def __init__(
        self, endpoint: Endpoint, transport: Transport, deliveries: Acknowledgements, counters: Counter[str]
    ) -> None:
        self._endpoint = endpoint
        self._transport = transport
        self._deliveries = deliveries
        self._counters = counters

    def flush(self, messages: list[Outgoing], now: float) -> None:
        """Send what services said; what cannot be sent is counted, and logged the first time."""
        for each in messages:
            self._pack(each, now)
        self.transmit()

    def transmit(self) -> None:
        """Hand out what the endpoint has ready."""
        for datagram in self._endpoint.poll_output():
            self._transport.send(datagram)
        self._deliveries.settle()

    def _pack(self, outgoing: Outgoing, now: float) -> None:
        destination, payload, priority, broadcast, told = outgoing
        ack = Ack.NONE if told is None or self._deliveries.full else Ack.REQUIRED
        try:
            ticket = self._endpoint.send(destination, payload, now=now, priority=priority, broadcast=broadcast, ack=ack)
        except ProtocolError as error:
            reason = f"unsendable.{error.reason}"
            if not self._counters[reason]:
                code = int.from_bytes(payload[:2], "little")
                _LOG.warning("%s: cannot send %04Xh to %s: %s", self._endpoint.id, code, destination, error)
            self._counters[reason] += 1
        else:
            if told is not None and ticket is not None:
                self._deliveries.tell(ticket, told)
