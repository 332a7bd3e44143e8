"""How long a client waits for answers."""

from __future__ import annotations

from dataclasses import dataclass

from jauspy.arguments import check_number
from jauspy.errors import ConfigError


@dataclass(frozen=True, slots=True)
class RetryPolicy:
    """How long to wait for one answer (seconds), and how often to ask again; an answer to any of the questions counts.

    Of ten packets one may get lost: then a question and its answer fail once in 5 times, three in a row once in 150,
    which a program of many questions would see, and six once in 20,000.
    """

    timeout: float = 0.5
    retries: int = 5

    def __post_init__(self) -> None:
        check_number(self.timeout, "timeout")
        check_number(self.retries, "retries", whole=True)
        if not self.timeout > 0 or self.retries < 0:
            raise ConfigError(f"timeout {self.timeout} s must be above 0, retries {self.retries} must be 0 or more")

    @property
    def total(self) -> float:
        """Seconds until it is given up."""
        return self.timeout * (self.retries + 1)

    def changed(self, timeout: float | None, retries: int | None) -> RetryPolicy:
        """With what is given."""
        return RetryPolicy(self.timeout if timeout is None else timeout, self.retries if retries is None else retries)
