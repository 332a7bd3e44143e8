"""Files of trials: those that come with jauspy fit the cell, and a mistake is one sentence with its place."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, strategies as st

from jauspy.cell.ariac import trial_file
from jauspy.cell.ariac.trial_file import MAX_SIZE, Trial, load, names, shipped
from jauspy.cell.ariac.workcell import PLACES, TRAY_SIZE, changed
from jauspy.cell.frames import se3_of_pose
from jauspy.cell.scene import Layout
from jauspy.errors import ConfigError
from jauspy.robot import robot_files

GOOD = """
name = "one"
[[orders]]
id = "A"
tray = 1
products = [{ type = "wheel", quadrant = 1 }]
"""


@pytest.mark.parametrize("name", names())
def test_each_trial_that_comes_along_fits_the_cell(name: str) -> None:
    trial = load(name)
    config = changed(robot_files.load("cell"), trial)
    assert config.cell is not None
    assert "car" not in [part.name for part in config.cell.parts]
    assert not set(trial.missing_parts) & {part.name for part in config.cell.parts}


def test_all_challenges_are_there() -> None:
    found = {challenge for name in names() for challenge in load(name).challenges}
    assert found == {
        "dropped parts",
        "faulty parts",
        "flipped parts",
        "insufficient parts",
        "moving belt",
        "order change",
        "priority order",
        "sensor blackout",
    }
    assert len(names()) == 10


ORDER = '[[orders]]\nid = "A"\ntray = 1\nproducts = [{ type = "wheel", quadrant = 1 }]\n'


@pytest.mark.parametrize(
    ("text", "problem"),
    [
        ("", "name: is missing; orders: is missing"),
        ("name = ", "is not TOML"),
        (GOOD + "speed = 3", "line 7: orders[0].speed = 3: there is no such key; known here are: announcement"),
        (GOOD.replace("tray = 1", "tray = 3"), "line 5: orders[0].tray = 3: input should be less than or equal to 2"),
        (GOOD.replace("quadrant = 1", "quadrant = 0"), "orders[0].products[0].quadrant = 0: input should be greater"),
        (GOOD.replace('id = "A"', 'id = "A B"'), "a name has letters, digits and the characters"),
        (
            GOOD.replace("quadrant = 1 }", 'quadrant = 1 }, { type = "box", quadrant = 1 }'),
            "line 3: orders[0].products: quadrant 1 is there twice",
        ),
        (GOOD + ORDER, "orders: A is there twice"),
        (
            GOOD + "announcement = {}",
            "orders[0].announcement.time_condition: give one of time_condition, part_place_condition and submission",
        ),
        (
            GOOD + 'announcement = { submission_condition = "A" }',
            "orders: one needs an announcement at a time, or the trial never begins",
        ),
        (
            GOOD + '[[changes]]\norder = "B"\nwhen = { time_condition = 1.0 }\n'
            'products = [{ type = "box", quadrant = 1 }]',
            "changes[0].order: no order 'B'; there are: A",
        ),
        (
            GOOD + '[[sensor_blackouts]]\nwhen = { submission_condition = "Z" }\nduration = 1.0',
            "sensor_blackouts[0].when: there is no order 'Z'; there are: A",
        ),
        (GOOD + "[[belt_speeds]]\nwhen = { time_condition = nan }\nspeed = 0.1", "belt_speeds[0].when.time_condition"),
        (GOOD + "[[belt_speeds]]\nwhen = { time_condition = 1.0 }\nspeed = 9.0", "belt_speeds[0].speed = 9.0: input"),
        ("time_limit = 0\n" + GOOD, "line 1: time_limit = 0: input should be greater than 0"),
    ],
)
def test_a_mistake_is_one_sentence_with_its_place(tmp_path: Path, text: str, problem: str) -> None:
    file = tmp_path / "trial.toml"
    file.write_text(text)
    with pytest.raises(ConfigError) as error:
        load(str(file))
    message = str(error.value)
    assert message.startswith(f"{file}: ")
    assert problem in message
    assert "\n" not in message


@pytest.mark.parametrize(
    ("line", "problem"),
    [
        ('faulty_parts = ["wheel_1"]', "faulty_parts[0] = 'wheel_1': not such a part; there are: servo_1, servo_2"),
        ('flipped_parts = ["box_1"]', "flipped_parts[0] = 'box_1': not such a part; there are: bracket_1"),
        ('missing_parts = ["ghost"]', "missing_parts[0] = 'ghost': not such a part"),
    ],
)
def test_a_part_that_cannot_fail_so_is_named(line: str, problem: str, tmp_path: Path) -> None:
    file = tmp_path / "trial.toml"
    file.write_text(line + GOOD)
    with pytest.raises(ConfigError) as error:
        changed(robot_files.load("cell"), load(str(file)))
    assert problem in str(error.value)


def test_a_type_that_no_part_has_is_named_with_those_that_there_are(tmp_path: Path) -> None:
    file = tmp_path / "trial.toml"
    file.write_text(GOOD.replace('"wheel"', '"gear"'))
    with pytest.raises(ConfigError, match=r"orders\[0\]\.products\[0\]\.type = 'gear': no part has this type") as error:
        changed(robot_files.load("cell"), load(str(file)))
    assert "platform" not in str(error.value), "bases are no products"


def test_a_trial_of_the_wrong_name_or_size_is_refused(tmp_path: Path) -> None:
    with pytest.raises(ConfigError, match="there is no trial 'none'; there are: 01_plain, "):
        shipped("none")
    with pytest.raises(ConfigError, match="cannot be read"):
        load(str(tmp_path / "none.toml"))
    large = tmp_path / "large.toml"
    large.write_text("#" * (MAX_SIZE + 1))
    with pytest.raises(ConfigError, match="has more than"):
        load(str(large))


@given(st.binary(max_size=300))
def test_whatever_is_in_a_file_ends_in_a_sentence(data: bytes) -> None:
    try:
        Trial.model_validate(trial_file.parse_toml(data, "trial"))
    except (ConfigError, ValueError):
        return


@given(st.sampled_from([1, 2]), st.integers(1, 4))
def test_the_middle_of_a_quadrant_is_in_it(tray: int, quadrant: int) -> None:
    place = PLACES[tray]
    assert place.quadrant_of(*place.quadrant(quadrant)) == quadrant
    assert place.quadrant_of(place.x + TRAY_SIZE[0], place.y) is None


def test_a_flipped_part_lies_in_the_same_place_with_its_back_upward(layout: Layout) -> None:
    trial = load("02_flipped_parts")
    cell = changed(robot_files.load("cell"), trial).cell
    assert cell is not None
    new, old = ({part.name: part for part in setup.parts} for setup in (cell, layout.setup))
    for name in trial.flipped_parts:
        kind = cell.type_of(name)
        before, after = (se3_of_pose(parts[name].pose) for parts in (old, new))
        assert (before * layout.grasp(name)).rotation[2, 2] < -0.9
        assert (after * layout.grasp(name)).rotation[2, 2] > 0.9
        middle = np.array(kind.solids[0].pose.position)
        assert after.act(middle) == pytest.approx(before.act(middle), abs=1e-4)
    assert new["tube_2"] == old["tube_2"]
