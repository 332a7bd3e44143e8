"""Checks of one component: found and reached, its services and versions, who controls it, its clock, seals."""

from __future__ import annotations

import errno
import os
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from datetime import UTC, datetime
from typing import Final, TypeVar

from jauspy.codec.layout import Composite
from jauspy.codec.message import Message
from jauspy.codec.scalars import SIZES
from jauspy.errors import JausError
from jauspy.ids import ANY_COMPONENT, JausID
from jauspy.inspection.doctor.findings import Finding, fail, ok, warn
from jauspy.inspection.doctor.network import DENIED
from jauspy.inspection.doctor.probe import Probe, Reply
from jauspy.messages import registry
from jauspy.messages.core import (
    QueryAuthority,
    QueryControl,
    QueryIdentification,
    QueryServices,
    QueryStatus,
    QueryTime,
    ReportAuthority,
    ReportControl,
    ReportServices,
    ReportStatus,
    ReportTime,
)
from jauspy.messages.operators import QuerySealChallenge, RejectCommand, ReportSealChallenge
from jauspy.protocol.address_book import Address
from jauspy.protocol.seal import OperatorKey
from jauspy.schema.loader import versions_of
from jauspy.services.core.command_seal import explained

DIRECT_TIME, WILDCARD_TIME, LARGE_TIME, STATE_TIME, LAST_TIME = 0.6, 0.6, 0.6, 0.8, 0.6
"""Seconds for each question; with discovery, less than five together."""
PADDING: Final = 4000
"""Bytes behind a packet, so that IP sends it in fragments over Ethernet."""
CLOCK_TOLERANCE: Final = 2.0
"""Seconds by which two clocks may differ; time stamps of poses, and authentication, need better ones."""
_MONTH: Final = 31 * 86400.0

M = TypeVar("M", bound=Message)


