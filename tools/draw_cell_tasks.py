"""Take pictures of the tasks of the factory cell, for docs/cell.md.

    python tools/draw_cell_tasks.py [-o FOLDER] [TASK ...]

runs each task and writes cell_TASK.jpg with its pictures side by side; `assemble` also cell.jpg, one picture for the
README. Needs GL (MUJOCO_GL=egl) and a minute for each task.
"""

from __future__ import annotations

import argparse
import asyncio
from collections.abc import Sequence
from pathlib import Path
from typing import Final, NamedTuple

from PIL import Image

from film_strip import COMPRESSION, side_by_side
from jauspy.cell.session import Session, simulated
from jauspy.cell.tasks import FILMED_BY, TASKS

TARGET: Final = Path(__file__).parents[1] / "docs" / "assets"
SIZE: Final = 1280, 720
WIDTH: Final = 640
COVER_WIDTH: Final = 960
SEED: Final = 7


class Plan(NamedTuple):
    """Seconds of the cell's time at which pictures are taken, and how many of them are beside each other."""

    times: tuple[float, ...]
    columns: int = 2


COVER: Final = "assemble", 2
"""The task, and the number of its picture, of cell.jpg."""

PLANS: Final = {
    "assemble": Plan((3.0, 20.0, 40.0, 61.0)),
    "lift": Plan((8.25, 10.5, 12.75, 14.25)),
    "step": Plan((7.0, 10.0, 14.0, 18.0)),
    "car": Plan((27.0, 63.0, 99.0, 117.0)),
}


async def take(session: Session, task: str, times: Sequence[float]) -> list[Image.Image]:
    """Run the task, and take a picture at each of these times. Raises `SystemExit` if the task fails or ends before."""
    camera = session.true.camera(FILMED_BY[task])
    assert camera is not None
    found: list[Image.Image] = []

    async def watch() -> None:
        view = camera.open()
        start = session.cell.now()
        for time in times:
            await session.cell.sleep(start + time - session.cell.now())
            found.append(Image.fromarray(view.look(*SIZE, thoroughly=True).image))
        view.close()

    async with asyncio.TaskGroup() as group:
        group.create_task(watch())
        measured = await TASKS[task](session, SEED)
    if not measured.success:
        raise SystemExit(f"{task}: {measured.failure}")
    return found


async def draw(task: str, folder: Path) -> None:
    """Write the picture of a task."""
    plan = PLANS[task]
    async with simulated(SEED) as session:
        pictures = await take(session, task, plan.times)
    if task == COVER[0]:
        side_by_side([pictures[COVER[1]]], 1, COVER_WIDTH).save(folder / "cell.jpg", **COMPRESSION)
    path = folder / f"cell_{task}.jpg"
    side_by_side(pictures, plan.columns, WIDTH).save(path, **COMPRESSION)
    print(f"{path}: {path.stat().st_size // 1000} kB")


def main() -> None:
    """Draw what was asked for."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tasks", nargs="*", metavar="TASK", help=f"{', '.join(PLANS)} (default: all)")
    parser.add_argument("-o", "--output", type=Path, default=TARGET, metavar="FOLDER")
    options = parser.parse_args()
    for task in options.tasks or PLANS:
        asyncio.run(draw(task, options.output))


if __name__ == "__main__":
    main()
