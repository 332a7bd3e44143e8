"""Pictures of the simulated world: cameras, renderers, light and shadows."""
