"""The capability modules: which services each offers, on which robot, and how a whole robot runs."""
