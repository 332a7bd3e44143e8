"""A robot all of whose texts are programs or markup: `python -m tools.attack.hostile_robot ADDRESS`.

A console that puts one of them into a page where it is not text sets `window.PWNED`, which tests and attacks look for.
"""

from __future__ import annotations

import asyncio
import contextlib
import sys
from collections.abc import AsyncIterator, Sequence
from types import MappingProxyType
from typing import Final

import jauspy
from jauspy.backends import find
from jauspy.geometry.poses import ORIGIN
from jauspy.ids import JausID
from jauspy.messages.environment_sensing.v2_0.visual_sensor import (
    QueryVisualSensorCapabilities,
    ReportVisualSensorCapabilities,
)
from jauspy.platform.joints import joint_positions
from jauspy.platform.link_clearances import clearances_of
from jauspy.platform.modular.arm import ArmController, ArmMotion, ModularArm, ModularArmState
from jauspy.platform.modular.cell import Observation, ObservedPart, PartSensor
from jauspy.platform.modular.connector import ConnectorState, VacuumConnector
from jauspy.platform.modular.holding import Holding
from jauspy.platform.modular.parts import CellSetup, ConnectorLimits
from jauspy.platform.named_poses import NamedPose
from jauspy.robot.robot_files import load, robot_model
from jauspy.services.cell.equipment import PartSensorService
from jauspy.services.cell.modular_arm import ArmMotionControl, ModularArmService
from jauspy.services.cell.vacuum_connector import VacuumConnectorService
from jauspy.services.core.discovery import COMPONENT, NODE, SUBSYSTEM, SYSTEM, Discovery, Identity, OfferedService
from jauspy.services.environment_sensing.digital_video import DigitalVideo
from jauspy.services.environment_sensing.visual_sensor import VisualSensor
from jauspy.services.iop import PresetPose
from jauspy.services.manipulator import Arm, JointDescription, JointPositionDriver, JointPositionSensor
from jauspy.services.service import Service

SUBSYSTEM_ID: Final = 66
_CODE: Final = "window.PWNED=1"
PAYLOADS: Final = (
    f'j" :x="{_CODE}',
    f"j' :x='{_CODE}",
    f"j :x={_CODE}",
    f'j" :onclick="{_CODE}" :innerHTML="{_CODE}',
    f":{_CODE}",
    f"<img src=x onerror={_CODE}>",
    f'"><svg onload="{_CODE}">',
    f"</script><script>{_CODE}</script>",
    f"{{{{constructor.constructor('{_CODE}')()}}}}",
    f"javascript:{_CODE}",
    f"${{{_CODE}}}`+({_CODE})+`",
    f'");{_CODE};("',
    f"');{_CODE};('",
    f"\\u2028{_CODE}//\\",
    f"</style><style onload={_CODE}>",
    "__proto__",
    "constructor",
)
"""Texts that become something else where they are put into properties, markup, templates, addresses or scripts."""
IN_FILES: Final = (*PAYLOADS, f"\u2028{_CODE}\u2029", f"\u202e{_CODE}", "<\u0130mg src=x>")
"""Those of files, whose letters need not be Latin-1."""
UNPRINTABLE: Final = ("\x1b[2Jcleared", "two\nlines")
"""Texts that are commands to a terminal."""
IMAGE: Final = f"<img src=x onerror={_CODE}>"


class _Arm(ModularArm):
    name = "arm"

    def state(self) -> ModularArmState:
        zeros = (0.0,) * len(PAYLOADS)
        return ModularArmState(
            base=IMAGE,
            tip=IMAGE,
            joints=PAYLOADS,
            parts=PAYLOADS,
            positions=zeros,
            velocities=zeros,
            efforts=zeros,
            targets=zeros,
            error=PAYLOADS[0],
        )

    def begin(self, motion: ArmMotion) -> None:
        """Nothing moves."""

    def hold(self) -> None:
        """Nothing moves."""

    def set_controller(self, controller: ArmController) -> None:
        """Nothing moves."""

    def set_order(self, joints: Sequence[str]) -> None:
        """Nothing moves."""


class _Sensor(PartSensor):
    def state(self) -> Observation:
        return Observation(1.0, tuple(ObservedPart(text, text, ORIGIN) for text in PAYLOADS))


