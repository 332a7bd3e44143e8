"""The pictures that one query asked for, while they come."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Final, TypeAlias

from jauspy.messages.environment_sensing.v2_0.still_image import ReportStillImageDataExt
from jauspy.platform.video_settings import Still
from jauspy.services.deferred import Deferred

Record: TypeAlias = ReportStillImageDataExt.StillImageDataRec

NATIVE: Final = ReportStillImageDataExt.ReportCoordinateSystem.NATIVE


class Album:
    """Fulfils `answer` when nothing is missing; a camera without a picture is reported without one."""

    def __init__(
        self, sensors: Iterable[int], answer: Callable[[Callable[[], ReportStillImageDataExt]], Deferred]
    ) -> None:
        self._records = {sensor: Record(sensor, NATIVE) for sensor in sensors}
        self._missing = set(self._records)
        self.answer = answer(self.report)
        self._look()

    def report(self) -> ReportStillImageDataExt:
        """What is there."""
        return ReportStillImageDataExt(list(self._records.values()))

    def add(self, sensor: int, develop: Callable[[Still], Record], still: Still | None) -> None:
        """A camera is done."""
        if still is not None:
            self._records[sensor] = develop(still)
        self._missing.discard(sensor)
        self._look()

    def _look(self) -> None:
        if not self._missing:
            self.answer.set_result(self.report())
