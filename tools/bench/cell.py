"""How fast the factory cell is simulated, beside bare MuJoCo on the same model in the same run.

python tools/bench/cell.py [--seconds S] [--film]

All parts are in the cell, the arm of five joints is assembled, the UR10, that arm and the conveyor move. The motor
torques of the run are then replayed with bare MuJoCo, from the same state and to the same end: the reference.
Real-time factors are simulated seconds for a second of this process's CPU time; beside other load the clock says less.
With --film the cell runs on the clock while another process films it, 1280x720 at 25 pictures a second, as H.264.
"""

from __future__ import annotations

import argparse
import multiprocessing
import tempfile
import time
from collections.abc import Callable
from dataclasses import replace
from multiprocessing.synchronize import Event
from pathlib import Path

import mujoco
import numpy as np
from numpy.typing import NDArray

from jauspy.cell.modular_arm import FIVE_JOINTS
from jauspy.platform.camera import CameraSource
from jauspy.platform.contract import Snapshot
from jauspy.platform.joints import ControlMode, Target
from jauspy.platform.modular.arm import ModularArm
from jauspy.platform.modular.cell import Conveyor
from jauspy.robot import robot_files
from jauspy.worker_process import lower_priority
from jauspy_sim.assembly import TIMESTEP
from jauspy_sim.cell.robot import SimulatedCell

RATE = 25
SIZE = 1280, 720
NICENESS = 10
"""Of the process that films, as those of cameras have it: physics comes first."""
HALF_MOTION = 1.5
"""Seconds from one end of the arms' motions to the other."""

UR10_ENDS = (-1.0, -1.6, 1.9, -1.9, -1.4, 0.4), (-2.3, -2.0, 2.2, -1.7, -1.7, -0.4)
ARM_ENDS = (0.8, 0.4, 0.6, 0.5, 0.5), (-0.2, -0.3, 0.3, -0.4, -0.5)


def open_cell() -> SimulatedCell:
    """The included cell with parts off by 10 mm and 5 degrees, and its arm assembled."""
    model = robot_files.robot_model(robot_files.load("cell"))
    assert model.cell is not None
    setup = replace(model.cell, pose_error=(0.01, 0.087), seed=1)
    cell = SimulatedCell.open(replace(model, cell=setup), "cell")
    cell.prepare("platform_1/top", FIVE_JOINTS)
    return cell


class Commands:
    """Moves both arms to and fro, and runs the conveyor."""

    def __init__(self, cell: SimulatedCell) -> None:
        self._cell = cell
        arm, conveyor = ModularArm.of(cell), Conveyor.of(cell)
        assert arm is not None
        assert conveyor is not None
        self._arm = arm
        conveyor.set_speed(0.02)
        self._due, self._turns = cell.time, 0

    def update(self) -> None:
        """Begin the next motion when it is time to."""
        if self._cell.time < self._due:
            return
        end = self._turns % 2
        self._cell.groups["ur10"].command([Target(ControlMode.POSITION, each) for each in UR10_ENDS[end]])
        self._arm.move(ARM_ENDS[end], HALF_MOTION - 0.1)
        self._due += HALF_MOTION
        self._turns += 1


def factor(seconds: float, run: Callable[[], object]) -> float:
    """Simulated seconds for a second of CPU time."""
    start = time.process_time()
    run()
    return seconds / (time.process_time() - start)


def run_steps(cell: SimulatedCell, seconds: float, after: Callable[[], object] = lambda: None) -> None:
    """Advance step by step, with commands."""
    commands = Commands(cell)
    for _ in range(round(seconds / TIMESTEP)):
        commands.update()
        cell.advance(TIMESTEP)
        after()


class Recording:
    """The inputs of each step of a run, and the states at its ends."""

    def __init__(self, seconds: float) -> None:
        self.cell = cell = open_cell()
        self.model = cell.model
        self.before = mujoco.MjData(cell.model)
        mujoco.mj_copyData(self.before, cell.model, cell.data)
        self.inputs: list[tuple[NDArray[np.float64], NDArray[np.float64]]] = []
        belt = cell.model.joint("belt")
        self.belt = int(belt.qposadr[0])
        commands, drive = Commands(cell), int(cell.model.actuator("belt").id)
        for _ in range(round(seconds / TIMESTEP)):
            speed = cell.data.ctrl[drive]  # set after a step, the motors before it
            commands.update()
            cell.advance(TIMESTEP)
            control = cell.data.ctrl.copy()
            control[drive] = speed
            self.inputs.append((control, cell.data.qfrc_applied.copy()))

    def replay(self, *, sleep: bool = True) -> mujoco.MjData:
        """Step bare MuJoCo with the same inputs."""
        model, data = self.model, mujoco.MjData(self.model)
        mujoco.mj_copyData(data, model, self.before)
        flag = int(mujoco.mjtEnableBit.mjENBL_SLEEP)
        model.opt.enableflags = model.opt.enableflags | flag if sleep else model.opt.enableflags & ~flag
        qpos, ctrl, applied, belt = data.qpos, data.ctrl, data.qfrc_applied, self.belt
        for control, force in self.inputs:
            ctrl[:], applied[:] = control, force
            mujoco.mj_step(model, data)
            qpos[belt] = 0.0
        model.opt.enableflags |= flag
        return data


