"""The error of drives that cannot be used."""

from jauspy.errors import JausError


class DriveFault(JausError):
    """Drives cannot be used. The text names the drive, its state, its error, and what to do."""
