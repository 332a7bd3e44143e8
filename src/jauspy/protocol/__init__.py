"""AS5669A without I/O: header, framing, the Junior local protocol, addresses and routing."""
