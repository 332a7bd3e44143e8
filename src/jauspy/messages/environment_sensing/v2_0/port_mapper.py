"""urn:jaus:jss:environmentSensing:PortMapper 2.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:environmentSensing:PortMapper", "2.0")


@jd.message(_SERVICE, 0x080B)
class CancelPortMapping(jd.Message):
    """CancelPortMapping (0x080B): Asks for a port to be closed.

    socket_type: SocketType. Transport protocol
    ip_addr: IPv4 address to be reached
    port: Port to be reached
    """

    class SocketType(IntEnum):
        UDP = 0
        TCP = 1

    socket_type: CancelPortMapping.SocketType | int = jd.field("SocketType", lambda: jd.Number("B", jd.Values(CancelPortMapping.SocketType)))
    ip_addr: int = jd.field("IPAddr", jd.Number("I"))
    port: int = jd.field("Port", jd.Number("H"))


@jd.message(_SERVICE, 0x080C)
class RequestPortMapping(jd.Message):
    """RequestPortMapping (0x080C): Asks for a port to be opened.

    socket_type: SocketType. Transport protocol
    ip_addr: IPv4 address to be reached
    port: Port to be reached
    """

    class SocketType(IntEnum):
        UDP = 0
        TCP = 1

    socket_type: RequestPortMapping.SocketType | int = jd.field("SocketType", lambda: jd.Number("B", jd.Values(RequestPortMapping.SocketType)))
    ip_addr: int = jd.field("IPAddr", jd.Number("I"))
    port: int = jd.field("Port", jd.Number("H"))


@jd.message(_SERVICE, 0x4815)
class ReportPortMappings(jd.Message):
    """ReportPortMappings (0x4815): Tells the open ports.

    request_port_mapping_rec: Address and port to be reached
    grant_port_mapping_rec: Address and port that stand for the requested ones
    """

    class SocketType(IntEnum):
        UDP = 0
        TCP = 1

    @jd.record()
    class RequestPortMappingRec(jd.Struct):
        """Address and port to be reached.

        socket_type: SocketType. Transport protocol
        ip_addr: IPv4 address to be reached
        port: Port to be reached
        """
        socket_type: ReportPortMappings.SocketType | int = jd.field("SocketType", lambda: jd.Number("B", jd.Values(ReportPortMappings.SocketType)))
        ip_addr: int = jd.field("IPAddr", jd.Number("I"))
        port: int = jd.field("Port", jd.Number("H"))

    @jd.record()
    class GrantPortMappingRec(jd.Struct):
        """Address and port that stand for the requested ones.

        ip_addr: IPv4 address that stands for the requested one
        port: Port that stands for the requested one
        """
        ip_addr: int = jd.field("IPAddr", jd.Number("I"))
        port: int = jd.field("Port", jd.Number("H"))

    request_port_mapping_rec: ReportPortMappings.RequestPortMappingRec = jd.field("RequestPortMappingRec", lambda: ReportPortMappings.RequestPortMappingRec.layout())
    grant_port_mapping_rec: ReportPortMappings.GrantPortMappingRec = jd.field("GrantPortMappingRec", lambda: ReportPortMappings.GrantPortMappingRec.layout())


@jd.message(_SERVICE, 0x2815, query=True)
class QueryPortMappings(jd.Message):
    """QueryPortMappings (0x2815): Asks for the open ports."""
    REPORT = ReportPortMappings


@jd.message(_SERVICE, 0x080E)
class GrantPortMapping(jd.Message):
    """GrantPortMapping (0x080E): Tells which address and port stand for the requested ones.

    request_port_mapping_rec: Address and port to be reached
    grant_port_mapping_rec: Address and port that stand for the requested ones
    """

    class SocketType(IntEnum):
        UDP = 0
        TCP = 1

    @jd.record()
    class RequestPortMappingRec(jd.Struct):
        """Address and port to be reached.

        socket_type: SocketType. Transport protocol
        ip_addr: IPv4 address to be reached
        port: Port to be reached
        """
        socket_type: GrantPortMapping.SocketType | int = jd.field("SocketType", lambda: jd.Number("B", jd.Values(GrantPortMapping.SocketType)))
        ip_addr: int = jd.field("IPAddr", jd.Number("I"))
        port: int = jd.field("Port", jd.Number("H"))

    @jd.record()
    class GrantPortMappingRec(jd.Struct):
        """Address and port that stand for the requested ones.

        ip_addr: IPv4 address that stands for the requested one
        port: Port that stands for the requested one
        """
        ip_addr: int = jd.field("IPAddr", jd.Number("I"))
        port: int = jd.field("Port", jd.Number("H"))

    request_port_mapping_rec: GrantPortMapping.RequestPortMappingRec = jd.field("RequestPortMappingRec", lambda: GrantPortMapping.RequestPortMappingRec.layout())
    grant_port_mapping_rec: GrantPortMapping.GrantPortMappingRec = jd.field("GrantPortMappingRec", lambda: GrantPortMapping.GrantPortMappingRec.layout())
