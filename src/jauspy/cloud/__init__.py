"""Point clouds over nanomsg's publish and subscribe, beside JAUS: large, frequent, and of interest only while new.

Publishing and subscribing need the extra `cloud` (pynng); the messages themselves need nothing.
"""
