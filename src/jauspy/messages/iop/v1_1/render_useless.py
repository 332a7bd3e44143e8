"""urn:jaus:jss:iop:RenderUseless 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:RenderUseless", "1.1")


@jd.message(_SERVICE, 0xFFDA)
class ReportRenderUseless(jd.Message):
    """ReportRenderUseless (0xFFDA): Tells whether the component was made unusable; may be lost.

    state: State. Present state
    error_string: up to 255 characters. Text for people on why the command failed; empty in the states Normal and RenderedUseless
    """

    class State(IntEnum):
        NORMAL = 0
        RENDERED_USELESS = 1
        RENDER_USELESS_FAILED = 2

    state: ReportRenderUseless.State | int = jd.field("State", lambda: jd.Number("B", jd.Values(ReportRenderUseless.State)))
    error_string: str = jd.field("ErrorString", jd.Text(count=jd.Count("B", 0, 255)))


@jd.message(_SERVICE, 0xFFD9, query=True)
class QueryRenderUseless(jd.Message):
    """QueryRenderUseless (0xFFD9): Asks whether the component was made unusable; the answer may stay away."""
    REPORT = ReportRenderUseless


@jd.message(_SERVICE, 0xFFD7, command=True)
class RenderUseless(jd.Message):
    """RenderUseless (0xFFD7): Makes the addressed component unusable."""


@jd.message(_SERVICE, 0xFFD8)
class ConfirmRenderUselessRequest(jd.Message):
    """ConfirmRenderUselessRequest (0xFFD8): Acknowledges the command; may be lost if the component no longer works."""
