"""The MuJoCo backend of jauspy's platform contract."""
