"""The services of each set, state by state and input by input, made from the JSIDL for what a target offers."""

from __future__ import annotations

from typing import Final

from jauspy.conformance.walk.plan import profile_of

CORE: Final = profile_of("core-1.1", "core services 1.1: every transition; shuts the target down", "core", "1.1")
MOBILITY: Final = profile_of("mobility-1.1", "mobility services 1.1: every transition", "mobility", "1.1")
MANIPULATOR: Final = profile_of("manipulator-2.0", "manipulator services 2.0: every transition", "manipulator", "2.0")
SENSING: Final = profile_of(
    "sensing-2.0", "environment sensing services 2.0: every transition", "environmentSensing", "2.0"
)
UGV: Final = profile_of("ugv-1.0", "UGV services 1.0: every transition", "ugv", "1.0")
