"""jauspy without `await`: an event loop in a thread does the waiting."""
