"""The Interoperability Profile v3: what every platform offers, does and answers, and what it offers beside that.

The target is a platform, as in `--target 101`: some services each of its components has, others one of them has. Which
are demanded is listed in `PLATFORM` and `EVERY_COMPONENT`, with the sources in ADR 187.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Final

from jauspy.codec.message import Message
from jauspy.codec.registry import MessageEntry
from jauspy.conformance.checks import Check, has, that
from jauspy.conformance.profile import ALL_SERVICES, Action, Offers, Profile, ServiceKey, Step
from jauspy.conformance.results import Failed, Silent, Skipped
from jauspy.conformance.state_tests.neutral_messages import neutral
from jauspy.conformance.tester import Tester, pauses
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import (
    AllEventsRec,
    ConfirmControl,
    QueryAuthority,
    QueryControl,
    QueryEvents,
    QueryHeartbeatPulse,
    QueryIdentification,
    QueryStatus,
    QueryTimeout,
    RejectControl,
    ReleaseControl,
    ReportAuthority,
    ReportControl,
    ReportEvents,
    ReportHeartbeatPulse,
    ReportIdentification,
    ReportServices,
    ReportStatus,
    ReportTimeout,
    RequestControl,
)
from jauspy.messages.iop import (
    ConfirmHandoffRequest,
    ConfirmPlatformStateRequest,
    ConfirmReleaseControl,
    QueryEnhancedTimeout,
    QueryHandoffTimeout,
    QueryPlatformMode,
    QueryPlatformState,
    QuerySupportedPlatformModes,
    ReleaseControlRec,
    ReportEnhancedTimeout,
    ReportHandoffTimeout,
    ReportPlatformMode,
    ReportPlatformState,
    ReportSupportedPlatformModes,
    RequestHandoff,
    RequestReleaseControl,
    SetPlatformState,
)

CORE: Final = "urn:jaus:jss:core:"
IOP: Final = "urn:jaus:jss:iop:"
PROFILE_SETS: Final = (IOP, "urn:jaus:jss:exp:aeodrs:")

EVERY_COMPONENT: Final = ("Transport", "Events", "AccessControl", "Management")
"""Core services that each component has which can be controlled; Transport is found by its answers alone."""
PLATFORM_CORE: Final = ("Discovery", "Liveness")
"""Core services that at least one component of a platform has."""
PLATFORM: Final = ("EnhancedAccessControl", "UnsolicitedHeartbeat", "PlatformState", "PlatformMode")
"""Services of the profile that at least one component of a platform has."""
VERSION: Final = "1.1"

CLIENT, OTHER = "42.2.1", "42.2.2"
"""The clients: one that takes control, another that asks for it."""
AUTHORITY: Final = 200
State = ReportPlatformState.PlatformState
Wanted = SetPlatformState.PlatformState
Code = ConfirmHandoffRequest.ResponseCode
Decision = ReleaseControlRec.ResponseCode


def name_of(urn: str) -> str:
    """The last part of a URN."""
    return urn.rpartition(":")[2]


# --- what is offered --------------------------------------------------------------------------------------------------


def versions(offers: Offers, urn: str) -> Mapping[JausID, list[str]]:
    """The versions of a service that each component offers."""
    found = {
        id: sorted(version for offered, version in services if offered == urn)
        for id, services in sorted(offers.components.items())
    }
    return {id: offered for id, offered in found.items() if offered}


def provider(offers: Offers, urn: str, version: str = VERSION) -> JausID | None:
    """The first component that offers a service in a version."""
    return next((id for id, offered in versions(offers, urn).items() if version in offered), None)


def is_offered(offers: Offers, urn: str) -> Action:
    """A step that finds a component with the service, in the version of the profile."""

    def action(tester: Tester) -> None:
        found = versions(offers, urn)
        tester.expected.append(f"{urn} {VERSION} in the list of services of a component")
        if not found:
            raise Failed(f"no component of {tester.target} offers {urn}; each platform must offer it in {VERSION}")
        name = name_of(urn)
        others = "; ".join(f"{id} offers {name} {' and '.join(offered)}" for id, offered in found.items())
        right = provider(offers, urn) is not None
        tester.check(f"{name} is offered in version {VERSION}", "" if right else f"{others}, not {VERSION}")

    return action


def component_offers(offers: Offers, id: JausID) -> Action:
    """A step that compares the services of a component with those that each has that can be controlled."""

    def action(tester: Tester) -> None:
        for name in EVERY_COMPONENT[1:]:
            offered = versions(offers, CORE + name).get(id, [])
            other = f", but {' and '.join(offered)}" if offered else ""
            problem = "" if VERSION in offered else f"{id} does not offer {name} {VERSION}{other}"
            tester.check(f"{id} offers {name} {VERSION}", problem)

    return action


def offered_steps(offers: Offers) -> Iterator[Step]:
    """The steps on lists of services."""
    for name in PLATFORM_CORE:
        yield Step(f"platform/{name}", f"a component offers {name}", is_offered(offers, CORE + name))
    for name in PLATFORM:
        yield Step(f"platform/{name}", f"a component offers {name}", is_offered(offers, IOP + name))
    for id in controllable(offers):
        yield Step(f"{id}/services", "core services of the component", component_offers(offers, id))


def controllable(offers: Offers) -> list[JausID]:
    """The components that have a service that inherits from AccessControl, or itself."""
    access = {f"{CORE}AccessControl", f"{CORE}Management"}
    return [
        id
        for id, services in sorted(offers.components.items())
        if any(urn in access or (urn.startswith(PROFILE_SETS) and _is_commanded(urn)) for urn, _ in services)
    ]


def _is_commanded(urn: str) -> bool:
    return any(entry.service == urn and entry.load().IS_COMMAND for entry in registry.entries)


# --- what each component answers --------------------------------------------------------------------------------------

CORE_QUERIES: Final[Mapping[str, Sequence[tuple[Message, type[Message]]]]] = {
    "Events": ((QueryEvents(AllEventsRec(0)), ReportEvents),),
    "AccessControl": (
        (QueryControl(), ReportControl),
        (QueryAuthority(), ReportAuthority),
        (QueryTimeout(), ReportTimeout),
    ),
    "Management": ((QueryStatus(), ReportStatus),),
    "Liveness": ((QueryHeartbeatPulse(), ReportHeartbeatPulse),),
    "Discovery": (
        (QueryIdentification(QueryIdentification.QueryType.COMPONENT), ReportIdentification),
        (ALL_SERVICES, ReportServices),
    ),
}
"""Queries by service, each with its report."""


def asks(id: JausID, query: Message, report: type[Message], *checks: Check | Iterable[Check]) -> Action:
    """A step in which one component answers a query."""
    return lambda tester: tester.client(OTHER).ask(query, report, *checks, to=id)


NUMBER_FIELDS: Final = frozenset({"sensor_id", "illuminator_id", "annunciator_id", "reminder_id", "zone_id"})
"""Fields of queries that name one of several things; the definitions do not say where their numbers begin."""


def asks_for_first(id: JausID, kind: type[Message], report: type[Message]) -> Action:
    """A step in which a query is answered; one for a numbered thing, as a camera, for number 1 or for number 0."""

    def action(tester: Tester) -> None:
        query = neutral(kind)
        names, notes = [name for name in NUMBER_FIELDS if hasattr(query, name)], tester.notes_of_step()
        for name in names:
            setattr(query, name, 1)
        try:
            tester.client(OTHER).ask(query, report, to=id)
        except Silent:
            if not names:
                raise
            tester.restore_notes(notes)
            tester.client(OTHER).ask(neutral(kind), report, to=id)

    return action


def core_steps(offers: Offers) -> Iterator[Step]:
    """The queries of the core services that each component offers."""
    for id, services in sorted(offers.components.items()):
        for name, pairs in CORE_QUERIES.items():
            if (CORE + name, VERSION) in services:
                for query, report in pairs:
                    yield Step(f"{id}/{query.NAME}", f"{query.NAME} is answered", asks(id, query, report))


# --- what the services of the platform do -----------------------------------------------------------------------------


BROADCAST_TIME: Final = 6.0
"""Seconds in which an unsolicited broadcast must come."""


def comes_unasked(id: JausID, report: type[Message]) -> Action:
    """A step in which a report comes that nobody has asked for."""

    def action(tester: Tester) -> None:
        client = tester.client(OTHER)
        client.send(QueryHeartbeatPulse(), to=id)  # a node manager sends no broadcasts to clients that it does not know
        client.expect(ReportHeartbeatPulse, source=id)
        client.forget(report)
        client.expect(report, within=BROADCAST_TIME / tester.timeout, source=id)

    return action


def take_control(tester: Tester, id: JausID, client: str = CLIENT, authority: int = AUTHORITY) -> None:
    """Request control for a client, which must be accepted."""
    accepted = has(response_code=ConfirmControl.ResponseCode.CONTROL_ACCEPTED)
    tester.client(client).ask(RequestControl(authority), ConfirmControl, accepted, to=id)


def release(tester: Tester, id: JausID, client: str = CLIENT) -> None:
    """Release control."""
    tester.client(client).ask(ReleaseControl(), RejectControl, to=id)


def handoff(id: JausID, decision: ReleaseControlRec.ResponseCode, result: ConfirmHandoffRequest.ResponseCode) -> Action:
    """A step in which a client asks the one in control to hand over, and that one decides."""

    def action(tester: Tester) -> None:
        take_control(tester, id)
        holder, asking = tester.client(CLIENT), tester.client(OTHER)
        holder.forget(RequestReleaseControl)
        queued = asking.ask(
            RequestHandoff(AUTHORITY, "conformance test"), ConfirmHandoffRequest, has(response_code=Code.QUEUED), to=id
        )
        listed = that(
            f"lists the request of {OTHER}",
            lambda message: any(
                record.id == queued.id and record.src_subsystem_id == 42
                for record in message.request_release_control_list
            ),
        )
        holder.expect(RequestReleaseControl, listed, source=id)
        asking.forget(ConfirmHandoffRequest)
        holder.send(ConfirmReleaseControl([ReleaseControlRec(queued.id, decision)]), to=id)
        asking.expect(ConfirmHandoffRequest, has(id=queued.id, response_code=result), source=id)
        granted = decision == Decision.GRANTED
        owner = OTHER if granted else CLIENT
        in_control = has(component_id=JausID.parse(owner).component, node_id=JausID.parse(owner).node)
        asking.ask(QueryControl(), ReportControl, in_control, to=id)
        release(tester, id, owner)

    return action


def handoff_without_control(tester: Tester, id: JausID) -> None:
    """Nobody is in control, so a handoff is denied: control can be requested."""
    tester.client(OTHER).ask(
        RequestHandoff(AUTHORITY, "conformance test"), ConfirmHandoffRequest, has(response_code=Code.DENIED), to=id
    )


def statuses(tester: Tester, ids: Iterable[JausID], status: ReportStatus.Status, *, reached: bool) -> None:
    """Check that each component gets into a state, or leaves it, within a timeout."""
    wrong = list(ids)
    what = f"every component {'goes to' if reached else 'leaves'} {status.name}"
    for pause in pauses(tester.timeout):
        wrong = [id for id in wrong if (_status(tester, id) == status) is not reached]
        if not wrong:
            break
        tester.wait(pause)
    verb = "is not in" if reached else "is still in"
    tester.check(what, f"{', '.join(map(str, wrong))} {verb} {status.name}" if wrong else "")


def _status(tester: Tester, id: JausID) -> int:
    return int(tester.client(OTHER).ask(QueryStatus(), ReportStatus, to=id).status)


def emergency(id: JausID, managed: Sequence[JausID]) -> Action:
    """A step that brings the platform into an emergency and out of it; every component must follow."""

    def action(tester: Tester) -> None:
        client = tester.client(CLIENT)
        take_control(tester, id)
        for wanted, state, reached in (
            (Wanted.EMERGENCY, State.EMERGENCY, True),
            (Wanted.OPERATIONAL, State.OPERATIONAL, False),
        ):
            confirmed = has(platform_state=wanted, response_code=ConfirmPlatformStateRequest.ResponseCode.TRANSITIONING)
            client.ask(SetPlatformState(wanted), ConfirmPlatformStateRequest, confirmed, to=id)
            client.ask_until_right(QueryPlatformState(), ReportPlatformState, has(platform_state=state), to=id)
            statuses(tester, managed, ReportStatus.Status.EMERGENCY, reached=reached)
        release(tester, id)

    return action


def no_emergency_without_control(id: JausID) -> Action:
    """A step in which a client without control commands a state, which must not change: nor while another has it."""

    def action(tester: Tester) -> None:
        other = tester.client(OTHER)
        for is_controlled in (False, True):
            if is_controlled:
                take_control(tester, id)
            other.send(SetPlatformState(Wanted.EMERGENCY), to=id)
            other.silence()
            other.ask(QueryPlatformState(), ReportPlatformState, has(platform_state=State.OPERATIONAL), to=id)
        release(tester, id)

    return action


def mode_is_supported(tester: Tester, id: JausID) -> None:
    """The mode is one of those that the platform says it has."""
    client = tester.client(OTHER)
    report = client.ask(QueryPlatformMode(), ReportPlatformMode, to=id)
    listed = that(
        f"lists mode {int(report.platform_mode)}, which is the present one",
        lambda found: report.platform_mode in {rec.platform_mode for rec in found.supported_platform_modes_list},
    )
    client.ask(QuerySupportedPlatformModes(), ReportSupportedPlatformModes, listed, to=id)


def _on(id: JausID, test: Callable[[Tester, JausID], None]) -> Action:
    return lambda tester: test(tester, id)


def platform_steps(offers: Offers) -> Iterator[Step]:
    """Steps for the services of the platform, each at the component that offers it."""
    if (id := provider(offers, f"{IOP}UnsolicitedHeartbeat")) is not None:
        yield Step("heartbeat", "a heartbeat comes without a query", comes_unasked(id, ReportHeartbeatPulse))
    if (id := provider(offers, f"{IOP}UnsolicitedBroadcastControlAvailable")) is not None:
        yield Step("control", "a report of control comes without a query", comes_unasked(id, ReportControl))
    if (id := provider(offers, f"{IOP}EnhancedAccessControl")) is not None:
        yield Step(
            "handoff/time-out", "the time-out of requests", asks(id, QueryHandoffTimeout(), ReportHandoffTimeout)
        )
        yield Step(
            "handoff/enhanced-time-out",
            "the time-out of requests that are put off",
            asks(id, QueryEnhancedTimeout(), ReportEnhancedTimeout),
        )
        yield Step("handoff/no-control", "nobody is in control", _on(id, handoff_without_control))
        yield Step("handoff/denied", "the client in control denies", handoff(id, Decision.DENIED, Code.DENIED))
        yield Step("handoff/deferred", "the client in control puts off", handoff(id, Decision.WAIT, Code.DEFERRED))
        yield Step("handoff/granted", "the client in control grants", handoff(id, Decision.GRANTED, Code.GRANTED))
    if (id := provider(offers, f"{IOP}PlatformMode")) is not None:
        yield Step("mode", "the mode is one of those supported", _on(id, mode_is_supported))
    if (id := provider(offers, f"{IOP}PlatformState")) is not None:
        managed = [one for one, services in sorted(offers.components.items()) if _is_managed(services)]
        operational = has(platform_state=State.OPERATIONAL)
        yield Step(
            "state", "the platform is operational", asks(id, QueryPlatformState(), ReportPlatformState, operational)
        )
        yield Step("state/no-control", "a client without control changes nothing", no_emergency_without_control(id))
        yield Step("state/emergency", "every component is in the emergency", emergency(id, managed))


def _is_managed(services: frozenset[ServiceKey]) -> bool:
    return (f"{CORE}Management", VERSION) in services


# --- per capability ---------------------------------------------------------------------------------------------------


def queries_of(key: ServiceKey) -> list[tuple[type[Message], type[Message]]]:
    """The queries of a service's own, each with its report."""
    found: list[tuple[type[Message], type[Message]]] = []
    entries: Iterable[MessageEntry] = registry.entries
    for entry in entries:
        if (entry.service, entry.version) == key:
            kind = entry.load()
            report = getattr(kind, "REPORT", None)
            if kind.IS_QUERY and report is not None:
                found.append((kind, report))
    return sorted(found, key=lambda pair: pair[0].CODE)


