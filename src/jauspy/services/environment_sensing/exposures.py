"""Still images under way: who wants the same one meanwhile gets it, too."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TypeAlias

from jauspy.errors import ConfigError
from jauspy.platform.video_settings import Still, StillSettings
from jauspy.services.environment_sensing.video_camera import Cameras

Then: TypeAlias = Callable[[Still | None], None]


class Exposures:
    """Has the cameras take pictures. Those that come to nothing are counted: `still_refused`, `still_lost`."""

    def __init__(self, cameras: Cameras, count: Callable[[str, str], None]) -> None:
        self._cameras, self._count = cameras, count
        self._waiting: dict[tuple[int, StillSettings], list[Then]] = {}

    def take(self, sensor: int, settings: StillSettings, then: Then) -> None:
        """Call `then` with the picture, or with None when there is none, now or later."""
        under_way = self._waiting.get((sensor, settings))
        if under_way is not None:
            under_way.append(then)
            return
        self._waiting[sensor, settings] = [then]
        try:
            self._cameras[sensor].source.take(settings, partial(self._taken, sensor, settings))
        except ConfigError as error:
            self._count("still_refused", f"sensor {sensor}: {error}")
            self._hand_out(sensor, settings, None)

    def _taken(self, sensor: int, settings: StillSettings, still: Still | None) -> None:
        if still is None:
            self._count("still_lost", f"sensor {sensor}: its process ended before the picture was taken")
        self._hand_out(sensor, settings, still)

    def _hand_out(self, sensor: int, settings: StillSettings, still: Still | None) -> None:
        for then in self._waiting.pop((sensor, settings), []):
            then(still)
