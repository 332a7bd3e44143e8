"""Which views of the page are beside each other, how large, and which panels are put away; as text for the browser."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import Annotated, Final

from pydantic import BaseModel, ConfigDict, Field, ValidationError

MAX_PANES: Final = 2
"""Views above each other in a column, and columns."""
MIN_SHARE: Final = 0.15
"""Least share of the width or height that a view keeps."""
MAX_TEXT: Final = 1000
"""Characters of an arrangement that a browser sends."""
WORLD_VIEWS: Final = ("both", "three", "map")
_Name = Annotated[str, Field(pattern=r"^[A-Za-z -]{1,20}$")]
_Share = Annotated[float, Field(ge=MIN_SHARE, le=1.0 - MIN_SHARE, allow_inf_nan=False)]
_Column = Annotated[list[_Name], Field(min_length=1, max_length=MAX_PANES)]


class Arrangement(BaseModel):
    """The views in columns from left to right, each from top to bottom; without columns one view is shown, by its tab.

    `width` is the share of the left column, `heights` are those of the upper view of each column.
    """

    model_config = ConfigDict(extra="forbid", frozen=True)
    columns: Annotated[list[_Column], Field(max_length=MAX_PANES)] = []
    width: _Share = 0.6
    heights: tuple[_Share, _Share] = (0.6, 0.6)
    world: Annotated[str, Field(pattern=r"^(both|three|map)$")] = "both"
    """What the view World shows."""
    away: Annotated[list[_Name], Field(max_length=16)] = []
    """Panels that are put away."""

    @property
    def views(self) -> list[str]:
        """The views, column by column."""
        return [view for column in self.columns for view in column]

    def offered(self, views: Collection[str]) -> list[list[str]]:
        """The columns with these views only; columns without any are left out."""
        columns = [[view for view in column if view in views] for column in self.columns]
        return [column for column in columns if column]

    def swapped(self, one: str, other: str) -> Arrangement:
        """Two views at each other's place."""
        places = {one: other, other: one}
        return self.model_copy(update={"columns": [[places.get(view, view) for view in col] for col in self.columns]})

    def replaced(self, old: str, new: str) -> Arrangement:
        """Another view in place of one; the two change places if both are shown."""
        if new in self.views:
            return self.swapped(old, new)
        return self.model_copy(update={"columns": [[new if view == old else view for view in c] for c in self.columns]})

    def moved(self, view: str) -> Arrangement:
        """A view at the place of the next one, in the order of `views`."""
        views = self.views
        return self.swapped(view, views[(views.index(view) + 1) % len(views)]) if view in views else self

    def added(self, view: str) -> Arrangement:
        """One more view, where there is room; in place of the last one if there is none."""
        if view in self.views:
            return self
        columns = [list(column) for column in self.columns]
        shortest = min(columns, key=len, default=[])
        if len(columns) < MAX_PANES:
            columns.append([view])
        elif len(shortest) < MAX_PANES:
            shortest.append(view)
        else:
            columns[-1][-1] = view
        return self.model_copy(update={"columns": columns})

    def without(self, view: str) -> Arrangement:
        """One view less."""
        columns = [[each for each in column if each != view] for column in self.columns]
        return self.model_copy(update={"columns": [column for column in columns if column]})

    def resized(self, split: str, share: float) -> Arrangement:
        """Another share of the left column (`width`), or of the upper view of the `left` or `right` column."""
        share = min(1.0 - MIN_SHARE, max(MIN_SHARE, share))
        if split == "width":
            return self.model_copy(update={"width": share})
        left, right = self.heights
        return self.model_copy(update={"heights": (share, right) if split == "left" else (left, share)})

    def put_away(self, panel: str, *, away: bool) -> Arrangement:
        """A panel put away, or shown again."""
        others = [name for name in self.away if name != panel]
        return self.model_copy(update={"away": [*others, panel] if away else others})

    def text(self) -> str:
        """The arrangement as the browser keeps it."""
        return self.model_dump_json()


PRESETS: Final = {
    "one view": Arrangement(),
    "drive": Arrangement(columns=[["Video"], ["World"]], width=0.62, world="map", away=["Fleet", "Arm", "Gripper"]),
    "arm": Arrangement(
        columns=[["Video"], ["World"]], width=0.55, world="three", away=["Fleet", "Drive", "Guards", "Link"]
    ),
    "observe": Arrangement(
        columns=[["Video", "Events"], ["World"]],
        heights=(0.8, 0.6),
        world="map",
        away=["Drive", "Guards", "Arm", "Gripper"],
    ),
}
"""Arrangements for a task; keys 1 to 4 in this order."""


def arrangement_of(text: object, known: Sequence[str]) -> Arrangement | None:
    """The arrangement that a browser has kept; None for anything else, as one with views that the page does not have.

    No view is shown twice.
    """
    if not isinstance(text, str) or len(text) > MAX_TEXT:
        return None
    try:
        found = Arrangement.model_validate_json(text)
    except ValidationError:
        return None
    views = found.views
    return found if len(set(views)) == len(views) and set(views) <= set(known) else None
