"""Commands with the seal of an operator: what a component takes, what it refuses, and who may command what."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import pytest
from hypothesis import assume, given, strategies as st
from tests.services.conftest import Rig

from jauspy.codec.message import Message
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import (
    ClearEmergency,
    CommandEvent,
    ConfirmControl,
    ConfirmEventRequest,
    CreateCommandEvent,
    CreateEvent,
    QueryControl,
    QueryStatus,
    ReleaseControl,
    ReportControl,
    RequestControl,
    Resume,
    SetAuthority,
    SetEmergency,
    SetTime,
    Shutdown,
    Standby,
)
from jauspy.messages.mobility import QueryWrenchEffort, SetWrenchEffort
from jauspy.messages.operators import QuerySealChallenge, RejectCommand, ReportSealChallenge, SealedCommand
from jauspy.protocol.duplicates import REPLAY_WINDOW
from jauspy.protocol.seal import Operator, OperatorKey, PublicKey
from jauspy.schema import load_builtin
from jauspy.services.core import AccessControl, CommandSeal, Management, Time
from jauspy.services.core.command_seal import (
    CHALLENGE_LIFETIME,
    MAX_AGE,
    MAX_CLIENTS_OF_OPERATOR,
    MAX_REJECTS,
    CommandRecord,
    needs_seal,
)
from jauspy.services.core.management import MAX_EMERGENCY_CLIENTS
from jauspy.services.mobility import PrimitiveDriver, Vehicle

pytest.importorskip("cryptography", reason="keys of operators need the extra 'operators'")

OCU, OTHER = "42.1.1", "43.1.1"
KEYS = {name: OperatorKey.generate() for name in ("alice", "carol", "oscar", "mallory")}
OPERATORS = [
    Operator("alice", "operator", 127, KEYS["alice"].public),
    Operator("carol", "supervisor", 255, KEYS["carol"].public),
    Operator("oscar", "observer", 0, KEYS["oscar"].public),
]
READY, STANDBY, EMERGENCY = "READY", "STANDBY", "EMERGENCY"
EFFORT = SetWrenchEffort(propulsive_linear_effort_x=40.0)
Reason = RejectCommand.Reason


class Client:
    """Seals as an OCU does: one challenge, counters from 1."""

    def __init__(self, rig: Rig, operator: str = "alice", id: str = OCU) -> None:
        self.rig, self.key, self.id = rig, KEYS[operator], id
        self.counter = 0
        self.renew()

    def renew(self) -> None:
        answer = self.rig.ask(self.id, QuerySealChallenge())
        assert isinstance(answer, ReportSealChallenge)
        self.challenge, self.since, self.counter = answer, self.rig.now, 0

    def seal(self, command: Message, *, destination: JausID = Rig.ID, source: str | None = None) -> SealedCommand:
        self.counter += 1
        return self.key.seal(
            command,
            self.challenge,
            destination=destination,
            source=JausID.parse(source or self.id),
            elapsed=self.rig.now - self.since,
            counter=self.counter,
        )

    def tell(self, command: Message) -> list[Message]:
        """Send sealed; what comes back to this client."""
        return [message for to, message in self.rig.tell(self.id, self.seal(command)) if to == self.id]


@pytest.fixture
def log() -> list[CommandRecord]:
    return []


@pytest.fixture
def make(drive, log) -> Callable[..., Rig]:
    def made(*, required: bool = True, secret: bytes = b"s" * 32) -> Rig:
        seal = CommandSeal(OPERATORS, secret=secret, required=required, audit=log.append)
        return Rig(AccessControl(), Management(), Time(), PrimitiveDriver(Vehicle(drive)), seal)

    return made


@pytest.fixture
def rig(make) -> Rig:
    return make()


def status(rig: Rig) -> str:
    assert rig.host.status is not None
    return rig.host.status.name


def in_control(rig: Rig, operator: str = "alice", authority: int = 100) -> Client:
    """A client of this operator that is in control and has resumed the component."""
    client = Client(rig, operator)
    assert client.tell(RequestControl(authority_code=authority)) == [ConfirmControl(response_code=0)]
    client.tell(Resume())
    assert status(rig) == READY
    return client


def reasons(answers: list[Message] | list[tuple[str, Message]]) -> list[Reason]:
    messages = [each[1] if isinstance(each, tuple) else each for each in answers]
    return [Reason(each.reason) for each in messages if isinstance(each, RejectCommand)]


def counts(rig: Rig, name: str) -> int:
    return rig.host.counters[name]


# --- what is taken ----------------------------------------------------------------------------------------------------


def test_sealed_commands_act(rig, drive):
    client = in_control(rig)
    client.tell(EFFORT)
    assert rig.ask(OTHER, QueryWrenchEffort(0xFFFF)).propulsive_linear_effort_x == pytest.approx(40.0, abs=0.1)


def test_queries_and_subscriptions_need_no_seal(rig):
    assert rig.ask(OTHER, QueryStatus()).status.name == STANDBY
    (to, answer), *_ = rig.tell(OTHER, CreateEvent(1, 1, 0.0, QueryStatus()))
    assert (to, type(answer)) == (OTHER, ConfirmEventRequest)


def test_command_events_are_sealed_as_a_whole(rig):
    client = in_control(rig)
    confirmed, ended = client.tell(CreateCommandEvent(1, 1, Standby()))
    assert (type(confirmed), ended.command_result) == (ConfirmEventRequest, CommandEvent.CommandResult.SUCCESSFUL)
    assert status(rig) == STANDBY
    assert reasons(rig.tell(OCU, CreateCommandEvent(2, 1, Resume()))) == [Reason.NO_SEAL]


def test_commands_may_overtake_each_other_within_the_window(rig):
    client = in_control(rig)
    sealed = [client.seal(EFFORT) for _ in range(REPLAY_WINDOW + 1)]
    assert not reasons(rig.tell(OCU, sealed[-1]))
    assert not reasons(rig.tell(OCU, sealed[1]))
    assert reasons(rig.tell(OCU, sealed[0])) == [Reason.REPLAYED]


def test_without_require_operator_commands_need_no_seal_but_wrong_seals_are_refused(make):
    rig = make(required=False)
    rig.tell(OTHER, RequestControl(authority_code=50))
    rig.tell(OTHER, Resume())
    assert status(rig) == READY
    assert reasons(Client(rig, "mallory").tell(RequestControl(authority_code=200))) == [Reason.UNKNOWN_OPERATOR]


def test_whatever_needs_control_needs_a_seal():
    """In every definition; except for an answer that a component has asked for."""
    guarded = set()
    for service in (each for each in load_builtin().services if each.behavior):
        waiting = [state for machine in service.behavior.machines for state in machine.states]
        for state in waiting:
            waiting += state.states
            for transition in (*state.transitions, *state.default_transitions):
                if "sControllingClient" in transition.guard:
                    guarded |= {each.type for each in transition.parameters[:1]}
    codes = {entry.code for entry in registry.entries if entry.name in guarded}
    kinds = [each for code in codes for each in registry.by_code(code) if each.NAME in guarded]
    assert len(kinds) > 100
    assert {each.NAME for each in kinds if not needs_seal(each)} == {"ConfirmReleaseControl"}


# --- what is refused --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "command", [RequestControl(authority_code=200), Resume(), SetTime(), EFFORT, ClearEmergency(1), Shutdown()]
)
def test_commands_without_a_seal_are_refused(rig, caplog, command):
    assert reasons(rig.tell(OCU, command)) == [Reason.NO_SEAL]
    assert (counts(rig, "refused.no_seal"), rig.host.controller) == (1, None)
    assert "it has no seal" in caplog.text


def test_an_id_is_not_enough_to_command_what_an_operator_controls(rig):
    in_control(rig)
    assert reasons(rig.tell(OCU, EFFORT)) == [Reason.NO_SEAL]
    assert reasons(rig.tell(OCU, ReleaseControl())) == [Reason.NO_SEAL]
    assert str(rig.host.controller) == OCU


def test_a_key_that_is_not_known(rig):
    assert reasons(Client(rig, "mallory").tell(Resume())) == [Reason.UNKNOWN_OPERATOR]


def test_a_signature_of_another_key(rig):
    client = Client(rig, "mallory")
    forged = client.seal(RequestControl(authority_code=200))
    assert reasons(rig.tell(OCU, replace(forged, operator_key=KEYS["carol"].public.id))) == [Reason.FORGED]


def test_a_command_cannot_be_changed(rig):
    sealed = Client(rig).seal(RequestControl(authority_code=1))
    changed = replace(sealed, command=RequestControl(authority_code=120))
    assert reasons(rig.tell(OCU, changed)) == [Reason.FORGED]
    assert not reasons(rig.tell(OCU, sealed))


def test_replays(rig):
    client = in_control(rig)
    sealed = client.seal(EFFORT)
    assert not reasons(rig.tell(OCU, sealed))
    assert reasons(rig.tell(OCU, sealed)) == [Reason.REPLAYED]
    rig.now += MAX_AGE * 2
    assert reasons(rig.tell(OCU, sealed)) == [Reason.STALE]


def test_for_another_component(rig):
    sealed = Client(rig).seal(Resume(), destination=JausID(101, 1, 2))
    assert reasons(rig.tell(OCU, sealed)) == [Reason.OTHER_DESTINATION]


def test_from_another_component(rig):
    assert reasons(rig.tell(OTHER, Client(rig).seal(Resume()))) == [Reason.OTHER_SOURCE]


def test_a_challenge_is_for_one_client(rig):
    client = Client(rig)
    assert reasons(rig.tell(OTHER, client.seal(Resume(), source=OTHER))) == [Reason.UNKNOWN_CHALLENGE]


def test_a_command_that_was_held_back(rig):
    client = in_control(rig)
    sealed = client.seal(EFFORT)
    rig.now += MAX_AGE + 0.1
    assert reasons(rig.tell(OCU, sealed)) == [Reason.STALE]
    assert not reasons(client.tell(EFFORT))


@pytest.mark.parametrize("gained", [-3.0, 3.0])
def test_a_client_whose_clock_runs_wrong(rig, gained):
    client = Client(rig)
    rig.now += 100.0
    client.since -= gained
    assert reasons(client.tell(Resume())) == [Reason.STALE]
    client.renew()
    assert not reasons(client.tell(RequestControl(authority_code=1)))


def test_a_challenge_ends(rig):
    client = Client(rig)
    rig.now += CHALLENGE_LIFETIME + 1
    assert reasons(client.tell(Resume())) == [Reason.UNKNOWN_CHALLENGE]


def test_restart_of_the_robot(make):
    """What was sealed before is refused, however soon the component is back."""
    before, after = make(secret=b"1" * 32), make(secret=b"2" * 32)
    client = Client(before)
    sealed = client.seal(RequestControl(authority_code=100))
    assert reasons(after.tell(OCU, sealed)) == [Reason.UNKNOWN_CHALLENGE]
    client.rig = after
    client.renew()
    assert not reasons(client.tell(RequestControl(authority_code=100)))


def test_restart_of_the_ocu(rig):
    """The next program of the same id gets another challenge, at the same moment, and starts to count again."""
    first, second = Client(rig), Client(rig)
    sealed = first.seal(RequestControl(authority_code=100))
    assert not reasons(rig.tell(OCU, sealed))
    assert not reasons(second.tell(Resume()))
    assert reasons(rig.tell(OCU, sealed)) == [Reason.REPLAYED]


def test_counters_are_forgotten_only_when_nothing_can_be_replayed(rig):
    """An operator has a share of the table, which others do not feel."""
    clients = [Client(rig, id=f"42.1.{number}") for number in range(1, MAX_CLIENTS_OF_OPERATOR + 2)]
    answers = [reasons(client.tell(SetTime())) for client in clients]
    assert answers == [[]] * MAX_CLIENTS_OF_OPERATOR + [[Reason.TOO_MANY_CLIENTS]]
    assert not reasons(Client(rig, "carol").tell(SetTime()))
    rig.now += MAX_AGE * 2
    assert not reasons(clients[-1].tell(SetTime()))


def test_a_seal_within_a_seal(rig):
    client = Client(rig)
    assert reasons(client.tell(client.seal(Resume()))) == [Reason.NOT_A_COMMAND]


def test_replies_to_refused_commands_are_limited(rig):
    answers = [each for _ in range(100) for each in rig.tell(OTHER, Resume())]
    assert len(answers) == MAX_REJECTS
    assert counts(rig, "refused.no_seal") == 100


# --- stops ------------------------------------------------------------------------------------------------------------


def test_stops_need_no_seal(rig):
    in_control(rig)
    assert rig.tell(OCU, Standby()) == []
    assert (status(rig), counts(rig, "stop_without_seal")) == (STANDBY, 1)
    rig.tell(OTHER, SetEmergency(emergency_code=1))
    assert status(rig) == EMERGENCY


def test_standby_remains_with_the_id_in_control(rig):
    in_control(rig)
    rig.tell(OTHER, Standby())
    assert status(rig) == READY


def test_stops_with_a_wrong_seal_are_stops(rig):
    client = in_control(rig)
    client.since -= 100.0
    assert client.tell(Standby()) == []
    assert status(rig) == STANDBY


def test_a_stop_as_a_command_event(rig):
    in_control(rig)
    assert not reasons(rig.tell(OCU, CreateCommandEvent(1, 1, Standby())))
    assert status(rig) == STANDBY


def test_an_operator_clears_the_emergencies_of_more_clients_than_are_remembered(rig):
    for number in range(1, MAX_EMERGENCY_CLIENTS + 2):
        rig.tell(f"66.{1 + number // 250}.{1 + number % 250}", SetEmergency(emergency_code=1))
    carol = Client(rig, "carol", OTHER)
    carol.tell(SetEmergency(emergency_code=1))
    Client(rig, "alice").tell(ClearEmergency(emergency_code=1))
    assert status(rig) == EMERGENCY
    carol.tell(ClearEmergency(emergency_code=1))
    assert status(rig) == STANDBY


def test_an_emergency_that_was_set_without_a_seal_is_cleared_by_an_operator(rig):
    rig.tell(OTHER, SetEmergency(emergency_code=1))
    assert reasons(rig.tell(OTHER, ClearEmergency(emergency_code=1))) == [Reason.NO_SEAL]
    Client(rig, "alice").tell(ClearEmergency(emergency_code=1))
    assert status(rig) == STANDBY


def test_an_emergency_of_an_operator_is_cleared_by_its_own_client_only(rig):
    setter = Client(rig, "carol", OTHER)
    setter.tell(SetEmergency(emergency_code=1))
    Client(rig, "alice").tell(ClearEmergency(emergency_code=1))
    assert status(rig) == EMERGENCY
    setter.tell(ClearEmergency(emergency_code=1))
    assert status(rig) == STANDBY


# --- roles ------------------------------------------------------------------------------------------------------------


def test_authority_is_capped_by_the_role(rig):
    in_control(rig, "alice", authority=200)
    assert rig.ask(OTHER, QueryControl()).authority_code == 127
    carol = Client(rig, "carol", OTHER)
    assert carol.tell(RequestControl(authority_code=200)) == [ConfirmControl(response_code=0)]
    assert rig.ask(OCU, QueryControl()) == ReportControl(43, 1, 1, 200)


def test_two_of_one_role_do_not_take_control_from_each_other(rig):
    in_control(rig, "alice", authority=127)
    other = Client(rig, "alice", OTHER)
    refused = ConfirmControl(response_code=ConfirmControl.ResponseCode.INSUFFICIENT_AUTHORITY)
    assert other.tell(RequestControl(authority_code=255)) == [refused]


def test_authority_cannot_be_raised_afterwards(rig):
    client = in_control(rig, "alice", authority=50)
    client.tell(SetAuthority(authority_code=255))
    assert rig.ask(OTHER, QueryControl()).authority_code == 50


def test_an_observer_commands_nothing(rig):
    client = Client(rig, "oscar")
    assert reasons(client.tell(RequestControl(authority_code=1))) == [Reason.ROLE_TOO_LOW]
    assert reasons(client.tell(SetTime())) == [Reason.ROLE_TOO_LOW]
    client.tell(SetEmergency(emergency_code=1))
    assert status(rig) == EMERGENCY


def test_control_is_of_the_operator_not_of_the_id(rig, drive):
    """A second operator under the same id does not command with the control of the first, but may take it over."""
    in_control(rig, "alice")
    second = Client(rig, "carol")
    second.tell(EFFORT)
    assert rig.ask(OTHER, QueryWrenchEffort(0xFFFF)).propulsive_linear_effort_x == pytest.approx(0.0, abs=0.1)
    assert ConfirmControl(response_code=0) in second.tell(RequestControl(authority_code=200))
    assert rig.ask(OTHER, QueryControl()).authority_code == 200


# --- records, bytes ---------------------------------------------------------------------------------------------------


def test_what_is_recorded(rig, log):
    client = in_control(rig)
    rig.tell(OCU, QueryStatus())
    rig.tell(OTHER, Resume())
    rig.tell(OTHER, SetEmergency(emergency_code=1))
    Client(rig, "oscar", OTHER).tell(Shutdown())
    client.tell(Resume())
    assert [(each.operator.name if each.operator else None, each.message, each.outcome) for each in log] == [
        ("alice", "RequestControl", "taken"),
        ("alice", "Resume", "taken"),
        (None, "Resume", "refused: NO_SEAL"),
        (None, "SetEmergency", "taken"),
        ("oscar", "Shutdown", "refused: ROLE_TOO_LOW"),
        ("alice", "Resume", "ignored"),
    ]


TARGET = Rig(AccessControl(), Management(), CommandSeal(OPERATORS, secret=bytes(16)))


@given(st.integers(0, 2**31), st.binary(max_size=40), st.booleans())
def test_damaged_seals_never_raise_and_never_act(position, noise, cut):
    payload = Client(TARGET).seal(RequestControl(authority_code=100)).encode()
    at = 2 + position % (len(payload) - 2)
    damaged = payload[:at] + noise + (b"" if cut else payload[at + len(noise) :])
    assume(damaged != payload)
    TARGET.tell(OCU, damaged)
    assert TARGET.host.controller is None


@given(st.binary(max_size=200))
def test_any_bytes_for_a_seal_never_raise(noise):
    TARGET.tell(OCU, SealedCommand.CODE.to_bytes(2, "little") + noise)
    assert TARGET.host.controller is None


def test_keys_are_read_and_written():
    key = KEYS["alice"]
    assert OperatorKey.from_pem(key.pem()).public.raw == key.public.raw
    assert PublicKey.parse(str(key.public)).id == key.public.id
    for text in ("ed25519:", "ed25519:AAAA", "ed25519:***", "alice", ""):
        with pytest.raises(ConfigError, match="public key"):
            PublicKey.parse(text)
    for pem in (b"", b"no key", key.pem()[:60]):
        with pytest.raises(ConfigError, match="jauspy keys new"):
            OperatorKey.from_pem(pem)


def test_a_secret_that_can_be_guessed():
    with pytest.raises(ConfigError, match="16"):
        CommandSeal(OPERATORS, secret=b"short")
