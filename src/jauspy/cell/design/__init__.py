"""Choice of modules for a task: goals in CoBRA's format, a search for a chain that reaches them, and a checker."""
