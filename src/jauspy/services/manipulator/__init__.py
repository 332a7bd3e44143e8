"""Services of the manipulator set (AS6057)."""
