"""Trials of navigation: goals in simulated worlds, the drives there, and how many are reached without a touch."""
