"""A model in memory that processes share."""

import os
import subprocess
import sys

import pytest

pytest.importorskip("mujoco", reason="MuJoCo is not installed")

import mujoco

from jauspy_sim.rendering.shared_model import ModelMemory, shared_model

BOX = '<mujoco><worldbody><body name="box"><freejoint/><geom size="1 2 3" type="box"/></body></worldbody></mujoco>'
OTHER = """
import mujoco, sys
from jauspy_sim.rendering.shared_model import shared_model
model = shared_model(int(sys.argv[1]), lambda: mujoco.MjModel.from_xml_string(sys.argv[2]))
print(model.geom_size[0].tolist())
"""


@pytest.fixture
def memory():
    opened = ModelMemory()
    yield opened
    opened.close()


def never() -> mujoco.MjModel:
    raise AssertionError("the model is there")


def make() -> mujoco.MjModel:
    return mujoco.MjModel.from_xml_string(BOX)


def test_second_user_of_the_memory_gets_the_model_of_the_first(memory: ModelMemory) -> None:
    made = shared_model(memory.descriptor, make)
    loaded = shared_model(memory.descriptor, never)
    assert loaded.geom_size.tolist() == made.geom_size.tolist() == [[1.0, 2.0, 3.0]]
    with pytest.raises(PermissionError):
        os.pwrite(memory.descriptor, b"x", 0)


def test_model_is_made_again_if_its_maker_died_while_it_wrote(memory: ModelMemory) -> None:
    os.pwrite(memory.descriptor, b"half a model", 0)
    shared_model(memory.descriptor, make)
    assert shared_model(memory.descriptor, never).geom_size.tolist() == [[1.0, 2.0, 3.0]]


def test_error_of_the_maker_leaves_the_memory_empty(memory: ModelMemory) -> None:
    with pytest.raises(AssertionError):
        shared_model(memory.descriptor, never)
    assert shared_model(memory.descriptor, make).nq == 7


def test_other_process_uses_the_model_and_makes_none(memory: ModelMemory) -> None:
    shared_model(memory.descriptor, make)
    command = [sys.executable, "-c", OTHER, str(memory.descriptor), "not a model"]
    done = subprocess.run(command, pass_fds=[memory.descriptor], capture_output=True, text=True, check=False)
    assert done.stdout == "[1.0, 2.0, 3.0]\n", done.stderr


def test_closed_memory_has_no_descriptor(memory: ModelMemory) -> None:
    memory.close()
    memory.close()
    assert memory.descriptor == -1