def film(camera: CameraSource, path: Path, ready: Event, stop: Event) -> None:
    """Film in a process of its own until `stop`; then append the number of pictures to the file's name."""
    import av  # noqa: PLC0415 - of the extra video

    lower_priority(NICENESS)
    session = camera.open()
    session.look(*SIZE)
    pictures = 0
    with av.open(str(path), "w") as container:
        stream = container.add_stream("libx264", rate=RATE)
        stream.width, stream.height = SIZE
        stream.pix_fmt, stream.options = "yuv420p", {"preset": "ultrafast"}
        ready.set()
        due = time.monotonic()
        while not stop.is_set():
            frame = av.VideoFrame.from_ndarray(session.look(*SIZE).image, format="rgb24")
            frame.pts = pictures
            container.mux(stream.encode(frame))
            pictures += 1
            due = max(due + 1.0 / RATE, time.monotonic() - 1.0 / RATE)
            stop.wait(max(0.0, due - time.monotonic()))
        container.mux(stream.encode())
    path.with_suffix(".count").write_text(str(pictures))
    session.close()


def measure_film(seconds: float) -> None:
    """Run on the clock beside a process that films."""
    cell = open_cell()
    context = multiprocessing.get_context("fork")  # a child that inherits the descriptor of the state
    ready, stop = context.Event(), context.Event()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "film.mp4"
        process = context.Process(target=film, args=(cell.cameras["overview"], path, ready, stop))
        process.start()
        ready.wait(60.0)
        commands = Commands(cell)
        start = time.monotonic()
        late = 0
        for number in range(round(seconds / TIMESTEP)):
            commands.update()
            cell.advance(TIMESTEP)
            Snapshot.of(cell)
            ahead = start + (number + 1) * TIMESTEP - time.monotonic()
            late += ahead < -0.02
            time.sleep(max(0.0, ahead))
        taken = time.monotonic() - start
        stop.set()
        process.join(30.0)
        pictures = int(path.with_suffix(".count").read_text())
    print(f"on the clock, filmed: real-time factor {seconds / taken:.2f}, {late} steps more than 20 ms late,")
    print(f"                      {pictures / taken:.1f} pictures of {SIZE[0]}x{SIZE[1]} a second")
    cell.close()


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=6.0)
    parser.add_argument("--film", action="store_true")
    arguments = parser.parse_args()
    seconds = arguments.seconds
    recording = Recording(seconds)
    broken = [each.state().last_error for each in recording.cell.connectors.values() if each.state().broken_off]
    if broken:
        raise SystemExit(f"the arm came apart: {broken}")
    end = recording.replay()
    same = bool(np.array_equal(end.qpos, recording.cell.data.qpos))
    loose = sum(not part.fixed for part in recording.cell.setup.parts)
    print(f"{loose} loose parts, {recording.model.nv} degrees of freedom; both arms and the conveyor move")
    bare = factor(seconds, recording.replay)
    own = open_cell()
    cell = factor(seconds, lambda: run_steps(own, seconds))
    own = open_cell()
    snapshots = factor(seconds, lambda: run_steps(own, seconds, lambda: Snapshot.of(own)))
    awake = factor(seconds, lambda: recording.replay(sleep=False))
    print(f"bare MuJoCo:                           real-time factor {bare:5.1f}  (ends in the same state: {same})")
    print(f"the cell, control included:            real-time factor {cell:5.1f}  {cell / bare:.2f} of bare MuJoCo")
    print(f"with a snapshot of all states a step:  real-time factor {snapshots:5.1f}  {snapshots / bare:.2f}")
    print(f"bare MuJoCo without sleeping islands:  real-time factor {awake:5.1f}  {awake / bare:.2f}")
    if arguments.film:
        measure_film(seconds)


if __name__ == "__main__":
    main()
