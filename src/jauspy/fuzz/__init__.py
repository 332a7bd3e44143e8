"""Fuzzing of the codec: valid random messages and mutated ones, and the invariants that are checked for each."""
