"""Where thrown boxes come to rest that land with small errors of their attitude: `python tools/landings.py`.

Prints for each lean (degrees forward) where the middle of the boxes lies beyond the landing, and within what distance
of it half and nine tenths of them rest, for both sides ahead.
"""

from __future__ import annotations

import argparse
import math
from typing import Final

import mujoco
import numpy as np

WORLD: Final = """
<mujoco>
  <option timestep="0.00025" integrator="implicitfast" cone="elliptic" impratio="10"/>
  <worldbody>
    <geom type="plane" size="9 9 0.1" solref="0.005 1" friction="0.6 0.005 0.0001"/>
    <body pos="0 0 1">
      <freejoint/>
      <geom type="box" size="{x} {y} 0.05" mass="0.3" solref="0.0006 1" friction="0.6 0.005 0.0001" solmix="1000"/>
    </body>
  </worldbody>
</mujoco>
"""
"""Floor and box as in the cell, with its shortest physics steps."""
LEANS: Final = (-2.0, 0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0)
SPEED: Final = (3.1, -5.0)
"""m/s ahead and up at the landing."""
SPIN: Final = 6.3
"""rad/s forward."""


def rest(model: mujoco.MjModel, half: np.ndarray, forward: float, left: float) -> np.ndarray:
    """Where a box comes to rest beyond its landing, x and y in metres; it leans forward and left, in radians."""
    data = mujoco.MjData(model)
    pitch, roll, turn, flat = np.zeros(4), np.zeros(4), np.zeros(4), np.zeros(9)
    mujoco.mju_axisAngle2Quat(pitch, np.array([0.0, 1.0, 0.0]), forward)
    mujoco.mju_axisAngle2Quat(roll, np.array([1.0, 0.0, 0.0]), left)
    mujoco.mju_mulQuat(turn, pitch, roll)
    mujoco.mju_quat2Mat(flat, turn)
    rotation = flat.reshape(3, 3)
    data.qpos[:] = [0.0, 0.0, np.abs(rotation[2]) @ half + 0.0005, *turn]
    data.qvel[:3] = [SPEED[0], 0.0, SPEED[1]]
    data.qvel[3:] = rotation.T @ np.array([0.0, SPIN, 0.0])
    for step in range(4000):
        mujoco.mj_step(model, data)
        if not step % 100 and np.abs(data.qvel).max() < 0.01:
            break
    return np.array(data.qpos[:2])


def main() -> None:
    """Simulate, and print a table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--boxes", type=int, default=30)
    parser.add_argument("--forward", type=float, default=0.5, help="standard deviation of the lean, degrees")
    parser.add_argument("--left", type=float, default=0.1, help="standard deviation of the lean to the side, degrees")
    asked = parser.parse_args()
    errors = np.random.default_rng(0).normal(size=(asked.boxes, 2))
    print("ahead    lean  beyond   half  nine tenths  (degrees, mm)")
    for name, x, y in (("shorter", 0.06, 0.08), ("longer", 0.08, 0.06)):
        model, half = mujoco.MjModel.from_xml_string(WORLD.format(x=x, y=y)), np.array([x, y, 0.05])
        for lean in LEANS:
            rows = [
                rest(model, half, math.radians(lean + asked.forward * a), math.radians(asked.left * b))
                for a, b in errors
            ]
            middle = np.median(rows, axis=0)
            off = 1000.0 * np.linalg.norm(np.array(rows) - middle, axis=1)
            most = np.percentile(off, 90)
            print(f"{name:8} {lean:4.0f}  {1000.0 * middle[0]:6.0f} {np.median(off):6.0f} {most:12.0f}", flush=True)


if __name__ == "__main__":
    main()
