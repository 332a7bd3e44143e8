"""Point clouds over nanomsg's publish and subscribe, outside of JAUS: they are large, frequent and soon outdated.

Publishing and subscribing need the extra `cloud` (pynng); the messages themselves need nothing.
"""
