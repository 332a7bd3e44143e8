"""The backend `can`: servo drives with CiA 402 on a CAN bus (CANopen). Importing it needs no extra."""
