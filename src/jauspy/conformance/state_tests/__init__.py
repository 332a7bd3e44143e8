"""Steps made from JSIDL: every state of a component's merged machine, and every input in it."""
