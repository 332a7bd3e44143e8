"""Virtual time: an event loop that does not wait, a network in memory, and robots that are stepped by the loop."""
