from __future__ import annotations

import asyncio
import random

import pytest
from tests.helpers.sampling import sampled
from tests.ocu.conftest import ROBOT, hold_back

from jauspy.errors import ConfigError, ControlRejected, RequestError, ResponseTimeout
from jauspy.ids import JausID
from jauspy.messages.core import (
    CancelEvent,
    ClearEmergency,
    ConfirmControl,
    QueryControl,
    QueryStatus,
    RejectControl,
    ReleaseControl,
    ReportControl,
    ReportStatus,
    RequestControl,
    Resume,
    SetEmergency,
    Standby,
)
from jauspy.messages.mobility import SetWrenchEffort
from jauspy.ocu import control as module
from jauspy.services.core import AccessControl, Discovery, Events, Liveness, Management
from jauspy.testing import VirtualNetwork, until

Status = ReportStatus.Status
HOLDER = JausID(42, 1, 1)
FULL = SetWrenchEffort(propulsive_linear_effort_x=40.0)


async def driver_of(ocu):
    return (await ocu.discover(subsystem=101)).service("mobility:PrimitiveDriver")


async def test_control_is_taken_kept_and_released(world):
    robot = await world.robot()
    ocu = await world.ocu()
    driver = await driver_of(ocu)

    async with driver.control(authority=200) as control:
        assert control.held
        assert control.timeout == 5
        assert robot.host.controller == HOLDER
        await driver.resume()
        assert robot.host.status == Status.READY
        await driver.send(FULL)
        await until(lambda: world.drives[0].effort[0] == pytest.approx(0.4, abs=1e-3))
        await driver.standby()
        assert robot.host.status == Status.STANDBY

    assert robot.host.controller is None
    assert not control.held
    assert world.drives[0].effort == (0.0, 0.0)


async def test_exit_sends_standby_before_release(world):
    robot = await world.robot()
    driver = await driver_of(await world.ocu())

    async with driver.control():
        await driver.resume()
        await driver.send(FULL)

    assert (robot.host.controller, robot.host.status) == (None, Status.STANDBY)
    kinds = [each.payload[:2] for each in world.network.log if each.source == HOLDER]
    assert kinds.index(Standby.CODE.to_bytes(2, "little")) < kinds.index(ReleaseControl.CODE.to_bytes(2, "little"))


async def test_refusal_names_the_holder_and_authorities(world):
    await world.robot()
    first, second = await driver_of(await world.ocu()), await driver_of(await world.ocu("43.1.1"))

    async with first.control(authority=220):
        with pytest.raises(ControlRejected) as refusal:
            async with second.control(authority=200):
                pytest.fail("two clients in control")

    assert str(refusal.value) == "101.1.1 is held by 42.1.1 with authority 220; requested with 200"
    assert (refusal.value.holder, refusal.value.authority) == (HOLDER, 220)


async def test_insufficient_authority_error_names_the_minimum(world):
    await world.robot()
    driver = await driver_of(await world.ocu())
    with pytest.raises(
        ControlRejected, match=r"101\.1\.1 gives control to authority 1 and above; requested with"
    ) as refusal:
        async with driver.control(authority=0):
            pytest.fail("controlled without authority")
    assert (refusal.value.holder, refusal.value.authority) == (None, None)


async def test_emergency_refuses_control(world):
    await world.robot()
    ocu = await world.ocu()
    driver = await driver_of(ocu)
    await driver.send(SetEmergency(emergency_code=1))

    with pytest.raises(ControlRejected, match=r"not available for control \(its status is EMERGENCY\); whoever set"):
        async with driver.control():
            pytest.fail("controlled in an emergency")

    await driver.send(ClearEmergency(emergency_code=1))
    async with driver.control():
        pass