class PeerExamination:
    """Asks one component, question by question; `authority` is what its client wants to control it with."""

    def __init__(
        self, probe: Probe, id: JausID, address: Address | None, authority: int, key: OperatorKey | None = None
    ) -> None:
        self._probe = probe
        self._id = id
        self._authority = authority
        self._key = key
        found = [reply for reply in probe.replies if reply.source == id]
        self._heard = bool(found)
        self._address = address or (found[0].address if found else None)
        self._interface = found[0].interface if found else (probe.interfaces or [""])[0]

    def findings(self) -> Iterator[Finding]:
        """All checks of the component; those that need an answer end with the first that fails."""
        if self._address is None or not self._interface:
            yield self._not_found()
            return
        direct = self._ask([_identify()], DIRECT_TIME)
        if not direct:
            yield self._not_reached()
            return
        yield from self._check_way(direct)
        yield self._check_wildcard()
        yield self._check_fragments()
        queries = (_services_of(self._id), QueryControl(), QueryAuthority(), QueryStatus(), QueryTime())
        replies = self._ask(
            queries, STATE_TIME, enough=lambda found: len({reply.content.code for reply in found}) >= len(queries)
        )
        arrived = datetime.now(UTC)
        yield from self._check_services(_last(replies, ReportServices))
        yield self._check_control(_last(replies, ReportControl), _last(replies, ReportAuthority))
        yield _check_status(self._id, _last(replies, ReportStatus))
        yield check_peer_clock(_last(replies, ReportTime), arrived)
        yield from check_deviations(direct + replies)
        yield from self._check_presence(_last(replies, ReportServices))
        yield from self._check_seals(_last(replies, ReportServices))

    def _ask(
        self,
        queries: Sequence[Message],
        seconds: float,
        *,
        to: JausID | None = None,
        padding: int = 0,
        enough: Callable[[list[Reply]], bool] = bool,
    ) -> list[Reply]:
        assert self._address is not None
        own = self._id
        found = self._probe.ask(
            queries,
            to or own,
            self._address,
            self._interface,
            seconds,
            padding=padding,
            enough=lambda replies: enough([reply for reply in replies if reply.source == own]),
        )
        return [reply for reply in found if reply.source == own]

    # --- the way to it

    def _not_found(self) -> Finding:
        others = sorted({reply.source for reply in self._probe.replies if reply.source.subsystem == self._id.subsystem})
        if others:
            return fail(
                "peer",
                f"{self._id} did not answer discovery, but others of subsystem {self._id.subsystem} did",
                "there are " + ", ".join(map(str, others[:8])),
                "check its id, and whether its program runs (`jauspy ls`)",
            )
        return fail(
            "peer",
            f"{self._id} did not answer discovery, and its address is not known",
            f"{len({reply.source for reply in self._probe.replies})} other components answered",
            "check that its machine is on this network, and give its address with --connect udp://HOST to test the way "
            "without multicasts",
        )

    def _not_reached(self) -> Finding:
        assert self._address is not None
        host, port = self._address
        if problem := self._probe.errors.get(self._interface):
            denied = problem in DENIED
            return fail(
                "firewall" if denied else "sending",
                f"nothing can be sent to {host}:{port}: {problem}",
                f"UDP from {self._interface}",
                f"a firewall of this machine or a route of type prohibit rejects it; allow UDP to {host}"
                if denied
                else f"check the route: ip route get {host}",
            )
        error = self._probe.unreachable.get(self._address)
        if error == errno.ECONNREFUSED:
            return fail(
                "peer",
                f"no program has UDP port {port} on {host}",
                "its machine answered with ICMP port unreachable",
                "start the node manager there, or name its port, as in --connect udp://HOST:PORT",
            )
        if error is not None:
            return fail(
                "peer",
                f"{host} cannot be reached: {os.strerror(error)}",
                "reported by a machine on the way (ICMP)",
                "check the route, and firewalls on the way: ip route get " + host,
            )
        what = "answers multicasts only" if self._heard else "does not answer"
        return fail(
            "peer",
            f"{self._id} {what}: unicasts to {host}:{port} get no answer",
            f"QueryIdentification, twice in {DIRECT_TIME:g} s, without an ICMP error",
            f"check that it runs there, and that firewalls of both machines let UDP port {port} in",
        )

    def _check_way(self, direct: Sequence[Reply]) -> Iterator[Finding]:
        assert self._address is not None
        reply = direct[0]
        where = f"{reply.address[0]}:{reply.address[1]}"
        yield ok("peer", f"{self._id} answers unicasts", f"{where}, TTL {reply.ttl}")
        if not self._heard:
            yield fail(
                "multicast",
                f"{self._id} answers unicasts, but no multicasts",
                f"discovery by {self._probe.group[0]} got no answer, {where} did",
                "multicasts are filtered on the way, or its node manager has not joined the group on that interface: "
                "see `ip maddr` there; else give static addresses (docs/node-manager.md)",
            )
        if reply.address != self._address:
            yield warn(
                "source port",
                f"{self._id} answers from {where}, and was asked at {self._address[0]}:{self._address[1]}",
                "peers learn the first, and firewalls may allow only the second",
                f"let it send from the port on which it receives ({self._address[1]})",
            )

    def _check_wildcard(self) -> Finding:
        everyone = replace(self._id, component=ANY_COMPONENT)
        if self._ask([_identify()], WILDCARD_TIME, to=everyone):
            return ok("component 255", f"{self._id} answers what is sent to {everyone}")
        return fail(
            "component 255",
            f"{self._id} ignores messages to {everyone}",
            "QueryIdentification to its own id was answered, to all components of its node was not",
            "its node manager or its library has to take component 255 for its own id; clients that address all "
            "components, as judges of competitions do, get no answer",
        )

    def _check_fragments(self) -> Finding:
        large = self._ask([_identify()], LARGE_TIME, padding=PADDING)
        lost = self._probe.fragments.get(self._id)
        if lost is not None and (lost.first == 0 or lost.last == 0 or lost.first != lost.last):
            return fail(
                "fragments",
                f"large messages of {self._id} do not become complete",
                f"{lost.first} first, {lost.others} middle and {lost.last} last fragments arrived",
                "look for packet loss on the way, and for an MTU that differs between both ends",
            )
        if large:
            return ok("fragments", f"datagrams of {PADDING} bytes reach {self._id}")
        return fail(
            "fragments",
            f"large datagrams do not reach {self._id}",
            f"a query in a datagram of {PADDING} bytes got no answer, in a small one it did",
            "something on the way drops IP fragments or has a smaller MTU: compare ip link on both ends, and test with "
            "ping -s 4000; packets of at most 1400 bytes need no fragments (MTU_Size of the JAUS Toolset)",
        )

    # --- what it is

    def _check_services(self, report: ReportServices | None) -> Iterator[Finding]:
        if report is None:
            yield warn(
                "versions",
                f"{self._id} does not report its services",
                "QueryServices got no readable answer",
                "clients that choose by service do not find it; it has to offer Discovery",
            )
            return
        offered = _offered(report, self._id)
        if not offered:
            yield fail(
                "versions",
                f"{self._id} reports no services of its own",
                f"ReportServices lists {sum(len(node.component_list) for node in report.node_list)} components",
                "check that its services are registered with Discovery under this id",
            )
            return
        known = {urn: versions_of(urn) for urn, _ in offered}
        differing = [f"{urn} {version}" for urn, version in offered if known[urn] and version not in known[urn]]
        unknown = [f"{urn} {version}" for urn, version in offered if not known[urn]]
        for other in differing:
            urn = other.partition(" ")[0]
            yield fail(
                "versions",
                f"{self._id} has {other}, and jauspy has {' and '.join(sorted(known[urn]))}",
                "messages of the same id may differ between versions",
                "get its definition (JSIDL) and load it with --schemas, or update the older side",
            )
        if unknown:
            yield warn(
                "versions",
                f"{len(unknown)} services of {self._id} are not known here",
                ", ".join(unknown[:4]) + (" ..." if len(unknown) > 4 else ""),
                "get their definitions (JSIDL) and load them with --schemas",
            )
        if not differing and not unknown:
            yield ok("versions", f"all {len(offered)} services of {self._id} have versions that are known here")

    def _check_control(self, control: ReportControl | None, authority: ReportAuthority | None) -> Finding:
        if control is None:
            return warn(
                "control",
                f"{self._id} does not tell who controls it",
                "QueryControl got no readable answer",
                "it has no AccessControl, so nobody can take control of it; or its answer is malformed",
            )
        holder = JausID(control.subsystem_id, control.node_id, control.component_id)
        if holder != JausID(0, 0, 0):
            held = f"held by {holder} with authority {control.authority_code}"
            if self._authority > control.authority_code:
                return warn(
                    "control",
                    f"control of {self._id} is {held}",
                    f"a client with {self._authority} takes it over",
                    "agree with its user first",
                )
            return fail(
                "authority",
                f"control of {self._id} is {held}, and an authority of {self._authority} is too low to take it",
                f"ReportControl of {self._id}",
                f"let {holder} release control, or use an authority above {control.authority_code}",
            )
        needed = authority.authority_code if authority is not None else 0
        if self._authority < needed:
            return fail(
                "authority",
                f"an authority of {self._authority} is too low for {self._id}, which needs {needed}",
                f"ReportAuthority of {self._id}; nobody has control",
                f"request control with an authority of {needed} or more",
            )
        return ok("control", f"nobody controls {self._id}, and it needs an authority of {needed}")

    def _check_presence(self, services: ReportServices | None) -> Iterator[Finding]:
        """Ask for one optional field, and compare the presence vector of the answer."""
        for query, report in _optional_queries(_offered(services, self._id) if services else []):
            found = self._ask([query(presence_vector=1)], LAST_TIME)  # type: ignore[call-arg]  # all have that field
            answers = [reply.content.payload for reply in found if reply.content.code == report.CODE]
            if not answers:
                yield warn(
                    "presence vector",
                    f"{self._id} does not answer {query.NAME} with presence vector 1",
                    "its service is in the list of services",
                    "it may answer only some presence vectors: ask with another, `jauspy query ID "
                    f"{query.NAME} presence_vector=0x43`",
                )
                return
            vector = presence_vector(answers[-1], report)
            if vector & ~1:
                yield fail(
                    "presence vector",
                    f"{self._id} answers {query.NAME} with fields that were not asked for",
                    f"asked for 0x1, and the report has 0x{vector:X}",
                    "a report has only the fields that are both asked for and supported; clients that rely on it read "
                    "wrong values",
                )
            else:
                yield ok("presence vector", f"{self._id} keeps to the presence vector of {query.NAME}")
            return

    def _check_seals(self, services: ReportServices | None) -> Iterator[Finding]:
        """Have the component judge a sealed query, which changes nothing."""
        offers = services is not None and any(
            urn == QuerySealChallenge.SERVICE for urn, _ in _offered(services, self._id)
        )
        challenge = None
        if offers or self._key is not None:
            challenge = _last(self._ask([QuerySealChallenge()], LAST_TIME), ReportSealChallenge)
        if challenge is None:
            if self._key is not None:
                yield warn(
                    "seal",
                    f"{self._id} takes no sealed commands",
                    "it gave no challenge",
                    "the operator's key is of no use for it; name operators in its robot's file (docs/security.md)",
                )
            return
        if self._key is None:
            yield warn(
                "seal",
                f"{self._id} takes sealed commands, and may refuse others",
                "it gave a challenge",
                "name your key with --operator-key to have it tested; `jauspy keys new` makes one",
            )
            return
        sealed = self._key.seal(
            QueryControl(),
            challenge,
            destination=self._id,
            source=self._probe.id_at(self._interface),
            elapsed=0.0,
            counter=1,
        )
        replies = self._ask([sealed], LAST_TIME)
        rejected = _last(replies, RejectCommand)
        if rejected is not None:
            yield fail(
                "seal",
                f"{self._id} refuses what is sealed with this key: {explained(rejected.reason)}",
                f"RejectCommand, reason {int(rejected.reason)}, for a sealed QueryControl",
                "add the key's lines (`jauspy keys show`) to the robot's operators file, with a role that may command",
            )
        elif _last(replies, ReportControl) is not None:
            yield ok("seal", f"{self._id} takes what is sealed with this key")
        else:
            yield warn(
                "seal", f"{self._id} did not answer a sealed query", "", "try again; the challenge may have been lost"
            )