class _Connector(VacuumConnector):
    name = IMAGE

    def state(self) -> ConnectorState:
        return ConnectorState(enabled=True, attached_to=PAYLOADS[0])

    def set(self, enabled: bool) -> None:
        """Nothing moves."""

    def schedule(self, enabled: bool, delay: float) -> None:
        """Nothing moves."""

    def cancel(self) -> None:
        """Nothing is to come."""


class _Video(DigitalVideo):
    """A camera that answers no query."""

    def __init__(self) -> None:
        self._cameras = {}


class _Lens(VisualSensor):
    """A camera with a name."""

    def __init__(self) -> None:
        self._cameras = {}

    def send_report_visual_sensor_capabilities(
        self,
        query: QueryVisualSensorCapabilities,  # noqa: ARG002 - the method of the service
    ) -> ReportVisualSensorCapabilities:
        """The name only."""
        record = ReportVisualSensorCapabilities.VisualSensorCapabilitiesRec
        return ReportVisualSensorCapabilities([record(1, PAYLOADS[0])])


def _posed_arm() -> list[Service]:
    """Services of an arm whose poses have these texts as names."""
    model = robot_model(load("inc1"))
    robot = find("kinematic").open(model, "empty")
    arm = Arm(robot.groups["arm"])
    names = [joint.name for joint in arm.joints.joints]
    start = dict(zip(names, robot.groups["arm"].state().positions, strict=True))
    poses = [NamedPose(number, text, start) for number, text in enumerate((*PAYLOADS, *UNPRINTABLE), 1)]
    return [
        JointPositionDriver(arm),
        JointPositionSensor(arm),
        JointDescription("arm", robot.groups["arm"], arm),
        PresetPose(arm, poses, clearances_of(model, names), lambda: joint_positions(robot.groups.values())),
    ]


def _components(connect: str) -> list[jauspy.Component]:
    """Those with functions first, then one for each text."""
    cell = CellSetup(MappingProxyType({}), ())
    functions: list[list[Service]] = [
        [
            ModularArmService(ArmMotionControl(_Arm()), cell),
            VacuumConnectorService(IMAGE, PAYLOADS[0], [_Connector()], ConnectorLimits(), Holding(100.0, 0.03, 0.5)),
            PartSensorService(_Sensor()),
        ],
        [_Video(), _Lens()],
        *[[] for _ in PAYLOADS],
        _posed_arm(),
    ]
    names = (PAYLOADS[0], PAYLOADS[0], *PAYLOADS, PAYLOADS[0])
    return [
        _component(JausID(SUBSYSTEM_ID, 1, number), name, services, connect)
        for number, (name, services) in enumerate(zip(names, functions, strict=True), 1)
    ]


def _component(id: JausID, name: str, services: list[Service], connect: str) -> jauspy.Component:
    levels = {SYSTEM: 10001, SUBSYSTEM: 10001, NODE: 40001, COMPONENT: 60001}
    texts = {SUBSYSTEM: PAYLOADS[0], NODE: IMAGE, SYSTEM: IMAGE, COMPONENT: name}
    discovery = Discovery({level: Identity(texts[level], type) for level, type in levels.items()})
    component = jauspy.Component(id, [discovery, *services], connect=connect)
    own = discovery.directory.all()[id]
    also = [OfferedService(f"urn:{name}", 1, 0), OfferedService(name, 2, 0)]
    if services:  # an arm whose queries have no answer
        also.append(OfferedService("urn:jaus:jss:manipulator:ManipulatorJointPositionDriver", 1, 0))
    discovery.directory.register(id, (*own, *also))
    return component


@contextlib.asynccontextmanager
async def hostile_robot(connect: str) -> AsyncIterator[None]:
    """The robot, connected to the node manager at this address."""
    async with contextlib.AsyncExitStack() as stack:
        for component in _components(connect):
            await stack.enter_async_context(component)
        yield


async def main(connect: str) -> None:
    """Run until the process is ended."""
    async with hostile_robot(connect):
        print("ready", flush=True)
        await asyncio.Event().wait()


if __name__ == "__main__":
    with contextlib.suppress(KeyboardInterrupt):
        asyncio.run(main(sys.argv[1]))
