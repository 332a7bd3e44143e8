"""Components that break their state machines; a sample for the profiles made from JSIDL."""

from __future__ import annotations

from typing import Final

from tests.conformance.injectors import (
    Fault,
    Injector,
    deaf_to,
    field,
    instead,
    later,
    patched,
    repacked,
    says,
    short,
    without,
    works,
)
from tests.conformance.mistakes import (
    ACCEPTED,
    anybody,
    anything,
    big_endian,
    chatty,
    clears_all,
    confirmed,
    elsewhere,
    goes_on,
    idle,
    not_told,
    reports_pass,
    sixty_hertz,
    skipping,
    swapped_bits,
    to_winner,
    unmasked,
)

from jauspy.messages import core, mobility
from jauspy.services import messaging
from jauspy.services.core import AccessControl, Events, ListManager, Management, events as event_reports

READY, STANDBY = "Controlled.Available.Ready", "Controlled.Available.Standby"
EMERGENCY, FREE = "Controlled.NotAvailable.Emergency", "NotControlled.Available.Standby"


def core_fault(name: str, steps: str, inject: Injector, profile: str = "core-1.1", fails: str = "") -> Fault:
    """Only these steps are run, all of which are to be tripped, unless it is said which."""
    only = tuple(steps.split())
    return Fault(name, profile, tuple(fails.split()) or only, inject, timeout=5, motion=True, still=True, only=only)


