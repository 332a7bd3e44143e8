"""The `jauspy` command: one module per verb. Verbs import what they need when they run, so that `--help` is quick."""
