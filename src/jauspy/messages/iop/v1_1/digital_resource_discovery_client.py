"""urn:jaus:jss:iop:DigitalResourceDiscoveryClient 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.messages.iop.v1_1 import digital_resource_discovery as iop_v1_1_digital_resource_discovery


class ReportDigitalResourceEndpoint(iop_v1_1_digital_resource_discovery.ReportDigitalResourceEndpoint):
    """ReportDigitalResourceEndpoint (0xF702): Tells where streams and files are to be fetched."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:DigitalResourceDiscoveryClient"
    VERSION = "1.1"


class ConfirmDigitalResourceEndpoint(iop_v1_1_digital_resource_discovery.ConfirmDigitalResourceEndpoint):
    """ConfirmDigitalResourceEndpoint (0xF703): Tells the number under which a stream or file was entered."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:DigitalResourceDiscoveryClient"
    VERSION = "1.1"


class QueryDigitalResourceEndpoint(iop_v1_1_digital_resource_discovery.QueryDigitalResourceEndpoint):
    """QueryDigitalResourceEndpoint (0xE702): Asks where streams and files are to be fetched."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:DigitalResourceDiscoveryClient"
    VERSION = "1.1"


class RegisterDigitalResourceEndpoint(iop_v1_1_digital_resource_discovery.RegisterDigitalResourceEndpoint):
    """RegisterDigitalResourceEndpoint (0xE703): Enters a stream or file into the list."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:DigitalResourceDiscoveryClient"
    VERSION = "1.1"


class RemoveDigitalResourceEndpoint(iop_v1_1_digital_resource_discovery.RemoveDigitalResourceEndpoint):
    """RemoveDigitalResourceEndpoint (0xE704): Removes a stream or file from the list."""

    __slots__ = ()
    SERVICE = "urn:jaus:jss:iop:DigitalResourceDiscoveryClient"
    VERSION = "1.1"


