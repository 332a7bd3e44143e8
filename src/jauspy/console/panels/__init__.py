"""The panels of the console's page, one file for each."""
