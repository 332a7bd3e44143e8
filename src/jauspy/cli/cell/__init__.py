"""`jauspy cell`: the tasks of the modular factory cell."""