async def test_preemption_rejects_commands_of_the_former_controller_only(world):
    robot = await world.robot()
    weak, strong = await driver_of(await world.ocu()), await driver_of(await world.ocu("43.1.1"))

    async with weak.control(authority=100) as control:
        await weak.resume()
        async with strong.control(authority=200):
            await until(lambda: control.lost)
            with pytest.raises(ControlRejected, match=r"control of 101\.1\.1 was lost: 101\.1\.1 took it back"):
                await weak.send(FULL)
            await weak.send(SetEmergency(emergency_code=1))  # anybody may, at any time
            await weak.send(ClearEmergency(emergency_code=1))
            assert robot.host.controller == JausID(43, 1, 1)
            assert not control.held
    assert len(world.network.sent(ReleaseControl, HOLDER)) == 0


async def test_loss_of_control_names_the_new_controller(world):
    await world.robot()
    weak, strong = await driver_of(await world.ocu()), await driver_of(await world.ocu("43.1.1"))

    async with weak.control(authority=100) as control, strong.control(authority=200):
        await asyncio.wait_for(control.until_lost(), 2)
        assert control.lost == "101.1.1 took it back, and is held by 43.1.1 with authority 200; you had 100"
        with pytest.raises(ControlRejected) as refusal:
            control.check()
        assert (refusal.value.holder, refusal.value.authority) == (JausID(43, 1, 1), 200)


async def test_new_controller_may_be_unknown(world):
    await world.robot()
    weak, strong = await driver_of(await world.ocu()), await driver_of(await world.ocu("43.1.1"))

    async with weak.control(authority=100) as control:
        world.network.lose(ReportControl, times=100)
        async with strong.control(authority=200):
            await asyncio.wait_for(control.until_lost(), 4)
            assert control.lost.startswith("101.1.1 took it back, and does not tell who has it now")


async def test_emergency_in_standby_keeps_control(world):
    await world.robot(timeout=1)
    driver, other = await driver_of(await world.ocu()), await world.ocu("43.1.1")

    async with driver.control() as control:
        await other.send("101.1.1", SetEmergency(emergency_code=1))
        await asyncio.sleep(2.5)
        assert control.lost == ""
        await other.send("101.1.1", ClearEmergency(emergency_code=1))
        await driver.resume()
        assert control.held


async def test_control_is_kept_alive_beyond_its_timeout(world):
    robot = await world.robot(timeout=1)
    driver = await driver_of(await world.ocu())

    async with driver.control() as control:
        await asyncio.sleep(1.5)
        assert (control.held, robot.host.controller) == (True, HOLDER)
    assert len(world.network.sent(RequestControl)) >= 4


async def test_control_without_timeout_is_not_renewed(world):
    await world.robot(timeout=0)
    driver = await driver_of(await world.ocu())
    async with driver.control() as control:
        await asyncio.sleep(0.05)
        assert control.held


async def test_a_silent_component_counts_as_lost(world):
    await world.robot(timeout=1)
    driver = await driver_of(await world.ocu())

    async with driver.control() as control:
        world.network.keeps = lambda packet: packet.source == HOLDER
        await until(lambda: control.lost, 4)
        assert "has not answered for" in control.lost
        with pytest.raises(ControlRejected):
            await driver.send(FULL)


async def test_silent_component_without_timeout_counts_as_lost(world):
    robot = await world.robot(timeout=0)
    driver = await driver_of(await world.ocu())

    async with driver.control() as control:
        await asyncio.sleep(60)
        assert control.held
        world.network.clock.advance(30)  # as if this program had been busy
        await asyncio.sleep(5)
        assert control.held
        await crash(world, robot)
        await asyncio.wait_for(control.until_lost(), 20)
        assert "101.1.1 has not answered for" in control.lost
        with pytest.raises(ControlRejected):
            await driver.send(FULL)


async def test_component_that_reports_control_is_not_silent(world):
    robot = await world.robot(timeout=1)
    driver = await driver_of(await world.ocu())
    async with driver.control() as control:
        world.network.lose(ConfirmControl)
        await asyncio.sleep(10)
        assert (control.held, robot.host.controller) == (True, HOLDER)


