"""Replays what recorded clients sent, to components of today, and compares the answers with the recorded ones."""
