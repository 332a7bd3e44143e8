"""The tasks of the modular factory cell: a client of JAUS like any other."""