# --- parts of the answers -------------------------------------------------------------------------------------------


def _identify() -> QueryIdentification:
    return QueryIdentification(QueryIdentification.QueryType.COMPONENT)


def _services_of(id: JausID) -> QueryServices:
    component = QueryServices.QueriedComponentRec(id.component)
    return QueryServices([QueryServices.NodeSeq(QueryServices.QueriedNodeRec(id.node), [component])])


def _last(replies: Sequence[Reply], kind: type[M]) -> M | None:
    """The newest answer of this kind, in any version of its service."""
    for reply in reversed(replies):
        message = reply.content.message
        if message is not None and message.CODE == kind.CODE:
            if isinstance(message, kind):
                return message
            try:
                return registry.decode_as(kind, reply.content.payload, strict=False)[0]
            except JausError:
                return None
    return None


def _offered(report: ReportServices, id: JausID) -> list[tuple[str, str]]:
    """The services of one component: URN and version."""
    return [
        (service.uri, f"{service.major_version_number}.{service.minor_version_number}")
        for node in report.node_list
        if node.node_rec.node_id == id.node
        for component in node.component_list
        if component.component_rec.component_id == id.component
        for service in component.service_list
    ]


def _optional_queries(offered: Sequence[tuple[str, str]]) -> Iterator[tuple[type[Message], type[Message]]]:
    """Queries of the offered services with a presence vector whose reports have optional fields."""
    services = set(offered)
    for entry in registry.entries:
        if (entry.service, entry.version) not in services or not entry.name.startswith("Query"):
            continue
        query = entry.load()
        report = getattr(query, "REPORT", None)
        names = {slot.name for slot in layout.slots} if isinstance(layout := query.layout(), Composite) else set()
        if report is not None and names == {"presence_vector"} and _presence_size(report):
            yield query, report


