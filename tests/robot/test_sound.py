"""Microphones and loudspeakers in a robot's file."""

from __future__ import annotations

from pathlib import Path

import pytest

from jauspy.errors import ConfigError
from jauspy.robot.robot_files import load, robot_model


@pytest.fixture
def write(tmp_path):
    def write(text: str) -> Path:
        path = tmp_path / "robot.toml"
        path.write_text(f'extends = "inc1"\n{text}')
        return path

    return write


MICROPHONE = '[[microphones]]\nname = "ear"\nlink = "base_link"\n'
LOUDSPEAKER = '[[loudspeakers]]\nname = "horn"\nlink = "base_link"\n'


def test_inc1_has_one_of_each():
    model = robot_model(load("inc1"))
    assert [item.name for item in (*model.microphones, *model.loudspeakers)] == ["body", "announcer"]


def test_folder_of_recordings_is_below_that_of_the_file(write, tmp_path):
    config = load(write(LOUDSPEAKER + 'folder = "said"\n'))
    assert config.loudspeakers[0].folder == str(tmp_path / "said")


@pytest.mark.parametrize("folder", ["..", "../x", "/tmp/x", ".hidden", "x/../../y"])
def test_folder_elsewhere_is_refused(write, folder):
    with pytest.raises(ConfigError, match=r"loudspeakers\.folder = .*--announcements FOLDER"):
        load(write(LOUDSPEAKER + f'folder = "{folder}"\n'))


def test_folder_behind_a_link_is_refused(write, tmp_path, tmp_path_factory):
    (tmp_path / "link").symlink_to(tmp_path_factory.mktemp("elsewhere"))
    with pytest.raises(ConfigError, match="goes through a link"):
        load(write(LOUDSPEAKER + 'folder = "link/said"\n'))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (MICROPHONE.replace("base_link", "nose"), r"microphones\[0\]\.link: the URDF has no link 'nose'"),
        (LOUDSPEAKER.replace("base_link", "nose"), r"loudspeakers\[0\]\.link: the URDF has no link 'nose'"),
        (MICROPHONE + MICROPHONE, "ear is there twice"),
        (MICROPHONE + LOUDSPEAKER.replace("horn", "ear"), "ear is there twice"),
        (LOUDSPEAKER.replace("horn", "../horn"), "letters, digits"),
        (MICROPHONE + "ambient = 500.0\n", "ambient"),
        (MICROPHONE + "rate = 3\n", "rate"),
        (LOUDSPEAKER + "port = 70000\n", "port"),
        ("[[tones]]\nposition = [1.0, 2.0, inf]\n", "position"),
        ("[[tones]]\nposition = [1.0, 2.0, 0.0]\nfrequency = 1.0\n", "frequency"),
        (
            (
                'microphones = []\n[[modules]]\ntype = "CM-AUD"\ncomponent = 113\n'
                'services = ["Discovery", "AEODRSDigitalAudioSensor"]\n'
            ),
            "microphones: there is none, and 113 offers AEODRSDigitalAudioSensor",
        ),
    ],
)
def test_mistakes_get_a_sentence(write, text, said):
    with pytest.raises(ConfigError, match=said):
        robot_model(load(write(text)))
