"""Recording traffic: as pcapng, and as MCAP, which explains itself and opens in Foxglove."""
