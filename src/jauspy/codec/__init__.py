"""Messages to bytes and back: the generator, what generated code needs at run time, and the construct reference."""
