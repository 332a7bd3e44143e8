"""Attacks on running node managers, robots and commands, kept as a harness: `make attack`.

Each module of `attacks` is one attack. The runner gives it a fresh victim and an honest pair that talks all the while,
and measures what was lost (queries without an answer) and what leaked (memory, descriptors, tasks, log lines).
"""
