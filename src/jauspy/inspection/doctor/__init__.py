"""Why two parties do not talk: checks of this machine, of the network and of one component, each with its fix."""