async def test_lost_control_can_be_taken_again(world):
    robot = await world.robot(timeout=1)
    driver = await driver_of(await world.ocu())
    control = driver.control()

    async with control:
        await driver.resume()
        await crash(world, robot)
        await world.robot(timeout=1)
        await asyncio.wait_for(control.until_lost(), 2)
    async with control:
        assert (control.held, control.lost) == (True, "")
        await driver.resume()
        await asyncio.sleep(3)
        await driver.send(FULL)


async def test_exit_ends_until_lost(world):
    await world.robot()
    driver = await driver_of(await world.ocu())
    async with driver.control() as control:
        waiting = asyncio.create_task(control.until_lost())
        await asyncio.sleep(0)
    await asyncio.wait_for(waiting, 1)
    assert control.lost == ""


@pytest.mark.parametrize("is_lost", [False, True])
async def test_until_lost_ends_work_that_sends_nothing(world, is_lost):
    robot = await world.robot()
    weak, strong = await driver_of(await world.ocu()), await driver_of(await world.ocu("43.1.1"))

    async def guard(control) -> None:
        await control.until_lost()
        control.check()

    async def work() -> None:
        async with asyncio.TaskGroup() as group, weak.control(authority=100) as control:
            group.create_task(guard(control))
            await asyncio.sleep(1)
            if is_lost:
                async with strong.control(authority=200):
                    await asyncio.sleep(60)

    if is_lost:
        with pytest.raises(ExceptionGroup) as caught:
            await asyncio.wait_for(work(), 10)
        assert "took it back" in str(caught.value.exceptions[0])
    else:
        await asyncio.wait_for(work(), 10)
    assert robot.host.controller is None


async def test_all_commands_raise_after_loss_of_control(world):
    await world.robot()
    ocu = await world.ocu()
    weak, strong = await driver_of(ocu), await driver_of(await world.ocu("43.1.1"))
    async with weak.control(authority=100) as control, strong.control(authority=200):
        await asyncio.wait_for(control.until_lost(), 2)
        for call in (
            ocu.send("101.1.1", FULL),
            ocu.send("101.1.1", FULL, ack=True),
            ocu.query("101.1.1", FULL, expects=ReportStatus),
            weak.query(FULL, expects=ReportStatus),
        ):
            with pytest.raises(ControlRejected, match="was lost"):
                await call
        assert not world.network.sent(SetWrenchEffort)
        refused = await ocu.query("101.1.1", RequestControl(authority_code=1), expects=ConfirmControl)
        assert refused.response_code == ConfirmControl.ResponseCode.INSUFFICIENT_AUTHORITY


async def crash(world, robot) -> None:
    """It ends without a word."""
    before, world.network.keeps = world.network.keeps, lambda packet: packet.source != robot.id
    await robot.close()
    world.network.keeps = before


async def test_closing_robot_notifies_the_client(world):
    robot = await world.robot(timeout=0)
    driver = await driver_of(await world.ocu())
    async with driver.control() as control:
        await driver.resume()
        await robot.close()
        await asyncio.wait_for(control.until_lost(), 2)
        assert control.lost.endswith(
            "took it back, and does not tell who has it now: it has ended, or packets are lost"
        )


async def test_restart_of_the_robot_loses_control(world):
    robot = await world.robot(timeout=1)
    driver = await driver_of(await world.ocu())

    async with driver.control() as control:
        await driver.resume()
        await crash(world, robot)
        again = await world.robot(timeout=1)
        await asyncio.wait_for(control.until_lost(), 2)
        assert "no client in control; it was restarted" in control.lost
        with pytest.raises(ControlRejected, match="was lost"):
            await driver.send(FULL)
        assert again.host.controller is None


async def test_restart_is_detected_without_report_control(world):
    robot = await world.robot(timeout=1)
    driver = await driver_of(await world.ocu())

    async with driver.control() as control:
        await driver.resume()
        await asyncio.sleep(0.5)
        world.network.lose(ReportControl)
        await crash(world, robot)
        await world.robot(timeout=1)
        await asyncio.wait_for(control.until_lost(), 2)
        assert "101.1.1 went from READY to STANDBY without a command of this OCU" in control.lost