GENERATED: Final = (
    core_fault(
        "control not checked",
        f"{READY}/Standby/rival {STANDBY}/Resume/rival {READY}/ReleaseControl/rival",
        patched(AccessControl, is_controlling_client=anybody),
    ),
    core_fault(
        "lists are taken from anybody",
        f"{STANDBY}/DeleteElement/rival/an-unknown-one",
        patched(AccessControl, is_controlling_client=anybody),
    ),
    core_fault("the loser is not told", f"{READY}/RequestControl/rival/more-authority", says(not_told)),
    core_fault(
        "any authority takes over",
        f"{READY}/RequestControl/rival/less-authority",
        patched(AccessControl, is_current_authority_less=anybody),
    ),
    core_fault(
        "the default authority does not count",
        f"{FREE}/RequestControl/rival/authority-below-the-default",
        patched(AccessControl, is_default_authority_greater=lambda self, msg: False),
    ),
    core_fault(
        "control never ends by itself",
        f"{READY}/Timedout/pilot/the-client-is-silent",
        patched(AccessControl, reset_timer=idle),
    ),
    core_fault(
        "authority may be raised",
        f"{READY}/SetAuthority/pilot/more-authority",
        patched(AccessControl, is_authority_valid=anybody),
    ),
    core_fault("authority cannot be lowered", f"{READY}/SetAuthority/pilot/less-authority", deaf_to(core.SetAuthority)),
    core_fault(
        "control is given during an emergency",
        f"{EMERGENCY}/RequestControl/rival/more-authority",
        field(core.ConfirmControl, response_code=ACCEPTED),
    ),
    core_fault(
        "anybody clears an emergency",
        f"{EMERGENCY}/ClearEmergency/pilot",
        patched(Management, is_id_stored=anybody, delete_id=clears_all),
    ),
    core_fault("emergency is ignored", f"{READY}/SetEmergency/rival", deaf_to(core.SetEmergency)),
    core_fault("Reset is ignored", f"{READY}/Reset/pilot", deaf_to(core.Reset)),
    core_fault("Standby is ignored", f"{READY}/Standby/pilot", deaf_to(core.Standby)),
    core_fault("Shutdown is ignored", f"{READY}/Shutdown/pilot", deaf_to(core.Shutdown)),
    core_fault("unknown events are cancelled", f"{FREE}/CancelEvent/rival/an-unknown-one", reports_pass()),
    core_fault("a report passes as a query", f"{FREE}/CreateEvent/rival/a-report-instead-of-a-query", reports_pass()),
    core_fault("events are not updated", f"{FREE}/UpdateEvent/rival/one-that-is-there", deaf_to(core.UpdateEvent)),
    core_fault(
        "events never end", f"{FREE}/Timeout/rival/an-event-is-not-renewed", patched(Events, reset_event_timer=idle)
    ),
    core_fault("events never come", f"{FREE}/EventOccurred/rival/an-event-is-due", without(core.Event)),
    core_fault(
        "identification is always of the system",
        f"{FREE}/QueryIdentification/rival/level-2",
        field(core.ReportIdentification, query_type=1),
    ),
    core_fault("ReportTime is short", f"{FREE}/QueryTime/rival/all-fields", short(core.ReportTime)),
    core_fault("ReportControl is short", f"{FREE}/QueryControl/rival", short(core.ReportControl)),
    core_fault("commands are answered", f"{READY}/Standby/pilot {READY}/Standby/rival", chatty(core.Standby)),
    core_fault(
        "wrong elements are confirmed",
        f"{STANDBY}/SetElement/pilot/after-an-unknown-one",
        instead(core.RejectElementRequest, lambda message: core.ConfirmElementRequest(message.request_id)),
    ),
    core_fault(
        "time ignores the presence vector", f"{FREE}/QueryTime/rival/no-fields", patched(messaging, mask=unmasked)
    ),
    core_fault(
        "poses ignore the presence vector",
        f"{FREE}/QueryLocalPose/rival/no-fields",
        patched(messaging, mask=unmasked),
        profile="mobility-1.1",
    ),
    core_fault(
        "poses are short",
        f"{FREE}/QueryLocalPose/rival/all-fields",
        short(mobility.ReportLocalPose),
        profile="mobility-1.1",
    ),
    core_fault(
        "speed is not reported",
        f"{FREE}/QueryTravelSpeed/rival",
        deaf_to(mobility.QueryTravelSpeed),
        profile="mobility-1.1",
    ),
    core_fault(
        "waypoints are answered",
        f"{STANDBY}/SetLocalWaypoint/pilot",
        chatty(mobility.SetLocalWaypoint),
        profile="mobility-1.1",
    ),
    core_fault(
        "events come faster than was confirmed",
        f"{FREE}/EventOccurred/rival/an-event-is-due",
        patched(Events, _set_rate=sixty_hertz),
    ),
    core_fault("cancelled events go on", f"{FREE}/CancelEvent/rival/one-that-is-there", goes_on()),
    core_fault(
        "events are confirmed and not kept",
        f"{FREE}/CreateEvent/rival/a-new-one",
        instead(core.ReportEvents, lambda report: core.ReportEvents([])),
    ),
    core_fault(
        "an update makes another event", f"{FREE}/UpdateEvent/rival/one-that-is-there", confirmed(2, event_id=99)
    ),
    core_fault("changes are not told", f"{READY}/CreateEvent/pilot/of-changes", without(core.Event)),
    core_fault(
        "what has not changed is told, too",
        f"{READY}/CreateEvent/pilot/of-changes",
        patched(event_reports, _is_due=anything),
    ),
    core_fault(
        "commands never take too long",
        f"{READY}/CommandExpired/pilot/a-command-does-not-end",
        patched(Events, start_command_timer=idle),
    ),
    core_fault(
        "elements are confirmed and not kept",
        f"{STANDBY}/SetElement/pilot/a-new-one",
        patched(ListManager, set_element=idle),
    ),
    core_fault(
        "lists take nothing",
        f"{STANDBY}/SetElement/pilot/a-new-one",
        patched(ListManager, is_element_supported=lambda self, msg: False),
    ),
    core_fault(
        "deleted elements stay",
        f"{STANDBY}/DeleteElement/pilot/one-that-is-there",
        patched(ListManager, delete_element=idle),
    ),
    core_fault(
        "lists take what nobody can carry out",
        f"{STANDBY}/SetElement/pilot/an-unknown-message",
        instead(core.RejectElementRequest, lambda message: core.ConfirmElementRequest(message.request_id)),
    ),
    core_fault(
        "Resume works once",
        f"{STANDBY}/Resume/pilot {READY}/Standby/pilot {READY}/Reset/pilot",
        later(core.Resume, 2, deaf_to(core.Resume)),
        fails=f"{READY}/Reset/pilot",
    ),
    core_fault(
        "travel speeds are not used",
        f"{READY}/SetTravelSpeed/pilot",
        deaf_to(mobility.SetTravelSpeed),
        profile="mobility-1.1",
    ),
    core_fault(
        "velocities are taken from anybody",
        f"{READY}/SetVelocityCommand/rival/for-now",
        patched(AccessControl, is_controlling_client=anybody),
        profile="mobility-1.1",
    ),
    core_fault(
        "waypoints are forgotten",
        f"{READY}/QueryLocalWaypoint/pilot/all-fields-of-one-that-was-set",
        deaf_to(mobility.SetLocalWaypoint),
        profile="mobility-1.1",
    ),
    core_fault(
        "lists are not carried out",
        f"{READY}/ExecuteList/pilot/from-one-that-is-there",
        deaf_to(mobility.ExecuteList),
        profile="mobility-1.1",
    ),
    core_fault("the time is not set", f"{READY}/SetTime/pilot", deaf_to(core.SetTime)),
    core_fault(
        "the time is set by anybody", f"{READY}/SetTime/rival", patched(AccessControl, is_controlling_client=anybody)
    ),
    core_fault("events are numbered by twos", f"{FREE}/EventOccurred/rival/an-event-is-due", skipping()),
    core_fault(
        "answers come from another component",
        f"{FREE}/QueryTime/rival/all-fields",
        works(repacked(elsewhere(9, core.ReportTime))),
    ),
    core_fault("the winner is told instead of the loser", f"{READY}/RequestControl/rival/more-authority", to_winner()),
    core_fault(
        "control ends earlier than the timeout says",
        f"{READY}/Timedout/pilot/the-client-is-silent",
        field(core.ReportTimeout, timeout=10),
    ),
    core_fault(
        "control ends later than the timeout says",
        f"{READY}/Timedout/pilot/the-client-is-silent",
        field(core.ReportTimeout, timeout=2),
    ),
    core_fault(
        "the end of a command is not told", f"{FREE}/CreateCommandEvent/rival/a-new-one", without(core.CommandEvent)
    ),
    core_fault(
        "an ignored command has succeeded",
        f"{FREE}/CreateCommandEvent/rival/a-new-one",
        field(core.CommandEvent, command_result=core.CommandEvent.CommandResult.SUCCESSFUL),
    ),
    core_fault(
        "presence bits are mixed up",
        f"{FREE}/QueryLocalPose/rival/some-fields",
        swapped_bits(mobility.QueryLocalPose),
        profile="mobility-1.1",
    ),
    core_fault(
        "efforts and poses are taken from anybody",
        f"{READY}/SetWrenchEffort/rival {READY}/SetLocalPose/rival",
        patched(AccessControl, is_controlling_client=anybody),
        profile="mobility-1.1",
    ),
    core_fault(
        "efforts are taken and not used",
        f"{READY}/SetWrenchEffort/pilot",
        deaf_to(mobility.SetWrenchEffort),
        profile="mobility-1.1",
    ),
    core_fault(
        "efforts have the wrong byte order",
        f"{READY}/SetWrenchEffort/pilot",
        big_endian(mobility.ReportWrenchEffort, 4),
        profile="mobility-1.1",
    ),
)
