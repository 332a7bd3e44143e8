"""The contract with hardware and simulators, in SI units, and the backends that need nothing else."""
