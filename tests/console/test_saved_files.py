"""Named poses and trajectories: whose they are, who may change them, and files that were made to do harm."""

from __future__ import annotations

import json
import os
from pathlib import Path

import pytest

from jauspy.console.saved_files import MAX_SAVED, SavedByOther, SavedFiles, read_poses
from jauspy.console.trajectory import MAX_FILE, Trajectory, TrajectoryRow
from jauspy.console.users import User
from jauspy.errors import ConfigError

ARM = "101.1.104"
ANNA, BEN, CARL = User("anna", "operator", 127), User("ben", "observer", 0), User("carl", "supervisor", 255)
WAVE = Trajectory(("turn",), [TrajectoryRow(2.0, [0.5])])


def test_poses_of_several_robots_are_read(tmp_path: Path) -> None:
    file = tmp_path / "poses.toml"
    file.write_text('[inc1.stowed]\nelbow = 2\n[inc1."look ahead"]\nturn = 0.3\n[cell.up]\nservo_1 = -0.5\n')
    assert read_poses(file) == {
        "inc1": {"stowed": {"elbow": 2.0}, "look ahead": {"turn": 0.3}},
        "cell": {"up": {"servo_1": -0.5}},
    }


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("[inc1]\nelbow = 2.0\n", r"poses.toml: inc1.elbow: expected a table \[ROBOT.POSE\]"),
        ("[inc1.up]\nelbow = nan\n", "poses.toml: inc1.up.elbow: expected a table"),
        ('[inc1."<b>"]\nelbow = 1.0\n', "poses.toml: '<b>': a name is 1 to 40 letters"),
        ("[inc1", "poses.toml: is not TOML"),
    ],
)
def test_a_mistake_is_reported_with_its_place(tmp_path: Path, text: str, said: str) -> None:
    file = tmp_path / "poses.toml"
    file.write_text(text)
    with pytest.raises(ConfigError, match=said):
        read_poses(file)


class Shelf:
    """The files of one robot for several users; `log` has the changes."""

    def __init__(self, root: Path) -> None:
        self.log: list[str] = []
        self.root = root

    def of(self, user: User | None) -> SavedFiles:
        return SavedFiles(101, "inc1", user, self.log.append, self.root)


@pytest.fixture
def shelf(tmp_path: Path) -> Shelf:
    return Shelf(tmp_path)


@pytest.mark.parametrize("user", [BEN, None])
def test_who_may_only_observe_changes_nothing(shelf: Shelf, user: User | None) -> None:
    shelf.of(ANNA).save_pose(ARM, "stow", {"elbow": 1.0})
    shelf.of(ANNA).save_trajectory("wave", WAVE, "inc1")
    before = {path: path.read_bytes() for path in shelf.root.rglob("*.json")}
    theirs = shelf.of(user)
    for change in (
        lambda: theirs.save_pose(ARM, "stow", {"elbow": 2.0}),
        lambda: theirs.save_pose(ARM, "new", {"elbow": 2.0}),
        lambda: theirs.delete_pose(ARM, "stow"),
        lambda: theirs.save_trajectory("wave", Trajectory(), "inc1"),
        lambda: theirs.delete_trajectory("wave"),
    ):
        with pytest.raises(ConfigError, match="may not save or delete poses, trajectories and missions"):
            change()
    assert {path: path.read_bytes() for path in shelf.root.rglob("*.json")} == before
    assert theirs.poses(ARM)["stow"].positions == {"elbow": 1.0}
    assert theirs.trajectory("wave") == WAVE
    assert len(shelf.log) == 2


def test_the_author_is_saved_and_changes_are_reported(shelf: Shelf) -> None:
    shelf.of(ANNA).save_pose(ARM, "stow", {"elbow": 1.0})
    shelf.of(ANNA).save_trajectory("wave", WAVE, "inc1")
    assert str(shelf.of(BEN).poses(ARM)["stow"].author).startswith("saved by anna, 20")
    assert shelf.of(BEN).trajectory("wave").author.by == "anna"
    shelf.of(ANNA).delete_pose(ARM, "stow")
    assert shelf.log == [
        "robot 101: saved the pose stow of 101.1.104",
        "robot 101: saved the trajectory wave",
        "robot 101: deleted the pose stow of 101.1.104",
    ]


def test_what_somebody_else_has_saved_is_replaced_only_by_who_has_seen_that(shelf: Shelf) -> None:
    anna, carl = shelf.of(ANNA), shelf.of(CARL)
    anna.save_pose(ARM, "stow", {"elbow": 1.0})
    anna.save_trajectory("wave", WAVE, "inc1")
    anna.save_pose(ARM, "stow", {"elbow": 1.5})
    seen = anna.poses(ARM)["stow"].author
    for change in (
        lambda: carl.save_pose(ARM, "stow", {"elbow": 2.0}),
        lambda: carl.delete_pose(ARM, "stow"),
        lambda: carl.save_trajectory("wave", Trajectory(), "inc1"),
        lambda: carl.delete_trajectory("wave"),
    ):
        with pytest.raises(SavedByOther, match="was saved by anna, 20"):
            change()
    assert anna.poses(ARM)["stow"].positions == {"elbow": 1.5}
    carl.save_pose(ARM, "stow", {"elbow": 2.0}, seen=seen)
    assert shelf.log[-1].startswith("robot 101: saved the pose stow of 101.1.104, which was saved by anna, 20")
    with pytest.raises(SavedByOther, match="was saved by carl"):
        anna.save_pose(ARM, "stow", {"elbow": 1.0}, seen=seen)
    with pytest.raises(SavedByOther, match="was saved by carl"):
        anna.delete_pose(ARM, "stow")


