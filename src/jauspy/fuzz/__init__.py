"""Fuzzing: bytes that nobody would send on purpose, and what must hold for them all the same."""
