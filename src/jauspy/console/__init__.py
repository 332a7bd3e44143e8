"""The operator's console: a web page that finds robots, drives them and shows what they see. An OCU like any other."""
