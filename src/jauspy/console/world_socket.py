"""The connections that send the data of the tab World to browsers: geometry, state, map, scans and clouds."""

from __future__ import annotations

import asyncio
import json
from collections.abc import Awaitable, Callable, Mapping, Sequence
from typing import Final

from fastapi import FastAPI, HTTPException, WebSocket, WebSocketDisconnect
from starlette.responses import FileResponse

from jauspy.console.browser_messages import Refuse, messages, nothing
from jauspy.console.fleet_positions import FleetPositions
from jauspy.console.languages import sentence, translated
from jauspy.console.robot_geometry import RobotGeometry
from jauspy.console.world import RATE, World, known_cell
from jauspy.errors import JausError
from jauspy.ocu import OCU
from jauspy.ocu.robot import Robot
from jauspy.platform.modular.parts import CellSetup

MAX_CELLS: Final = 16
"""Cells that are kept, by the names of their robots."""
MAP_INTERVAL: Final = 1.0
"""Seconds between two maps to one browser."""
CLOUD_INTERVAL: Final = 0.5

Accept = Callable[[WebSocket, str], Awaitable[bool]]
"""Accepts the socket of a page with this token; False for an unknown token, whose socket is closed."""


class Worlds:
    """The worlds of all robots. Each is made when a browser first opens it, and closed with the last page that did."""

    def __init__(self, ocu: OCU, robots: Callable[[], Mapping[int, Robot]]) -> None:
        self.files: tuple[str, ...] = ()
        """Robot files (TOML) beside those that come with jauspy."""
        self.clouds: Mapping[int, Sequence[str]] = {}
        """Addresses of point clouds, by subsystem."""
        self._ocu = ocu
        self._robots = robots
        self.positions = FleetPositions(ocu, robots)
        """Where all robots are; asked for while a page shows one."""
        self._worlds: dict[int, World] = {}
        self._pages: dict[int, set[str]] = {}
        self._cells: dict[str, CellSetup | None] = {}

    def get(self, subsystem: int) -> World | None:
        """The world of a robot that a browser has opened."""
        return self._worlds.get(subsystem)

    async def cell(self, robot: Robot) -> CellSetup | None:
        """The cell around a robot whose file is on this machine; it is read once."""
        if robot.name not in self._cells:
            self._cells[robot.name] = await asyncio.to_thread(known_cell, robot.name, self.files)
            while len(self._cells) > MAX_CELLS:
                del self._cells[next(iter(self._cells))]
        return self._cells[robot.name]

    def opened(self, subsystem: int, token: str) -> World | None:
        """The world of a robot, for the page with this token; None when there is no such robot."""
        if subsystem not in self._worlds:
            if subsystem not in self._robots():
                return None
            world = World(self._ocu, lambda: self._robots().get(subsystem), self.files, self.clouds.get(subsystem, ()))
            self._worlds[subsystem] = world
        self._pages.setdefault(subsystem, set()).add(token)
        self.positions.start()
        return self._worlds[subsystem]

    async def forget(self, token: str) -> None:
        """Handle the end of a page; worlds that no page has open are closed."""
        for subsystem, pages in list(self._pages.items()):
            pages.discard(token)
            if not pages:
                del self._pages[subsystem]
                await self._worlds.pop(subsystem).close()
        if not self._pages:
            await self.positions.close()

    async def close(self) -> None:
        """End all. May be called twice."""
        for world in self._worlds.values():
            await world.close()
        self._worlds, self._pages = {}, {}
        await self.positions.close()


def add_world(
    app: FastAPI,
    worlds: Worlds,
    accept: Accept,
    is_page: Callable[[str], bool],
    *,
    refuse: Refuse,
    language_of: Callable[[str], str],
) -> None:
    """Add the socket, which is open while the tab is visible, and the files of meshes."""

    @app.websocket("/ws/world/{subsystem}/{token}")
    async def world(page: WebSocket, subsystem: int, token: str) -> None:
        if not await accept(page, token):
            return
        found, language = worlds.opened(subsystem, token), language_of(token)
        if found is None:
            await page.close(4404, translated(sentence("there is no such robot"), language))
            return
        await _serve(
            page, found, worlds.positions, f"/world/mesh/{subsystem}/{token}/", refuse=refuse, language=language
        )

    @app.get("/world/mesh/{subsystem}/{token}/{number}")
    async def mesh(subsystem: int, token: str, number: int) -> FileResponse:
        found = worlds.get(subsystem)
        if found is None or not is_page(token):
            raise HTTPException(404)
        meshes = (await found.geometry()).meshes
        if not 0 <= number < len(meshes) or not meshes[number].is_file():
            raise HTTPException(404)
        return FileResponse(meshes[number], headers={"Cache-Control": "private, max-age=3600"})


async def _serve(
    page: WebSocket, world: World, positions: FleetPositions, mesh_url: str, *, refuse: Refuse, language: str
) -> None:
    """Send until the browser leaves: a slow one gets fewer messages, never older ones."""
    watcher = object()
    leaving = asyncio.create_task(_until_closed(page, refuse))
    try:
        await world.watched_by(watcher)
        await _send_states(page, world, positions, mesh_url, leaving, language=language)
    except (WebSocketDisconnect, RuntimeError):
        return
    except JausError as error:
        await page.close(4404, str(error)[:100])
    finally:
        leaving.cancel()
        world.unwatched_by(watcher)


async def _send_states(
    page: WebSocket,
    world: World,
    positions: FleetPositions,
    mesh_url: str,
    leaving: asyncio.Task[None],
    *,
    language: str,
) -> None:
    clock = asyncio.get_running_loop().time
    before, notes = "", list[str]()
    track = map_version = scans = clouds = planned = way = 0
    map_due = cloud_due = 0.0
    shown: RobotGeometry | None = None
    while not leaving.done():
        began = clock()
        if shown is not (geometry := await world.geometry()):  # it changes with each new part
            shown = geometry
            model = geometry.for_browser(mesh_url)
            model["source"] = translated(geometry.source, language)
            await page.send_text(json.dumps({"model": model, "left_out": geometry.left_out}))
        state = world.state(track)
        track = world.track_total
        state.update(positions.for_browser(world.subsystem))
        if notes != (now := world.notes()):
            notes = now
            state["notes"] = [translated(note, language) for note in now]
        text = json.dumps(state, separators=(",", ":"))
        if text != before:
            await page.send_text(text)
            before = text
        if world.planned.version != planned:
            planned = world.planned.version
            await page.send_text(json.dumps({"ghost": world.ghost()}, separators=(",", ":")))
        if world.way.version != way:
            way = world.way.version
            await page.send_text(json.dumps({"way": world.way.message()}, separators=(",", ":")))
        if world.scans != scans:
            scans = world.scans
            await page.send_bytes(world.scan)
        if world.map_version != map_version and began >= map_due:
            map_version, map_due = world.map_version, began + MAP_INTERVAL
            if message := await world.map_message():
                await page.send_bytes(message)
        if world.clouds_total != clouds and began >= cloud_due:
            clouds, cloud_due = world.clouds_total, began + CLOUD_INTERVAL
            for cloud in list(world.clouds.values()):
                await page.send_bytes(cloud)
        await asyncio.wait({leaving}, timeout=max(0.0, began + 1.0 / RATE - clock()))


async def _until_closed(page: WebSocket, refuse: Refuse) -> None:
    async for _ in messages(page, nothing, refuse):
        pass  # a browser sends nothing here