async def test_restart_is_detected_without_control_timeout(world, monkeypatch):
    monkeypatch.setattr(module, "CHECK_INTERVAL", 0.1)
    robot = await world.robot(timeout=0)
    driver = await driver_of(await world.ocu())
    async with driver.control() as control:
        await crash(world, robot)
        await world.robot(timeout=0)
        await asyncio.wait_for(control.until_lost(), 2)


async def test_emergency_of_another_client_loses_control_but_own_standby_does_not(world):
    await world.robot(timeout=1)
    first, second = await world.ocu(), await world.ocu("43.1.1")
    driver = await driver_of(first)

    async with driver.control() as control:
        await driver.resume()
        await asyncio.sleep(0.4)
        await driver.standby()
        await asyncio.sleep(0.7)
        await driver.resume()
        await first.send("101.255.255", SetEmergency(emergency_code=1))
        await first.send("101.255.255", ClearEmergency(emergency_code=1))
        await asyncio.sleep(0.7)
        assert control.held
        await driver.resume()
        await asyncio.sleep(0.4)
        await second.send("101.1.1", SetEmergency(emergency_code=1))
        await asyncio.wait_for(control.until_lost(), 2)
        assert "went from READY to EMERGENCY" in control.lost


async def test_an_emergency_right_after_resume_loses_control(world):
    await world.robot(timeout=1)
    first, second = await world.ocu(), await world.ocu("43.1.1")
    driver = await driver_of(first)
    async with driver.control() as control:
        await driver.resume()
        await second.send("101.1.1", SetEmergency(emergency_code=1))  # before the first check of control
        await asyncio.wait_for(control.until_lost(), 2)
        assert "went from READY to EMERGENCY" in control.lost


@pytest.mark.slow
@pytest.mark.parametrize("seed", sampled(range(5), 1))
async def test_control_is_kept_for_minutes_on_a_network_that_loses_a_quarter(seed):
    services = [AccessControl(timeout=5), Management(), Discovery(), Liveness()]
    async with (
        VirtualNetwork(loss=0.25, seed=seed) as network,
        network.component("101.1.1", services) as robot,
        network.ocu(retries=9) as ocu,
    ):
        client = (await ocu.discover(101)).service("Management")
        async with client.control() as control:
            await asyncio.sleep(600)
            assert control.held, control.lost
            assert robot.host.controller == HOLDER


async def test_own_acknowledged_standby_keeps_control(virtual_network):
    services = [AccessControl(timeout=1), Management(), Discovery(), Liveness()]
    async with virtual_network.component("101.1.1", services), virtual_network.ocu() as ocu:
        client = (await ocu.discover(101)).service("Management")
        async with client.control() as control:
            await client.resume()
            await asyncio.sleep(1)
            await client.send(Standby(), ack=True)
            await asyncio.sleep(10)
            assert control.held, control.lost


async def test_lost_packets_do_not_lose_control(world):
    robot = await world.robot()
    driver = await driver_of(await world.ocu(timeout=0.05, retries=20))
    chance = random.Random(7)
    world.network.keeps = lambda _: chance.random() > 0.3
    async with driver.control():
        await driver.resume()
        assert robot.host.status == Status.READY
    world.network.keeps = lambda _: True
    await until(lambda: robot.host.controller is None, 6)


@pytest.mark.parametrize("error", [ValueError("a bug"), asyncio.CancelledError()])
async def test_exception_in_the_block_stops_and_releases(world, error):
    robot = await world.robot()
    driver = await driver_of(await world.ocu())

    async def drive() -> None:
        async with driver.control():
            await driver.resume()
            await driver.send(FULL)
            raise error

    with pytest.raises(type(error)):
        await asyncio.create_task(drive())
    assert (robot.host.controller, robot.host.status) == (None, Status.STANDBY)
    assert world.drives[0].effort == (0.0, 0.0)


