"""What only a run can tell: recordings, live graphs and experiments, compared with what the rules derive from sources."""
