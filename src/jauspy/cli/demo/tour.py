"""The demo's script as far as any backend goes: drive, and move the arm; all of it as an OCU, over JAUS."""

from __future__ import annotations

from contextlib import AsyncExitStack
from pathlib import Path
from typing import Final

from jauspy.cli.demo import plan
from jauspy.cli.demo.arm import Arm
from jauspy.cli.demo.drive import to_the_table
from jauspy.cli.demo.reach import Hand
from jauspy.cli.demo.report import Finding, Report
from jauspy.cli.demo.watch import Watcher
from jauspy.modules.config import RobotConfig
from jauspy.modules.robots import robot_model
from jauspy.ocu import OCU, Control
from jauspy.ocu.robot import Robot

MOVED: Final = ("CM-MOB", "CM-MAN", "CM-EEF")
"""Types of module that are controlled."""


class Tour:
    """One run of it with the robot of `config`; what it reaches goes into `report`, files into `folder`."""

    def __init__(self, ocu: OCU, config: RobotConfig, watcher: Watcher, report: Report, folder: Path) -> None:
        self._ocu, self._config, self._watcher, self._report, self._folder = ocu, config, watcher, report, folder
        self._model = robot_model(config)
        self._scene = watcher.scene
        self._modules = {module.type: config.id_of(module) for module in config.modules}

    async def run(self) -> None:
        """All of it. Raises `JausError` for what goes wrong so that nothing can follow."""
        robot = await self._discover()
        async with AsyncExitStack() as stack:
            driving, arm = await self._begin(stack, robot)
            self._step("drive", f"Drive {plan.STAND[0]:g} m forward and turn")
            self._found(await to_the_table(robot, driving, self._scene))
            self._step("reach", "Move the arm to a pose")
            off = await arm.go(0.0, *plan.LOOKS_FROM)
            self._found(Finding("arm", f"at its pose, {off:.4f} rad off", True, {"joint_error": off}))
            self._step("", "Standby, release control")

    async def _discover(self) -> Robot:
        self._watcher.step(f"Discover subsystem {self._config.subsystem}")
        robot = await self._ocu.discover(self._config.subsystem)
        self._watcher.discovered(robot.info)
        return robot

    async def _begin(self, stack: AsyncExitStack, robot: Robot) -> tuple[Control, Arm]:
        """Take control of what moves; given back at the end of the stack, however that comes."""
        controls = []
        ids = [self._modules[type] for type in MOVED]
        self._watcher.step(f"Take control of {', '.join(map(str, ids))} with authority {plan.AUTHORITY}; Resume")
        for id in ids:
            management = robot.component(id.component).service("Management")
            controls.append(await stack.enter_async_context(management.control(plan.AUTHORITY)))
            self._scene.controlled = True
            await management.resume()
        _, arm_id, gripper_id = ids
        hand = Hand(self._model)
        arm = Arm(robot, robot.component(arm_id.component), robot.component(gripper_id.component), hand, self._scene)
        await stack.enter_async_context(arm.watched())
        return controls[0], arm

    def _step(self, phase: str, text: str) -> None:
        if phase:
            self._scene.phases.append((self._scene.elapsed, phase))
        self._watcher.step(text)

    def _found(self, finding: Finding) -> None:
        self._report.findings.append(finding)
        self._watcher.found(finding)
