"""Exports recordings to the formats of others: tables (CSV, Parquet), video (MP4), data sets for learning (LeRobot)."""
