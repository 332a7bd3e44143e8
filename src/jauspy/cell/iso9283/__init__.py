"""Performance by ISO 9283 of the UR10 and of the modular arm: characteristics, the measurement, results, the report."""
