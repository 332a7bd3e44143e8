"""Recorded traffic: reading captures, writing pcapng, and the JAUS content of datagrams."""