def test_files_of_earlier_versions_are_read_and_have_no_author(shelf: Shelf) -> None:
    folder = shelf.root / "101-inc1"
    (folder / "trajectories").mkdir(parents=True)
    (folder / "poses.json").write_text(json.dumps({"poses": {ARM: {"stow": {"elbow": 1.0}}}}))
    (folder / "trajectories" / "wave.json").write_text(WAVE.to_json("inc1"))
    assert shelf.of(BEN).poses(ARM)["stow"].positions == {"elbow": 1.0}
    assert str(shelf.of(BEN).trajectory("wave").author) == "saved by an unknown user"
    with pytest.raises(SavedByOther, match="an unknown user"):
        shelf.of(ANNA).delete_trajectory("wave")


ESC = "\x1b]0;x\x07\u202e"
HOSTILE_POSES = {
    "nested lists": b"[" * 100_000,
    "nested objects": b'{"poses":' * 50_000,
    "not UTF-8": b'{"poses": {"\xff\xfe": {}}}',
    "NaN": b'{"poses": {"101.1.104": {"a": {"b": NaN}}}}',
    "infinity": b'{"poses": {"101.1.104": {"a": {"b": 1e999}}}}',
    "a long key": json.dumps({"poses": {"x" * 500_000: {"a": {"b": "c"}}}}).encode(),
    "escapes in a key": json.dumps({"poses": {ESC: {"a": {"b": "c"}}}}).encode(),
    "huge": b" " * (MAX_FILE + 1),
    "noise": bytes(range(256)) * 16,
}


@pytest.mark.parametrize("data", HOSTILE_POSES.values(), ids=HOSTILE_POSES)
def test_a_saved_file_made_to_do_harm_is_one_short_sentence(shelf: Shelf, data: bytes) -> None:
    folder = shelf.root / "101-inc1" / "trajectories"
    folder.mkdir(parents=True)
    (folder.parent / "poses.json").write_bytes(data)
    (folder / "x.json").write_bytes(data)
    for read in (lambda: shelf.of(ANNA).poses(ARM), lambda: shelf.of(ANNA).trajectory("x")):
        with pytest.raises(ConfigError) as found:
            read()
        assert str(found.value).isprintable()
        assert len(str(found.value)) < 1000


def test_files_that_are_no_files_are_refused(shelf: Shelf) -> None:
    folder = shelf.root / "101-inc1" / "trajectories"
    folder.mkdir(parents=True)
    os.mkfifo(folder.parent / "poses.json")
    os.mkfifo(folder / "pipe.json")
    (folder / "device.json").symlink_to("/dev/zero")
    (folder / "folder.json").mkdir()
    with pytest.raises(ConfigError, match="is not a regular file"):
        shelf.of(ANNA).poses(ARM)
    for name in ("pipe", "device", "folder"):
        with pytest.raises(ConfigError, match="is not a regular file"):
            shelf.of(ANNA).trajectory(name)
    secret = shelf.root / "secret"
    secret.write_text("content")
    (folder / "wave.new").symlink_to(secret)
    with pytest.raises(ConfigError, match="cannot be written"):
        shelf.of(ANNA).save_trajectory("wave", WAVE, "inc1")
    assert secret.read_text() == "content"


def test_only_names_that_could_be_saved_are_listed(shelf: Shelf) -> None:
    folder = shelf.root / "101-inc1" / "trajectories"
    folder.mkdir(parents=True)
    for name in (ESC.replace("/", ""), "<img src=x>", "x" * 60, ".hidden", *map(str, range(MAX_SAVED + 50))):
        (folder / f"{name}.json").touch()
    names = shelf.of(ANNA).trajectories()
    assert len(names) == MAX_SAVED
    assert all(name.isdecimal() for name in names)
    poses = {name: {"b": 0.0} for name in (ESC, "<b>", "x" * 60, "../up", "fine")}
    (folder.parent / "poses.json").write_text(json.dumps({"poses": {ARM: poses}}))
    assert list(shelf.of(ANNA).poses(ARM)) == ["fine"]


HOSTILE_TOML = {
    "nested lists": b"a = " + b"[" * 100_000,
    "nested tables": b"a = " + b"{b = " * 5000,
    "dotted keys": b"a" + b".a" * 20_000 + b" = 1",
    "not UTF-8": b"[\xff]",
    "a name twice": b"[inc1.up]\na = 1\n[inc1.up]\na = 2\n",
    "NaN": b"[inc1.up]\na = nan\n",
    "path parts": b'[inc1."../../x"]\na = 1\n',
    "escapes": b'[inc1."\\u001b]0;x\\u202e"]\na = 1\n',
    "a long name": b"[inc1." + b"x" * 100_000 + b"]\na = 1\n",
    "a huge number": b"[inc1.up]\na = " + b"9" * 5000,
    "huge": b"#" * (MAX_FILE + 1),
    "many mistakes": b"".join(b"[r%d.p]\na = 'x'\n" % n for n in range(10_000)),
}


@pytest.mark.parametrize("data", HOSTILE_TOML.values(), ids=HOSTILE_TOML)
def test_a_given_file_of_poses_made_to_do_harm_is_one_short_sentence(tmp_path: Path, data: bytes) -> None:
    file = tmp_path / "poses.toml"
    file.write_bytes(data)
    with pytest.raises(ConfigError) as found:
        read_poses(file)
    assert str(found.value).isprintable()
    assert len(str(found.value)) < 1000