def _presence_size(report: type[Message]) -> int:
    layout = report.layout()
    return SIZES[layout.presence] if isinstance(layout, Composite) and layout.presence else 0


def presence_vector(payload: bytes, report: type[Message]) -> int:
    """The presence vector in the bytes of a report, which follows the message id."""
    return int.from_bytes(payload[2 : 2 + _presence_size(report)], "little")


_STATES: Final = {
    ReportStatus.Status.SHUTDOWN: "in Shutdown, where it takes no commands",
    ReportStatus.Status.FAILURE: "in Failure, where it takes no commands",
    ReportStatus.Status.EMERGENCY: "in Emergency, where it does not move",
}


def _check_status(id: JausID, status: ReportStatus | None) -> Finding:
    if status is None:
        return warn(
            "status",
            f"{id} does not report its status",
            "QueryStatus got no readable answer",
            "components without Management have no Standby and no Emergency; for others, check that it still runs",
        )
    name = getattr(status.status, "name", str(status.status)).lower()
    if status.status in _STATES:
        return warn(
            "status",
            f"{id} is {_STATES[ReportStatus.Status(status.status)]}",
            f"ReportStatus {name}",
            "whoever set it has to clear it: ClearEmergency from the same id, or Reset",
        )
    return ok("status", f"{id} is in {name}")


