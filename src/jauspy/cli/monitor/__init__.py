"""`jauspy monitor`: components and their messages on a full screen, live or from a capture."""
