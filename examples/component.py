"""A component with a service of the standard: PlatformSpecifications (AS6091), the size and mass of a platform."""

import sys

import jauspy
from jauspy.messages.ugv import ReportPlatformSpecifications as Report


class Specifications(jauspy.Service, urn="urn:jaus:jss:ugv:PlatformSpecifications"):
    """If a method is missing, `jauspy.Component` raises `ConfigError` with the expected signature."""

    def send_report_platform_specifications(self) -> Report:
        return Report(
            platform_specifics=Report.Skidsteer(track_separation=0.4),  # metres
            platform_inertial=Report.PlatformInertial(maximum_forward_speed=1.5),  # m/s
            platform_spec=Report.PlatformSpec(
                mobility_platform_name="example",
                front=0.35,  # metres from the origin of the platform's frame
                back=0.35,
                right=0.25,
                left=0.25,
                bottom=0.1,
                top=0.3,
                vehicle_weight=38.0,  # kg
            ),
        )


if __name__ == "__main__":
    connect = sys.argv[1] if len(sys.argv) > 1 else None
    jauspy.run(jauspy.Component("101.1.121", [Specifications()], name="specifications", connect=connect))