async def test_repeated_cancellation_stops_and_releases(world):
    robot = await world.robot()
    driver = await driver_of(await world.ocu())
    inside = asyncio.Event()

    async def drive() -> None:
        async with driver.control():
            await driver.resume()
            await driver.send(FULL)
            inside.set()
            await asyncio.sleep(60)

    task = asyncio.create_task(drive())
    await inside.wait()
    task.cancel()
    asyncio.get_running_loop().call_soon(task.cancel)

    with pytest.raises(asyncio.CancelledError):
        await task
    await until(lambda: robot.host.controller is None, 1)
    assert world.drives[0].effort == (0.0, 0.0)


@pytest.mark.parametrize("kind", [ReleaseControl, CancelEvent])
async def test_lost_release_is_resent_before_close(world, kind):
    robot = await world.robot(timeout=0)
    ocu = await world.ocu()
    driver = await driver_of(ocu)
    async with driver.subscribe(QueryStatus()), driver.control():
        await driver.resume()
        world.network.lose(kind, times=2)
        await ocu.close()
        assert robot.host.controller is None
        assert not robot.host.service(Events).subscriptions.all()


async def test_close_waits_for_a_block_that_is_being_left(world):
    robot = await world.robot()
    ocu = await world.ocu()
    driver, over = await driver_of(ocu), asyncio.Event()

    async def drive() -> None:
        async with driver.subscribe(QueryStatus()), driver.control():
            await driver.resume()
            over.set()

    world.network.delay = 0.02
    driving = asyncio.create_task(drive())
    await over.wait()
    world.network.lose(Standby, times=1)
    await asyncio.sleep(0.01)
    await ocu.close()
    await asyncio.gather(driving, return_exceptions=True)
    await asyncio.sleep(0.1)
    assert (robot.host.controller, len(world.network.sent(ReleaseControl))) == (None, 1)
    assert not robot.host.service(Events).subscriptions.all()


async def test_stale_reject_control_is_ignored(world):
    robot = await world.robot()
    driver = await driver_of(await world.ocu())
    async with driver.control() as control:
        robot.send(HOLDER, RejectControl(response_code=RejectControl.ResponseCode.CONTROL_RELEASED))
        await asyncio.sleep(5)
        assert (control.held, robot.host.controller) == (True, HOLDER)


async def test_stale_refusal_is_ignored(world):
    robot = await world.robot()
    driver = await driver_of(await world.ocu())
    world.network.delay = 0.02
    control = driver.control()
    entering = asyncio.create_task(control.__aenter__())
    await until(lambda: world.network.sent(RequestControl))
    robot.send(HOLDER, ConfirmControl(response_code=ConfirmControl.ResponseCode.INSUFFICIENT_AUTHORITY))
    await entering
    assert robot.host.controller == HOLDER
    await control.__aexit__(None, None, None)


async def test_late_command_does_not_undo_the_next_one(world):
    robot = await world.robot()
    driver = await driver_of(await world.ocu())
    async with driver.control() as control:
        await driver.resume()
        hold_back(world.network, Standby, 0.2)
        await driver.standby()
        await driver.resume()
        await asyncio.sleep(5)
        assert (control.held, robot.host.status) == (True, Status.READY)


async def test_lost_release_is_resent_after_the_block(world):
    robot = await world.robot(timeout=0)
    driver = await driver_of(await world.ocu())
    async with driver.control():
        world.network.lose(ReleaseControl, times=5)
    await until(lambda: robot.host.controller is None)


async def test_unwanted_control_is_released_despite_packet_loss(world):
    robot = await world.robot(timeout=0)
    driver = await driver_of(await world.ocu())
    world.network.delay = 0.01
    task = asyncio.create_task(driver.control().__aenter__())
    await until(lambda: world.network.sent(RequestControl))
    world.network.lose(ReleaseControl, times=2)
    task.cancel()
    with pytest.raises(asyncio.CancelledError):
        await task
    await until(lambda: robot.host.controller == HOLDER)
    await until(lambda: robot.host.controller is None)


