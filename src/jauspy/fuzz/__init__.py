"""Fuzzing of the codec: valid random messages, mutated ones, and the invariants that are checked for each."""
