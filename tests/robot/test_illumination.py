"""IlluminationService: a client in control switches the lamps that a robot has."""

from __future__ import annotations

from dataclasses import replace
from datetime import UTC, datetime

import pytest

from jauspy.backends.kinematic import KinematicRobot
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages import registry
from jauspy.messages.core import RequestControl
from jauspy.messages.ugv import (
    QueryIlluminationConfiguration,
    QueryIlluminationState,
    SetIlluminationState,
)
from jauspy.platform.lights import LampSetup, Switch, lamps_of
from jauspy.robot import robot_files
from jauspy.robot.config import ModuleConfig, RobotConfig
from jauspy.robot.hosts import host_of
from jauspy.robot.realtime import RealTime

CLIENT = JausID(42, 1, 1)
CONFIG = robot_files.load("inc1")


class Lit:
    """The CM-MOB of an inc1 with a dimmed lamp besides its own."""

    def __init__(self):
        model = robot_files.robot_model(CONFIG)
        model = replace(model, lamps=(*model.lamps, LampSetup("work", "base_link", Switch.VARIABLE_LIGHT_1)))
        self.robot = KinematicRobot(model)
        self.realtime = RealTime(self.robot)
        (module,) = (each for each in CONFIG.modules if each.component == 102)
        clock = lambda: datetime(2026, 1, 1, tzinfo=UTC)  # noqa: E731
        self.host = host_of(CONFIG, module, model, self.realtime, {}, utc_now=clock, now=0.0)

    def tell(self, *messages):
        for message in messages:
            self.host.receive(message.encode(), CLIENT, 0.0)
        self.realtime._make_step()
        return [registry.decode(each.payload) for each in self.host.poll_output(0.0)]

    def lamps(self):
        return {lamp.setup.name: lamp.level for lamp in lamps_of(self.robot)}

    def state(self):
        (report,) = self.tell(QueryIlluminationState())
        return report.illumination


def switched(**lights):
    names = [each for each in SetIlluminationState.Illumination.__dataclass_fields__ if not each.startswith("reserved")]
    return SetIlluminationState(SetIlluminationState.Illumination(**(dict.fromkeys(names, 0) | lights)))


@pytest.fixture
def lit():
    made = Lit()
    yield made
    made.robot.close()


def test_configuration_names_the_lights_that_there_are(lit):
    (report,) = lit.tell(QueryIlluminationConfiguration())
    types = report.types
    assert (types.headlights, types.visible_light_source, types.variable_light1) == (1, 1, 1)
    assert (types.high_beams, types.left_turn_signal, types.variable_light2) == (0, 0, 0)


def test_lights_are_switched_and_reported(lit):
    lit.tell(RequestControl(200))
    lit.tell(switched(headlights=1, variable_light1=9))
    assert lit.lamps() == {"front": 1.0, "arm": 0.0, "work": 0.6}
    state = lit.state()
    assert (state.headlights, state.visible_light_source, state.variable_light1) == (1, 0, 9)
    lit.tell(switched(visible_light_source=1))
    assert lit.lamps() == {"front": 0.0, "arm": 1.0, "work": 0.0}


def test_without_control_and_for_lights_that_are_not_there_nothing_is_switched(lit):
    lit.tell(switched(headlights=1))
    assert lit.lamps()["front"] == 0.0
    lit.tell(RequestControl(200))
    lit.tell(switched(headlights=1, fog_lights=1))
    assert lit.lamps()["front"] == 0.0


def test_a_robot_without_lamps_has_no_such_service():
    bare = CONFIG.model_copy(update={"lights": ()})
    model = robot_files.robot_model(bare)
    robot = KinematicRobot(model)
    module = ModuleConfig(type="CM-MOB", component=102, services=("Discovery", "IlluminationService"))
    with pytest.raises(ConfigError, match=r"needs lamps \(\[\[lights\]\]\)"):
        host_of(bare, module, model, robot, {}, utc_now=lambda: datetime(2026, 1, 1, tzinfo=UTC), now=0.0)
    robot.close()


def test_errors_of_the_table_name_the_key(tmp_path):
    with pytest.raises(ValueError, match="lights"):
        RobotConfig.model_validate(CONFIG.model_dump() | {"lights": [{"name": "a", "link": "base_link"}]})
    file = tmp_path / "robot.toml"
    file.write_text('extends = "inc1"\n[[lights]]\nname = "a"\nlink = "nose"\nswitch = "headlights"\n')
    with pytest.raises(ConfigError, match=r"lights\[0\].link: the URDF has no link 'nose'"):
        robot_files.robot_model(robot_files.load(file))
