"""urn:jauspy:operators:CommandSeal 1.0. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd
from jauspy.messages import registry as _registry

_SERVICE = jd.Service("urn:jauspy:operators:CommandSeal", "1.0")


@jd.message(_SERVICE, 0xDA50, command=True)
class SealedCommand(jd.Message):
    """SealedCommand (0xDA50): A command with the signature of the operator who gives it.

    operator_key: First eight bytes of the SHA-256 digest of the operator's public key, big endian
    destination: JAUS id of the component that the command is for
    source: JAUS id of the component that sends it
    challenge_time: The time of the challenge, as it was reported
    challenge_tag: The tag of the challenge, as it was reported
    elapsed: Milliseconds from the arrival of the challenge until the command was signed
    counter: 1..4294967295. Number of the command since the challenge, from 1
    command: JAUS MESSAGE. The command, with its message id
    signature: User defined. Ed25519 signature of the text jauspy SealedCommand 1 and all bytes before this field
    """
    operator_key: int = jd.field("OperatorKey", jd.Number("Q"))
    destination: int = jd.field("Destination", jd.Number("I"))
    source: int = jd.field("Source", jd.Number("I"))
    challenge_time: int = jd.field("ChallengeTime", jd.Number("Q"))
    challenge_tag: int = jd.field("ChallengeTag", jd.Number("Q"))
    elapsed: int = jd.field("Elapsed", jd.Number("I"))
    counter: int = jd.field("Counter", jd.Number("I", jd.Values(None, ((1, 4294967295),))))
    command: jd.Message | bytes = jd.field("Command", jd.Blob(jd.Count("I", 0, 2147483647), _registry))
    signature: bytes = jd.field("Signature", jd.Blob(jd.Count("B", 64, 64)))


@jd.message(_SERVICE, 0xFA50)
class ReportSealChallenge(jd.Message):
    """ReportSealChallenge (0xFA50): A challenge for the component that asks; it is another one each time.

    challenge_time: Microseconds of the clock of the component that reports
    challenge_tag: By it the component knows its own challenges again, which it does not keep
    """
    challenge_time: int = jd.field("ChallengeTime", jd.Number("Q"))
    challenge_tag: int = jd.field("ChallengeTag", jd.Number("Q"))


@jd.message(_SERVICE, 0xEA50, query=True)
class QuerySealChallenge(jd.Message):
    """QuerySealChallenge (0xEA50): Asks for the challenge that the next commands refer to."""
    REPORT = ReportSealChallenge


@jd.message(_SERVICE, 0xFA51)
class RejectCommand(jd.Message):
    """RejectCommand (0xFA51): Tells the sender of a command that it was not taken, and why.

    message_code: Message id of the command, of the one inside when it was sealed
    counter: Number of the sealed command; 0 for one without a seal
    reason: Reason. What is wrong with the command
    """

    class Reason(IntEnum):
        NO_SEAL = 0
        OTHER_DESTINATION = 1
        OTHER_SOURCE = 2
        UNKNOWN_OPERATOR = 3
        UNKNOWN_CHALLENGE = 4
        STALE = 5
        FORGED = 6
        REPLAYED = 7
        TOO_MANY_CLIENTS = 8
        ROLE_TOO_LOW = 9
        NOT_A_COMMAND = 10

    message_code: int = jd.field("MessageCode", jd.Number("H"))
    counter: int = jd.field("Counter", jd.Number("I"))
    reason: RejectCommand.Reason | int = jd.field("Reason", lambda: jd.Number("B", jd.Values(RejectCommand.Reason)))
