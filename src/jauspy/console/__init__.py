"""The operator's console: a web page that finds robots, drives them and shows their sensor data; an ordinary OCU."""
