"""Why commands are ignored: each reason that a component's state tells, in one sentence."""

from __future__ import annotations

import asyncio

import pytest

from jauspy.messages.core import SetEmergency, Shutdown, Standby
from jauspy.messages.manipulator import JointEffortRec, JointPositionRec, SetJointEffort, SetJointPositions
from jauspy.messages.mobility import SetVelocityCommand, SetWrenchEffort
from jauspy.messages.ugv import SetSkidSteerEffort

DRIVER, ARM = "101.1.102", "101.1.104"
WRENCH = SetWrenchEffort(propulsive_linear_effort_x=40.0)


@pytest.fixture
async def inc1(robot, ocu):
    return await ocu.robot(101)


async def test_nobody_in_control(inc1, ocu):
    reason = await ocu.explain(DRIVER, WRENCH)
    assert reason == (f"{DRIVER} takes commands only from the client in control, which is nobody: take control first")


@pytest.mark.slow
async def test_other_client_in_control_is_named(inc1, ocu, virtual_network):
    async with virtual_network.ocu("42.1.7") as other, (await other.robot(101)).control("drive", authority=200):
        reason = await ocu.explain(DRIVER, WRENCH)
    assert "which is 42.1.7 with authority 200: take control first" in reason


@pytest.mark.slow
async def test_standby_and_emergency(inc1, ocu):
    async with inc1.control("drive"):
        assert await ocu.explain(DRIVER, WRENCH) == ""
        await ocu.send(DRIVER, Standby(), ack=True)
        assert await ocu.explain(DRIVER, WRENCH) == f"{DRIVER} is in Standby: resume first"
        await ocu.send(DRIVER, SetEmergency(SetEmergency.EmergencyCode.STOP), ack=True)
        assert "in Emergency: whoever set the emergency must clear it" in await ocu.explain(DRIVER, WRENCH)


async def test_shutdown_that_was_taken_needs_no_explanation(inc1, ocu):
    async with inc1.control("drive"):
        await ocu.send(DRIVER, Shutdown(), ack=True)
        assert await ocu.explain(DRIVER, Shutdown()) == ""
        assert await ocu.explain(DRIVER, WRENCH) == f"{DRIVER} is in Shutdown: start the component again"


async def test_service_that_is_not_offered(inc1, ocu):
    reason = await ocu.explain(ARM, WRENCH)
    assert reason.startswith(f"{ARM} does not offer SetWrenchEffort of mobility:PrimitiveDriver; it offers iop:")
    assert "core:" not in reason


@pytest.mark.slow
async def test_wrong_joints(inc1, ocu):
    make, choice = JointPositionRec.JointPosition, JointPositionRec.JointPositionChoice
    async with inc1.control("arm"):
        two = SetJointEffort([JointEffortRec(10.0), JointEffortRec(0.0)])
        assert "it has 5 joints, and the message has 2; give one value for each, base to tip" in await ocu.explain(
            ARM, two
        )
        metres = SetJointPositions([JointPositionRec(make(choice(2), 0.1)) for _ in range(5)])
        assert "joint 1 takes an angle, and the message has a distance" in await ocu.explain(ARM, metres)


async def test_velocity_out_of_range(inc1, ocu):
    async with inc1.control("drive"):
        fast = SetVelocityCommand(SetVelocityCommand.CommandType.SET_CURRENT_COMMAND, velocity_x=9.0)
        assert "velocity_x 9 m/s is outside -" in await ocu.explain(DRIVER, fast)
        slow = SetVelocityCommand(SetVelocityCommand.CommandType.SET_CURRENT_COMMAND, velocity_x=0.3)
        assert await ocu.explain(DRIVER, slow) == ""


async def test_component_that_does_not_answer(ocu):
    assert "does not answer queries and may not exist" in await ocu.explain("101.1.99", WRENCH)


@pytest.mark.slow
async def test_command_that_may_have_been_taken_needs_no_explanation(inc1, ocu):
    async with inc1.control("drive") as control:
        efforts = SetSkidSteerEffort(10.0, 10.0)
        assert await inc1.service("SkidSteerDriver").explain(efforts) == ""
        await asyncio.sleep(0.1)
        assert control.held
