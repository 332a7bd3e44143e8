"""Messages of exp, v1_1; loaded on use. Generated from schemas/; do not edit."""

from __future__ import annotations

from typing import TYPE_CHECKING

from jauspy.codec.registry import lazy

if TYPE_CHECKING:
    from jauspy.messages.exp.v1_1.component_physical_properties import (
        QueryMassProperties as QueryMassProperties, QueryShape as QueryShape,
        ReportMassProperties as ReportMassProperties, ReportShape as ReportShape,
    )
    from jauspy.messages.exp.v1_1.mount_site_properties import (
        QueryMountSite as QueryMountSite, ReportMountSite as ReportMountSite,
    )
    from jauspy.messages.exp.v1_1.passthrough_message import (
        QueryPassthroughMessageProperties as QueryPassthroughMessageProperties,
        ReportPassthroughMessageProperties as ReportPassthroughMessageProperties,
        SetPassthroughMessage as SetPassthroughMessage,
    )

__all__, __getattr__, __dir__ = lazy(__name__, {
    "jauspy.messages.exp.v1_1.component_physical_properties": "QueryMassProperties QueryShape ReportMassProperties ReportShape",
    "jauspy.messages.exp.v1_1.mount_site_properties": "QueryMountSite ReportMountSite",
    "jauspy.messages.exp.v1_1.passthrough_message": "QueryPassthroughMessageProperties ReportPassthroughMessageProperties SetPassthroughMessage",
})
