"""How good the analysis is: ground truth, variants compared, expectations in sources, many workspaces at once."""
