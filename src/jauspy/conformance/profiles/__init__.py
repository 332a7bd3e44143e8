"""The profiles that come with jauspy."""
