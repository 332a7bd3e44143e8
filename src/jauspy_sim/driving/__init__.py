"""What only the simulation knows of a drive: true heights, contacts, the way driven; and a depth camera of rays."""
