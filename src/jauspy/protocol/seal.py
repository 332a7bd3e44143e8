"""The keys of operators (Ed25519), and the signed content of a sealed command. See docs/security.md.

The library `cryptography` is imported when a key is used: `pip install 'jauspy[operators]'`.
"""

from __future__ import annotations

import base64
import binascii
import hashlib
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Final

from jauspy.codec.message import Message
from jauspy.errors import ConfigError
from jauspy.ids import JausID
from jauspy.messages.operators import ReportSealChallenge, SealedCommand

if TYPE_CHECKING:
    from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey, Ed25519PublicKey

SIGNATURE_SIZE: Final = 64
DEFAULT_ROLES: Final[Mapping[str, int]] = {"observer": 0, "operator": 127, "supervisor": 255}
"""The highest authority that a person of each role may use; 0 may not command."""
_CONTEXT: Final = b"jauspy SealedCommand 1"
"""Signed before the message, so that no other use of the key gives a valid seal."""
_SIGNATURE_FIELD: Final = 1 + SIGNATURE_SIZE
"""The last bytes of a SealedCommand: the count of the signature's bytes, and these."""
_PREFIX: Final = "ed25519:"
_MAX_ELAPSED: Final = 0xFFFF_FFFF


class OperatorKey:
    """The private key of an operator."""

    def __init__(self, key: Ed25519PrivateKey) -> None:
        self._key = key
        self.public: Final = PublicKey(key.public_key().public_bytes_raw())

    @classmethod
    def generate(cls) -> OperatorKey:
        """A new key."""
        _require_library()
        from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey  # noqa: PLC0415 - an extra

        return cls(Ed25519PrivateKey.generate())

    @classmethod
    def from_pem(cls, pem: bytes) -> OperatorKey:
        """The key in a file; raises `ConfigError` for anything but an Ed25519 key in PEM without a password."""
        _require_library()
        from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PrivateKey  # noqa: PLC0415 - an extra
        from cryptography.hazmat.primitives.serialization import load_pem_private_key  # noqa: PLC0415 - an extra

        try:
            key = load_pem_private_key(pem, None)
        except Exception as error:  # whatever the library raises for what a file may have
            raise ConfigError("is not a private key in PEM; `jauspy keys new NAME` writes one") from error
        if not isinstance(key, Ed25519PrivateKey):
            raise ConfigError("is a key of another kind; `jauspy keys new NAME` writes one of Ed25519")
        return cls(key)

    def pem(self) -> bytes:
        """The content of a key file (PKCS 8)."""
        from cryptography.hazmat.primitives import serialization  # noqa: PLC0415 - an extra

        pem: bytes = self._key.private_bytes(
            serialization.Encoding.PEM, serialization.PrivateFormat.PKCS8, serialization.NoEncryption()
        )
        return pem

    def seal(
        self,
        command: Message,
        challenge: ReportSealChallenge,
        *,
        destination: JausID,
        source: JausID,
        elapsed: float,
        counter: int,
    ) -> SealedCommand:
        """The command with a seal for this destination. `elapsed`: seconds since the challenge arrived."""
        sealed = SealedCommand(
            operator_key=self.public.id,
            destination=int(destination),
            source=int(source),
            challenge_time=challenge.challenge_time,
            challenge_tag=challenge.challenge_tag,
            elapsed=min(int(elapsed * 1000), _MAX_ELAPSED),
            counter=counter,
            command=command.encode(),
            signature=bytes(SIGNATURE_SIZE),
        )
        return replace(sealed, signature=self._key.sign(_signed_part(sealed.encode())))


class PublicKey:
    """The public key of an operator; raises `ConfigError` for bytes that are none."""

    def __init__(self, raw: bytes) -> None:
        self.raw: Final = raw
        self.id: Final = int.from_bytes(hashlib.sha256(raw).digest()[:8], "big")
        """Identifies the key in sealed commands."""
        self._key = self._loaded(raw)

    @classmethod
    def parse(cls, text: str) -> PublicKey:
        """Parse the text that `str` returns."""
        encoded = text.removeprefix(_PREFIX)
        try:
            if encoded != text:
                return cls(base64.b64decode(encoded, validate=True))
        except binascii.Error:
            pass
        raise ConfigError(f"{text!r} is not a public key, as {_PREFIX}...; `jauspy keys show FILE` prints it")

    def __str__(self) -> str:
        return _PREFIX + base64.b64encode(self.raw).decode("ascii")

    def has_signed(self, payload: bytes) -> bool:
        """True for an encoded SealedCommand with a valid signature of this key."""
        from cryptography.exceptions import InvalidSignature  # noqa: PLC0415 - an extra

        try:
            self._key.verify(payload[-SIGNATURE_SIZE:], _signed_part(payload))
        except InvalidSignature:
            return False
        return True

    @staticmethod
    def _loaded(raw: bytes) -> Ed25519PublicKey:
        _require_library()
        from cryptography.hazmat.primitives.asymmetric.ed25519 import Ed25519PublicKey  # noqa: PLC0415 - an extra

        try:
            return Ed25519PublicKey.from_public_bytes(raw)
        except ValueError as error:
            raise ConfigError(
                f"a public key has 32 bytes, not {len(raw)}; `jauspy keys show FILE` prints it"
            ) from error


@dataclass(frozen=True, slots=True, eq=False)
class Operator:
    """A person, or a program, that may command; `authority` is the highest of JAUS it may use, 0 for none."""

    name: str
    role: str
    authority: int
    key: PublicKey


def _signed_part(payload: bytes) -> bytes:
    return _CONTEXT + payload[:-_SIGNATURE_FIELD]


def _require_library() -> None:
    try:
        import cryptography  # noqa: F401, PLC0415 - an extra
    except ImportError as error:
        raise ConfigError("keys of operators need the extra 'operators': pip install 'jauspy[operators]'") from error
