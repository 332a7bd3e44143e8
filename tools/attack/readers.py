"""Reads files as jauspy's commands do: `python readers.py KIND FILE...`. For a refused file the status is 2.

Before each file its name is printed, so that the last one is that of a file which ends the program; then the time.
"""

from __future__ import annotations

import contextlib
import shutil
import struct
import sys
import time
from collections.abc import Callable, Mapping
from importlib import import_module
from itertools import islice
from pathlib import Path
from typing import Final

import jauspy
from jauspy.cli.main import main as command
from jauspy.codec.source import generate
from jauspy.console.saved_files import SavedFiles, read_poses
from jauspy.console.users import LOCAL, Users
from jauspy.errors import CodecError, JausError
from jauspy.geometry.poses import PlanarPose
from jauspy.mapping.mapper import Mapper
from jauspy.node.address_books import load_address_book
from jauspy.node.config import load_config
from jauspy.robot import robot_files
from jauspy.schema.loader import load_own

ROBOT: Final = Path(__file__).parents[2] / "examples/tracked.toml"


def definition(path: Path) -> None:
    """Load the messages, decode some; and write them as a package, and import it."""
    own = {entry.code for service in load_own([path]).services for entry in service.messages}
    loaded = jauspy.load(path)
    for code in islice(own, 20):
        with contextlib.suppress(CodecError):
            loaded.decode(code.to_bytes(2, "little") + bytes(40))
    package = f"generated_{path.stem}"
    folder = path.resolve().parent / package
    for name, text in generate(load_own([path]), package, "jauspy.messages").items():
        target = (folder / name).resolve()
        if not target.is_relative_to(folder):
            raise RuntimeError(f"{target} would be written")
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text, encoding="utf-8")
    try:
        registry = import_module(package).registry
        for code in own:
            for entry in registry.entries_of(code):
                entry.load()
    finally:
        shutil.rmtree(folder)


def decode(path: Path) -> None:
    """Decode a capture, and explain its bytes."""
    sys.argv = ["jauspy", "decode", "--explain", str(path)]
    try:
        command()
    except SystemExit as ended:
        if ended.code not in (None, 0):
            raise JausError(f"ended with status {ended.code}") from None


def robot(path: Path) -> None:
    """Read the description and its URDF."""
    robot_files.robot_model(robot_files.load(path))


def urdf(path: Path) -> None:
    """Read the URDF of a robot."""
    robot_files.robot_model(robot_files.load(ROBOT).model_copy(update={"urdf": str(path)}))


def addresses(path: Path) -> None:
    """Read an address book."""
    load_address_book(path)


def node_manager(path: Path) -> None:
    """Read the configuration of a node manager, with its address books."""
    load_config(path).known_addresses()


def scan(path: Path) -> None:
    """Map with this scan: pairs of angle and distance, float32."""
    rays = list(struct.iter_unpack("<ff", path.read_bytes()))
    mapper = Mapper()
    for at in (0.0, 1.0, 2.0):
        mapper.add(PlanarPose(at, 0.0, 0.0), PlanarPose(), [angle for angle, _ in rays], [far for _, far in rays])


def users(path: Path) -> None:
    """Read the users of the console, and verify a password of each."""
    found = Users(path)
    for user in found:
        found.verified(user.name, "guessed")


def poses(path: Path) -> None:
    """Read named poses that are given to the console."""
    read_poses(path)


def saved(path: Path) -> None:
    """Read a trajectory that the console has saved; the poses, too, which have another form."""
    folder = path.resolve().parent / "state" / "101-inc1"
    (folder / "trajectories").mkdir(parents=True, exist_ok=True)
    for name in ("poses.json", "trajectories/x.json"):
        shutil.copy(path, folder / name)
    files = SavedFiles(101, "inc1", LOCAL, print, folder.parent)
    with contextlib.suppress(JausError):
        files.poses("101.1.104")
    files.trajectory(files.trajectories()[0])


READERS: Final[Mapping[str, Callable[[Path], None]]] = {
    each.__name__: each
    for each in (definition, decode, robot, urdf, addresses, node_manager, scan, users, poses, saved)
}


def main(kind: str, *files: str) -> int:
    """Read all files; 2 if one of them was refused."""
    sys.path.insert(0, str(Path.cwd()))
    status = 0
    for file in files:
        print(f"reading {file}", flush=True)
        begin = time.process_time()
        try:
            READERS[kind](Path(file))
        except JausError as error:
            print(f"refused: {error}"[:500], flush=True)
            status = 2
        print(f"took {time.process_time() - begin:.2f} s", flush=True)
    return status


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