async def test_exit_is_bounded_if_the_robot_is_gone(world):
    robot = await world.robot()
    driver = await driver_of(await world.ocu())
    started = asyncio.get_running_loop().time()

    async with driver.control():
        await robot.close()
        started = asyncio.get_running_loop().time()

    assert asyncio.get_running_loop().time() - started < 2


async def test_a_killed_ocu_stops_the_robot_within_the_timeout(world):
    robot = await world.robot(timeout=1)
    ocu = await world.ocu()
    driver = await driver_of(ocu)

    async with driver.control():
        await driver.resume()
        await driver.send(FULL)
        await until(lambda: world.drives[0].effort[0] > 0)
        world.network.keeps = lambda packet: packet.source != HOLDER  # as if its process were dead
        await until(lambda: world.drives[0].effort == (0.0, 0.0), 2)

    assert (robot.host.controller, robot.host.status) == (None, Status.STANDBY)


async def test_a_closed_ocu_does_not_hang(world):
    await world.robot()
    ocu = await world.ocu()
    driver = await driver_of(ocu)
    async with driver.control():
        await ocu.close()


async def test_unanswered_request_raises_response_timeout(world):
    ocu = await world.ocu(timeout=0.02, retries=1)
    await world.robot()
    driver = await driver_of(ocu)
    world.network.lose(ConfirmControl)
    with pytest.raises(ResponseTimeout, match="RequestControl 2 times"):
        async with driver.control():
            pytest.fail("controlled without confirmation")
    assert world.network.sent(ReleaseControl)


async def test_control_twice_by_one_ocu_is_rejected(world):
    await world.robot()
    ocu = await world.ocu()
    robot = await ocu.discover(subsystem=101)
    async with robot.service("PrimitiveDriver").control():
        with pytest.raises(ControlRejected, match="already controls"):
            async with robot.service("LocalPoseSensor").control():
                pytest.fail("two blocks at once")
        assert (await ocu.query("101.1.1", QueryControl())).subsystem_id == 42
    with pytest.raises(ConfigError, match="authority 256"):
        robot.service("PrimitiveDriver").control(authority=256)


async def test_resume_without_effect_is_a_request_error(world):
    await world.robot()
    driver = await driver_of(await world.ocu())
    async with driver.control():
        world.network.lose(Resume)
        with pytest.raises(RequestError, match=r"reports STANDBY 1 s after Resume; you are in control, so it"):
            await driver.resume(timeout=1)


async def test_resume_without_control_is_an_error(world):
    await world.robot()
    driver = await driver_of(await world.ocu())
    with pytest.raises(
        RequestError,
        match=r"still reports STANDBY 0\.2 s after Resume; it accepts commands only from the client in control",
    ):
        await driver.resume(timeout=0.2)


async def test_resume_of_a_silent_component_raises_response_timeout(world):
    await world.robot()
    driver = await driver_of(await world.ocu())
    world.network.lose(ReportStatus)
    with pytest.raises(ResponseTimeout, match=r"did not report its status within 0\.2 s"):
        await driver.resume(timeout=0.2)
    assert world.network.sent(Resume)


async def test_release_is_confirmed(world):
    await world.robot()
    driver = await driver_of(await world.ocu())
    async with driver.control():
        pass
    assert world.network.sent(RejectControl)


async def test_release_that_is_not_acknowledged_is_reported(world, caplog):
    await world.robot()
    ocu = await world.ocu()
    driver = (await ocu.discover(101)).service("PrimitiveDriver")
    async with driver.control() as control:
        assert control.released is None
    assert control.released is True
    async with driver.control() as control:
        world.network.disconnect(ROBOT)
    assert control.released is False
    assert "did not acknowledge Standby and release of control" in caplog.text
