"""The power supply of a simulated robot: its battery, and all that takes power from it."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from jauspy.platform.battery import RATE, BatteryState, SimulatedBattery
from jauspy.platform.contract import OptionalPart
from jauspy.platform.description import RobotModel
from jauspy.platform.lights import Lamp
from jauspy.platform.motors import MotorLoad, SimulatedMotors


class PowerSupply:
    """The battery and the motors of a robot, by the table `[battery]`; nothing without that table.

    `loads`: what the motors do now. `cut`: called when they get no power any more.
    """

    def __init__(
        self,
        robot: RobotModel,
        lamps: Sequence[Lamp],
        loads: Callable[[], Iterable[MotorLoad]],
        cut: Callable[[], None],
        rate: float = RATE,
    ) -> None:
        self.parts: tuple[OptionalPart, ...] = ()
        """The battery and the motors."""
        self._battery: SimulatedBattery | None = None
        if (setup := robot.battery) is None:
            return
        cameras = sum(camera.outside is None for camera in robot.cameras) * setup.camera_load

        def others() -> float:
            return cameras + sum(lamp.setup.brightness * lamp.level for lamp in lamps) / setup.lamp_efficacy

        def cut_off() -> None:
            motors.switch_off()
            cut()

        def supply() -> BatteryState:
            return battery.state()

        motors = SimulatedMotors(robot.description.joints.values(), setup, loads, supply)
        battery = SimulatedBattery(setup, loads=others, motors=motors.measure, cut=cut_off, rate=rate)
        self._battery = battery
        self.parts = (battery, motors)

    def step(self, now: float) -> None:
        """Discharge the battery; `now` in seconds of the robot's time."""
        if self._battery is not None:
            self._battery.step(now)
