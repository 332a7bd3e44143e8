"""Virtual time: an event loop whose clock advances to the next timer, a network in memory, and robots stepped by both."""
