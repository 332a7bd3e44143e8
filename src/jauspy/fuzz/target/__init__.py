"""Fuzzing of a running component or node manager: state walk, damaged messages, liveness, minimised findings."""