def check_peer_clock(report: ReportTime | None, arrived: datetime) -> Finding:
    """The difference between its clock and ours; a time without a date counts within the month."""
    if report is None or (time := report.time_stamp) is None:
        return warn(
            "clock",
            "the peer does not tell its time",
            "QueryTime got no answer with a time stamp",
            "compare both clocks by hand (date -u); time stamps of poses and authentication need them to agree",
        )
    theirs = time.day * 86400.0 + time.hour * 3600.0 + time.minutes * 60.0 + time.seconds + time.milliseconds / 1e3
    midnight = arrived.replace(hour=0, minute=0, second=0, microsecond=0)
    ours = arrived.day * 86400.0 + (arrived - midnight).total_seconds()
    difference = theirs - ours
    if abs(difference) > _MONTH / 2.0:  # one of both is in the next month already
        difference -= _MONTH if difference > 0 else -_MONTH
    date = report.date_stamp
    wrong_date = date is not None and (2000 + date.year, date.month) != (arrived.year, arrived.month)
    if abs(difference) <= CLOCK_TOLERANCE and not wrong_date:
        return ok("clock", f"its clock agrees with ours within {CLOCK_TOLERANCE:g} s")
    evidence = f"it says day {time.day}, {time.hour:02}:{time.minutes:02}:{time.seconds:02} UTC"
    if date is not None:
        evidence += f" of {2000 + date.year}-{date.month:02}"
    what = "its clock has another date" if wrong_date else f"its clock differs from ours by {difference:+.1f} s"
    return fail("clock", what, evidence, "let both use one time server (chrony, timedatectl set-ntp true), in UTC")


def check_deviations(replies: Sequence[Reply]) -> Iterator[Finding]:
    """Answers that are shorter or otherwise different from their definitions."""
    for code in dict.fromkeys(reply.content.code for reply in replies):
        content = next(reply.content for reply in replies if reply.content.code == code)
        name = content.message.NAME if content.message is not None else f"message {code or 0:04X}h"
        if content.broken or content.deviations:
            yield fail(
                "content",
                f"its {name} differs from the definition",
                content.problem or content.deviations[0],
                "see `jauspy decode --explain --as message " + content.payload[:48].hex() + "`",
            )
