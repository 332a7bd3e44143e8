"""Message tables of the services that the Interoperability Profile (IOP) v3 and AEODRS add to JAUS."""
