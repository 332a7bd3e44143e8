"""Makes a self-signed certificate for the console, for users without a certificate authority."""

from __future__ import annotations

import ipaddress
import os
import ssl
from datetime import UTC, datetime, timedelta
from pathlib import Path
from typing import Final

from cryptography import x509
from cryptography.hazmat.primitives import hashes, serialization
from cryptography.hazmat.primitives.asymmetric import ec
from cryptography.x509.oid import ExtendedKeyUsageOID, NameOID

from jauspy.errors import ConfigError

VALIDITY: Final = timedelta(days=365)


def make_certificate(names: list[str], certificate: Path, key: Path) -> str:
    """Write a certificate for these host names and addresses and its key; returns its fingerprint (SHA-256)."""
    private = ec.generate_private_key(ec.SECP256R1())
    subject = x509.Name([x509.NameAttribute(NameOID.COMMON_NAME, "jauspy console")])
    now = datetime.now(UTC)
    made = (
        x509.CertificateBuilder()
        .subject_name(subject)
        .issuer_name(subject)
        .public_key(private.public_key())
        .serial_number(x509.random_serial_number())
        .not_valid_before(now - timedelta(minutes=5))
        .not_valid_after(now + VALIDITY)
        .add_extension(x509.SubjectAlternativeName([_general_name(name) for name in names]), critical=False)
        .add_extension(x509.BasicConstraints(ca=False, path_length=None), critical=True)
        .add_extension(x509.ExtendedKeyUsage([ExtendedKeyUsageOID.SERVER_AUTH]), critical=False)
        .sign(private, hashes.SHA256())
    )
    pem = private.private_bytes(
        serialization.Encoding.PEM, serialization.PrivateFormat.PKCS8, serialization.NoEncryption()
    )
    _write_new(key, pem, 0o600)
    _write_new(certificate, made.public_bytes(serialization.Encoding.PEM), 0o644)
    return made.fingerprint(hashes.SHA256()).hex(":").upper()


def check_certificate(certificate: Path, key: Path) -> None:
    """Raise `ConfigError` when TLS cannot use these files."""
    for path in (certificate, key):
        if not path.is_file():
            raise ConfigError(f"{path}: there is no such file; make both: jauspy console certificate HOST-OR-ADDRESS")
    try:
        ssl.create_default_context(ssl.Purpose.CLIENT_AUTH).load_cert_chain(certificate, key, password="")  # nosec B106 # none
    except (ssl.SSLError, OSError) as error:
        raise ConfigError(f"--certificate {certificate} and --key {key} do not fit: {error}") from error


def _general_name(name: str) -> x509.GeneralName:
    try:
        return x509.IPAddress(ipaddress.ip_address(name))
    except ValueError:
        pass
    try:
        return x509.DNSName(name.encode("idna").decode())
    except UnicodeError as error:
        raise ConfigError(f"{name!r} is neither an IP address nor a host name") from error


def _write_new(path: Path, data: bytes, mode: int) -> None:
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with os.fdopen(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, mode), "wb") as stream:
            stream.write(data)
    except FileExistsError as error:
        raise ConfigError(f"{path} exists; a new one would replace it, so remove it or choose --output") from error
    except OSError as error:
        raise ConfigError(f"cannot write {path}: {error.strerror}") from error
