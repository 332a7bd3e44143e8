"""Guidance: from where the platform shall go to the efforts of its drive. No I/O, no clock, in JAUS axes."""
