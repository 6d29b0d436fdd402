"""Ground truth, scores, and variants of the analysis compared over many subjects."""
