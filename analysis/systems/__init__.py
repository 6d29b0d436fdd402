"""From launch files and components to composed systems: what starts together, what a workspace has, which node has which configuration."""