def capability_steps(offers: Offers) -> Iterator[Step]:
    """The queries of all other services of the profile that each component offers."""
    handled = {IOP + name for name in (*PLATFORM, "UnsolicitedBroadcastControlAvailable")}
    for id, services in sorted(offers.components.items()):
        for urn, version in sorted(services):
            if not urn.startswith(PROFILE_SETS) or urn in handled:
                continue
            pairs = queries_of((urn, version))
            if not pairs:
                yield Step(f"{id}/{name_of(urn)}", "the service has no queries", _skip("it has no query of its own"))
            for query, report in pairs:
                yield Step(
                    f"{id}/{name_of(urn)}/{query.NAME}",
                    f"{query.NAME} is answered",
                    asks_for_first(id, query, report),
                    why=f"{urn} {version}",
                )


def _skip(reason: str) -> Action:
    def action(tester: Tester) -> None:  # noqa: ARG001 - nothing is tried
        raise Skipped(reason)

    return action


def steps(offers: Offers) -> Sequence[Step]:
    """All steps for a platform. Raises `ConfigError` if it lists no services at all."""
    if not any(offers.components.values()):
        raise ConfigError("the target lists no services, so nothing was tested; name them by --services")
    return [*offered_steps(offers), *core_steps(offers), *platform_steps(offers), *capability_steps(offers)]


PROFILE: Final = Profile(
    "iop-v3",
    "Interoperability Profile v3: what every platform must offer, and what this one offers beside that",
    steps,
    (
        "which services are demanded of every platform is our reading of public sources (ADR 187)",
        "of capabilities it tests the queries; the URN of a service in place of the profile tests every transition",
    ),
)
