"""Simulated drives: real CANopen nodes, with the state machine of CiA 402, a motor and a load."""
