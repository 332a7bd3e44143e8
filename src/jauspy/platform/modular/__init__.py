"""Modular robots: servo modules, vacuum connectors, and the arms and vehicles that are assembled from them."""
