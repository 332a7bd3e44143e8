"""The judge's test of 2015: what each part of it asks, and the table of its steps."""
