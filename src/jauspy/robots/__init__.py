"""Descriptions of the robots that come with jauspy, one TOML file each."""
