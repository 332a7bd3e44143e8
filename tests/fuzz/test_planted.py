"""The fuzzer finds bugs that are planted: it names, minimises, saves and replays them, and forgets them when fixed."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from typer.testing import CliRunner

from jauspy.cli.main import app
from jauspy.codec.message import Message
from jauspy.errors import DecodeError
from jauspy.fuzz import checks
from jauspy.fuzz.campaign import CampaignPlan, fuzzer
from jauspy.fuzz.findings import FuzzFinding, load_finding
from jauspy.messages.core import RegisterServices

EMPTY = "000b00"
ONE = "000b01" + "00" * 3


def wrong_exception(right: Any, data: bytes) -> Any:
    if len(data) > 6:
        raise ZeroDivisionError("planted")
    return right(data, None)


def wrong_value(right: Any, data: bytes) -> Any:
    message = right(data, None)
    for service in message.service_list:
        service.minor_version_number &= 0x7F
    return message


def drops_a_service(right: Any, data: bytes) -> Any:
    message = right(data, None)
    if len(message.service_list) > 2:
        message.service_list.pop()
    return message


def hungry(right: Any, data: bytes) -> Any:
    waste = bytes(data[2] * 2_000_000)
    return right(data, len(waste) * 0)


def unstable(right: Any, data: bytes) -> Any:
    message = right(data, None)
    for service in message.service_list:
        service.uri = service.uri.replace("\xff", "?")
    return message


@pytest.mark.slow
@pytest.mark.parametrize(
    ("bug", "cause", "largest"),
    [
        (wrong_exception, "decode RegisterServices 1.1 ZeroDivisionError", 7),
        (wrong_value, "tolerant RegisterServices 1.1 values", 6),
        pytest.param(drops_a_service, "tolerant RegisterServices 1.1 values", 12, marks=pytest.mark.slow),
        (hungry, "memory RegisterServices 1.1", 6),
        pytest.param(unstable, "tolerant RegisterServices 1.1 values", 7, marks=pytest.mark.slow),
    ],
)
def test_planted_fault_is_found_minimised_and_replayed(  # noqa: PLR0917 - parameters and fixtures
    bug: Any, cause: str, largest: int, plant: Any, hunt: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plant(bug)
    found: list[FuzzFinding] = hunt()
    (finding,) = [one for one in found if one.cause == cause]
    assert len(finding.data) <= largest, finding.hex
    assert finding.seen
    assert hunt() == found  # the same seed gives the same
    path = finding.save(tmp_path)
    assert load_finding(path) == finding
    result = CliRunner().invoke(app, ["fuzz", "replay", str(path)])
    assert result.exit_code == 1
    assert cause in result.output
    monkeypatch.undo()
    result = CliRunner().invoke(app, ["fuzz", "replay", str(path)])
    assert (result.exit_code, result.output) == (0, f"{cause}: not reproduced\n")


@pytest.mark.slow
@pytest.mark.long
def test_fault_in_both_paths_is_found_by_the_reference(hunt: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    layout: Any = RegisterServices.layout()
    item = layout.slots[0].item
    monkeypatch.setattr(RegisterServices, "_unpack", Message._unpack)
    monkeypatch.setattr(RegisterServices, "_pack", Message._pack)
    read = type(item).read
    monkeypatch.setattr(type(item), "read", lambda self, *rest: read(self, *rest)[:3])
    causes = {finding.cause for finding in hunt()}
    assert "agreement RegisterServices 1.1 service_list.length" in causes or any("stable" in one for one in causes)


def test_difference_of_the_reference_is_found(plant: Any, hunt: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    from jauspy.codec import reference

    right = reference.parse

    def picky(model: Any, data: bytes) -> Any:
        if len(data) > 9:
            raise DecodeError("planted")
        return right(model, data)

    monkeypatch.setattr(reference, "parse", picky)
    (finding,) = [one for one in hunt() if one.version == "1.1"]
    assert finding.cause == "agreement RegisterServices 1.1 verdict"
    assert len(finding.data) == 10


@pytest.mark.slow
def test_rejected_valid_message_is_found(hunt: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    from jauspy.codec.layout import Repeat

    read = Repeat.read

    def picky(self: Any, reader: Any, path: str) -> Any:
        values = read(self, reader, path)
        if len(values) > 3:
            reader.report("planted", path)
        return values

    monkeypatch.setattr(RegisterServices, "_unpack", Message._unpack)
    monkeypatch.setattr(Repeat, "read", picky)
    assert "valid RegisterServices 1.1 service_list" in {finding.cause for finding in hunt()}


class Clock:
    """Time that passes when told to."""

    def __init__(self) -> None:
        self.now = 0

    def __call__(self) -> int:
        self.now += 1000
        return self.now


def test_quadratic_time_is_found(plant: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    clock = Clock()
    monkeypatch.setattr(checks.time, "thread_time_ns", clock)

    def quadratic(right: Callable[[bytes, int], Any], data: bytes) -> Any:
        clock.now += 20 * len(data) ** 2
        return right(data, None)

    plant(quadratic)
    plan = CampaignPlan(0, only=("RegisterServices",))
    target = fuzzer(plan).targets[0]
    problem = fuzzer(plan).checks.problem(target, bytes.fromhex(ONE) + bytes(60000), memory=False)
    assert problem is not None
    assert problem.check == "time"
    assert fuzzer(plan).checks.problem(target, bytes.fromhex(ONE), memory=False) is None


def test_single_slow_run_is_no_finding(monkeypatch: pytest.MonkeyPatch) -> None:
    clock = Clock()
    monkeypatch.setattr(checks.time, "thread_time_ns", clock)
    measured = fuzzer(CampaignPlan(0, only=("RegisterServices",))).checks._cost
    assert measured.problem(600, 10.0 * measured.limit(600), lambda: None) is None


def test_endless_loop_is_found(plant: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(checks, "MAX_CPU_SECONDS", 0.05)

    def endless(right: Callable[[bytes, int], Any], data: bytes) -> Any:
        while data[2] == 2:
            pass
        return right(data, None)

    made = fuzzer(CampaignPlan(0, only=("RegisterServices",)))
    target = next(target for target in made.targets if target.cls is RegisterServices)
    plant(endless)
    assert made.checks.problem(target, bytes.fromhex(ONE), memory=False) is None
    problem = made.checks.problem(target, bytes.fromhex("000b02"), memory=False)
    assert problem is not None
    assert (problem.check, problem.seen) == ("time", "no end after 0.05 s of processor time")
