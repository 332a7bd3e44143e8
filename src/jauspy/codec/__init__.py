"""Encoding and decoding of messages: the generator, its run-time support, and the reference codec."""
