"""Recorded traffic: UDP datagrams out of capture files and hex text, and what JAUS says in them."""
