"""JAUS services without I/O: the state-machine engine, and what each service does."""
