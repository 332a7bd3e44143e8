"""The ways over Zenoh that `tools/bench/sites.py` compares, as settings of the prototype `_site_bridge.py`."""

from __future__ import annotations

import datetime
import ipaddress
import json
from pathlib import Path
from typing import Any, Final

PORT: Final = 7447
_QUICK: Final[dict[str, Any]] = {
    "transport/link/tx/lease": 2000,
    "connect/retry": {"period_init_ms": 200, "period_max_ms": 1000, "period_increase_factor": 2},
}
"""A dead link is noticed after 2 s instead of 10 s, and connected again within 1 s."""

WAYS: Final[dict[str, dict[str, Any]]] = {
    "zenoh-tcp": {"protocol": "tcp", "block": False},
    "zenoh-tcp-block": {"protocol": "tcp", "block": True},
    "zenoh-tcp-tuned": {"protocol": "tcp", "block": False, "options": "#so_sndbuf=16384", "config": _QUICK},
    "zenoh-udp": {"protocol": "udp", "block": False, "reliable": False, "config": _QUICK},
    "zenoh-quic": {"protocol": "quic", "block": False, "config": _QUICK},
}


def commands(way: str, roots: tuple[Path, Path], addresses: tuple[str, str]) -> list[list[str]]:
    """The commands of two bridges; that of the second site connects to the first."""
    settings = WAYS[way]
    endpoint = f"{settings['protocol']}/{addresses[0]}:{PORT}{settings.get('options', '')}"
    config = dict(settings.get("config", {}))
    if settings["protocol"] == "quic":
        config |= _certificate(roots[0], addresses[0])
    found = []
    for root, own, other, role in zip(roots, "ab", "ba", ("listen", "connect"), strict=True):
        bridge = {"root": str(root), "own": own, "other": other, role: endpoint, "config": config}
        bridge |= {"block": settings["block"], "reliable": settings.get("reliable", True)}
        found.append([str(Path(__file__).with_name("_site_bridge.py")), json.dumps(bridge)])
    return found


def _certificate(folder: Path, address: str) -> dict[str, Any]:
    """A certificate for this address that both sites trust."""
    from cryptography import x509  # noqa: PLC0415 - an extra
    from cryptography.hazmat.primitives import hashes, serialization  # noqa: PLC0415 - an extra
    from cryptography.hazmat.primitives.asymmetric import ec  # noqa: PLC0415 - an extra

    key = ec.generate_private_key(ec.SECP256R1())
    name = x509.Name([x509.NameAttribute(x509.NameOID.COMMON_NAME, "site")])
    now = datetime.datetime.now(datetime.UTC)
    certificate = (
        x509.CertificateBuilder()
        .subject_name(name)
        .issuer_name(name)
        .public_key(key.public_key())
        .serial_number(1)
        .not_valid_before(now - datetime.timedelta(days=1))
        .not_valid_after(now + datetime.timedelta(days=1))
        .add_extension(x509.SubjectAlternativeName([x509.IPAddress(ipaddress.ip_address(address))]), critical=False)
        .sign(key, hashes.SHA256())
    )
    private, public = folder / "key.pem", folder / "certificate.pem"
    private.write_bytes(
        key.private_bytes(serialization.Encoding.PEM, serialization.PrivateFormat.PKCS8, serialization.NoEncryption())
    )
    public.write_bytes(certificate.public_bytes(serialization.Encoding.PEM))
    return {
        "transport/link/tls/listen_private_key": str(private),
        "transport/link/tls/listen_certificate": str(public),
        "transport/link/tls/root_ca_certificate": str(public),
        "transport/link/tls/verify_name_on_connect": False,
    }
