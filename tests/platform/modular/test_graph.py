"""Chains from what is attached to what."""

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

import pytest

pytest.importorskip("pinocchio", reason="needs the extra 'cell' and libgomp1", exc_type=ImportError)

from tests.helpers.servo_plant import FIVE, cell_of, many

from jauspy.geometry.poses import IDENTITY, Transform
from jauspy.platform.modular.graph import ArmChain, Attachment, Body, find_chain

CELL = cell_of((*FIVE, ("servo_6", "roll"), ("servo_7", "roll"), ("wheel_1", "wheel"), ("bracket_2", "bracket")))
CONNECTOR = {"bracket": "end", "tube": "end", "servo": "output", "platform": "top"}
ARM = tuple(name for name, _ in FIVE)


def connector(part: str) -> str:
    return f"{part}/{CONNECTOR[part.rpartition('_')[0]]}"


def stack(*names: str) -> list[Attachment]:
    """Each part is on the one before it."""
    return [Attachment(connector(lower), upper, IDENTITY) for lower, upper in pairwise(names)]


def chain_of(attached: Sequence[Attachment], previous: str = "") -> ArmChain:
    return find_chain(CELL, attached, previous)


def test_finds_no_arm_without_attachments() -> None:
    assert chain_of([]) == ArmChain()


def test_finds_no_arm_without_a_base() -> None:
    assert chain_of(stack(*ARM)) == ArmChain()


def test_finds_an_arm_without_joints() -> None:
    chain = chain_of(stack("platform_1", "bracket_1"))
    assert (chain.base, chain.joints, chain.tip) == ("platform_1/top", (), "bracket_1/end")


def test_finds_the_arm_of_five_joints() -> None:
    chain = chain_of(stack("platform_1", *ARM))
    assert chain.base == "platform_1/top"
    assert chain.ground == "platform_1"
    assert chain.joints == ("servo_1", "servo_2", "servo_3", "servo_4", "servo_5")
    assert chain.parts == ARM
    assert chain.tip == "servo_5/output"
    assert chain.held_by == ()


@pytest.mark.parametrize("count", range(10))
def test_finds_any_number_of_joints(count: int) -> None:
    names = [name for name, _ in many(count)]
    cell = cell_of(many(count))
    chain = find_chain(cell, stack("platform_1", *names))
    assert chain.joints == tuple(names)


def test_the_order_of_reports_does_not_matter() -> None:
    attached = stack("platform_1", *ARM)
    assert chain_of(attached[::-1]) == chain_of(attached)


def test_a_box_is_a_load_and_no_part_of_the_arm() -> None:
    chain = chain_of([*stack("platform_1", *ARM), Attachment("servo_5/output", "box_1", IDENTITY)])
    assert chain.tip == "servo_5/output"
    assert chain.parts == ARM
    assert chain.load_at_tip == "box_1"


def test_an_arm_that_holds_two_bases_keeps_the_one_that_carried_it() -> None:
    attached = [*stack("platform_1", *ARM), Attachment("servo_5/output", "platform_2", IDENTITY)]
    assert chain_of(attached).base == "platform_1/top"
    assert chain_of(attached).held_by == ("servo_5/output",)
    assert chain_of(attached, "platform_1/top").tip == "servo_5/output"
    assert chain_of(attached, "servo_5/output").base == "servo_5/output"
    assert chain_of(attached, "servo_5/output").held_by == ("platform_1/top",)


def test_an_arm_that_has_stepped_over_is_reversed() -> None:
    chain = chain_of([*stack(*ARM), Attachment("servo_5/output", "platform_2", IDENTITY)])
    assert chain.base == "servo_5/output"
    assert chain.ground == "platform_2"
    assert chain.joints == ("servo_5", "servo_4", "servo_3", "servo_2", "servo_1")
    assert chain.parts == ARM[::-1]
    assert chain.tip == ""
    assert chain.tip_body == Body("servo_1")
    assert all(link.reversed for link in chain.links if link.joint)


def test_the_mount_of_a_reversed_arm_is_the_inverse_of_its_grip() -> None:
    offset = Transform(position=(0.001, 0.002, 0.0))
    chain = chain_of([*stack(*ARM), Attachment("servo_5/output", "platform_2", offset)])
    frame = CELL.type_of("servo_5").connectors["output"]
    assert (chain.mount @ frame @ offset).position == pytest.approx((0.0, 0.0, 0.0), abs=1e-12)


def test_the_gripper_holds_the_arm() -> None:
    attached = [*stack("platform_1", "servo_1", "bracket_1"), Attachment("gripper", "bracket_1", IDENTITY)]
    chain = chain_of(attached)
    assert chain.joints == ("servo_1",)
    assert chain.held_by == ("gripper",)


def test_what_only_the_gripper_holds_is_no_arm() -> None:
    assert chain_of([*stack("servo_1", "bracket_1"), Attachment("gripper", "servo_1", IDENTITY)]) == ArmChain()


def test_the_longest_chain_is_the_arm() -> None:
    attached = [*stack("platform_1", "servo_1"), *stack("platform_2", "servo_6", "bracket_1", "servo_7")]
    assert chain_of(attached).joints == ("servo_6", "servo_7")
    assert chain_of(attached[:2]).joints == ("servo_1",)


def test_wheels_are_no_arm() -> None:
    attached = [*stack("platform_1", "servo_6", "servo_7"), Attachment("servo_7/output", "wheel_1", IDENTITY)]
    assert chain_of(attached) == ArmChain()
    assert chain_of([*attached, *stack("platform_2", "servo_1")]).joints == ("servo_1",)


def test_unknown_parts_and_connectors_are_ignored() -> None:
    strange = [Attachment("servo_1/nose", "servo_6", IDENTITY), Attachment("servo_1/output", "ghost", IDENTITY)]
    assert chain_of([*stack("platform_1", "servo_1"), *strange]).joints == ("servo_1",)


def test_a_loop_of_attachments_ends() -> None:
    loop = [*stack("platform_1", "servo_1", "servo_6"), Attachment("servo_6/output", "servo_1", IDENTITY)]
    assert chain_of(loop).base == "platform_1/top"


def test_two_arms_on_one_base_are_two_chains_and_each_keeps_its_connection() -> None:
    base = CELL.type_of("platform_1")
    pair = replace(base, connectors={"left": IDENTITY, "right": IDENTITY})
    cell = replace(CELL, types={**CELL.types, base.name: pair})
    left = [Attachment("platform_1/left", "servo_6", IDENTITY)]
    right = [Attachment("platform_1/right", "servo_1", IDENTITY), *stack("servo_1", "bracket_1", "servo_2")]
    first = find_chain(cell, left, keeps=True)
    assert (first.base, first.ground, first.joints) == ("platform_1/left", "platform_1", ("servo_6",))
    both = [*left, *right]
    assert find_chain(cell, both, first.base).joints == ("servo_1", "servo_2"), "alone, the arm is the longest chain"
    assert find_chain(cell, both, first.base, keeps=True) == first
    second = find_chain(cell, both, "", first.base, keeps=True)
    assert (second.base, second.joints) == ("platform_1/right", ("servo_1", "servo_2"))
    assert find_chain(cell, both, first.base, second.base, keeps=True) == first
    assert find_chain(cell, right, first.base, second.base, keeps=True) == ArmChain(), "it does not take the other's"
