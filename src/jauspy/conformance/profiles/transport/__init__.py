"""What is sent packet by packet, and the table of all steps."""
