"""Verbs of `jauspy schema`: read, check, compare and use JSIDL definitions."""
