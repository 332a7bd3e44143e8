"""Reports that a component sends because a verb has created an event, in the form of traffic."""

from __future__ import annotations

import time
from collections.abc import AsyncGenerator

from jauspy.capture.dissect import Content, Part
from jauspy.cli.client import destination
from jauspy.cli.definitions import Definitions
from jauspy.cli.fields import message_class, message_from
from jauspy.codec.message import Message
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.inspection.traffic import SeenMessage
from jauspy.ocu import OCU
from jauspy.protocol.header import Packet


def event_query(source: str | None, message: str | None, known: Definitions) -> tuple[JausID, Message]:
    """The component, and the query of the event for a report or query by name; raises `ConfigError`."""
    if source is None or message is None:
        raise ConfigError(
            "--subscribe needs a component and a message, as in: jauspy echo 101.1.102 ReportLocalPose --subscribe"
        )
    component = destination(source)
    if component.is_wildcard:
        raise ConfigError(f"--subscribe creates an event at one component, and {component} has wildcards")
    name = message.replace("Report", "Query", 1) if message.startswith("Report") else message
    kind = message_class(known.registry, name, known.hints())
    if not kind.IS_QUERY:
        raise ConfigError(f"{kind.NAME} is no query and no report, so there is no event with it")
    return component, message_from(known.registry, name, [])


async def event_reports(
    ocu: OCU, component: JausID, query: Message, rate: float | None
) -> AsyncGenerator[SeenMessage, None]:
    """The reports of an event at `rate` Hz, or on every change; endless. Raises `RequestError`."""
    async with ocu, ocu.service(component, query.SERVICE).subscribe(query, rate=rate) as subscription:
        async for report in subscription:
            payload = report.encode(strict=False)
            packet = Packet(component, ocu.id, payload)
            yield SeenMessage(time.time(), Part(packet, Content(payload, report)))
