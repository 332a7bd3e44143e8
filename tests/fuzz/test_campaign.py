"""A short campaign over all messages, its seeds and its mutations."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

from jauspy.codec.message import Message
from jauspy.codec.scalars import SIZES
from jauspy.errors import ConfigError, DecodeError
from jauspy.fuzz.campaign import CampaignPlan, fuzzer, run
from jauspy.fuzz.checks import difference
from jauspy.fuzz.findings import minimise
from jauspy.fuzz.messages import MessageMaker, Style
from jauspy.fuzz.mutation import MAX_INPUT_SIZE, file_payloads, mutate, offsets_of
from jauspy.messages import registry

CAPTURE = Path(__file__).parents[1] / "golden" / "sae_management.hex"


@pytest.mark.slow
@pytest.mark.parametrize("cases", [400, pytest.param(4000, marks=pytest.mark.slow)])
def test_campaign_has_no_findings(cases: int) -> None:
    outcome = run(CampaignPlan(cases, seed=1, payloads=tuple(file_payloads(CAPTURE))))
    assert outcome.findings == {}
    assert outcome.cases == cases
    assert 0.5 < outcome.accepted / cases < 0.95  # half are valid by construction, some stay valid when damaged
    assert outcome.messages == len(registry)


@pytest.mark.slow
def test_several_processes_give_the_same_result() -> None:
    names = ("ReportServices", "CreateEvent", "ReportVelocityState")
    alone = run(CampaignPlan(1000, seed=3, only=names))
    assert run(CampaignPlan(1000, seed=3, only=names, jobs=2)) == alone


def test_cases_depend_on_seed_and_number_only() -> None:
    first, again, other = (
        fuzzer(CampaignPlan(0, seed=seed, only=("ReportServices", "CreateEvent"))) for seed in (5, 5, 6)
    )
    assert [first.case(n) for n in range(200)] == [again.case(n) for n in range(200)]
    assert [first.case(n) for n in range(200)] != [other.case(n) for n in range(200)]


FINER_THAN_FLOATS = {"ReportCommunicatorCapability"}
"""Messages with real numbers in eight bytes, of which several raw values are the same float."""


@pytest.mark.slow
def test_generated_messages_are_valid_and_cover_all_items() -> None:
    targets = fuzzer(CampaignPlan(0)).targets
    rng = random.Random(1)
    for target in targets:
        made = [MessageMaker(rng, style, targets).message(target) for style in (*Style, Style.ANY)]
        for data in made:
            message = target.cls.decode(data)
            again = message.encode()
            assert target.cls.decode(again) == message
            assert len(again) == len(data)
            assert again == data or target.cls.NAME in FINER_THAN_FLOATS
        assert len(made[0]) == min(map(len, made)) >= 2 + target.layout.minimum
        full = target.cls.decode(made[1])
        absent = [slot for slot in target.layout.slots if getattr(full, slot.name) is None]
        optional = sum(slot.optional for slot in target.layout.slots)
        assert len(absent) == max(0, optional - 8 * SIZES[target.layout.presence or "Q"])


def test_offsets_locate_counts_and_tags() -> None:
    services = registry.by_name("RegisterServices")
    data = bytes.fromhex("000b02" + "01410102" + "0203040506")
    offsets = [offset for offset in offsets_of(services.layout(), data) if offset.kind == "count"]
    assert [(offset.at, offset.cuts) for offset in offsets] == [(2, (3, 7, 12)), (3, (4, 5)), (7, (8, 10))]
    assert offsets_of(services.layout(), data[:5])[0].at == 2


@pytest.mark.slow
def test_all_kinds_of_mutations_occur() -> None:
    made = fuzzer(CampaignPlan(0))
    rng = random.Random(1)
    sizes = set()
    changed = 0
    for number in range(4000):
        seed = made.seeds[number % len(made.seeds)]
        data = mutate(rng, seed, made.seeds)
        assert data[:2] == seed.data[:2]
        assert len(data) <= MAX_INPUT_SIZE
        sizes.add((len(data) > len(seed.data)) - (len(data) < len(seed.data)))
        changed += data != seed.data
    assert sizes == {-1, 0, 1}
    assert changed > 3000


def test_minimise_keeps_the_relevant_byte() -> None:
    tried = []

    def shows(data: bytes) -> bool:
        tried.append(data)
        return b"\x07" in data[2:]

    assert minimise(b"\1\2" + bytes(range(100, 200)) + b"\x07" + bytes(50), shows) == b"\1\2\x07"
    assert minimise(b"\1\2" + bytes(range(200)), shows, tries=3) != b"\1\2\x07"
    assert len(tried) < 200


def test_minimise_adjusts_counts_and_presence_vectors() -> None:
    services = registry.by_name("RegisterServices")
    data = bytes.fromhex("000b03" + "0341424301020441424344010200" + "0709")
    assert services.decode(data)
    assert (
        minimise(data, lambda part: valid(services, part) and b"\7\t" in part, services.layout()).hex()
        == "000b01000709"
    )
    state = registry.by_name("ReportVelocityState")
    data = bytes.fromhex("0444ff01" + "78563412" * 4 + "3412" * 4 + "e7effbfd")
    smallest = minimise(
        data, lambda part: valid(state, part) and state.decode(part).yaw_rate is not None, state.layout()
    )  # type: ignore[attr-defined]
    assert smallest.hex() == "044440000000"


def valid(cls: type[Message], data: bytes) -> bool:
    try:
        cls.decode(data)
    except DecodeError:
        return False
    return True


def test_seeds_come_from_captures(shared: Path) -> None:
    hexed = file_payloads(CAPTURE)
    captured = file_payloads(shared / "captures" / "sae_management.pcap")
    assert set(hexed) == set(captured)
    assert b"\x02\x20" in captured


@pytest.mark.parametrize("content", [b"", b"# nothing", b"00"])
def test_files_without_messages(content: bytes, tmp_path: Path) -> None:
    (tmp_path / "file").write_bytes(content)
    assert file_payloads(tmp_path / "file") == []


@pytest.mark.parametrize("content", [b"zz", b"\xff\xfe", b"\xd4\xc3\xb2\xa1"])
def test_other_files_are_rejected_as_seeds(content: bytes, tmp_path: Path) -> None:
    (tmp_path / "file").write_bytes(content)
    with pytest.raises(ConfigError, match="file"):
        file_payloads(tmp_path / "file")


def test_rounding_is_tolerated_but_a_wrong_step_is_not() -> None:
    """Two ways to compute a scaled value differ by a few steps of a float of the size of its limits."""
    cls = registry.by_name("SetLocalOperatingZone", version="1.1")
    data = bytes.fromhex("2704010000d4fe7f0000000000")
    message = cls.decode(data)
    said = message.to_dict()
    assert difference(cls.layout(), message, said) is None
    said["local_operating_zone"][0]["x"] += 4e7 / (2**32 - 1)
    assert difference(cls.layout(), message, said) == "local_operating_zone.x"
