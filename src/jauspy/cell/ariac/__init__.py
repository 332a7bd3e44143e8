"""Trials in the style of NIST's ARIAC 2023: kitting orders with changes and faults, scored by its published rules."""
