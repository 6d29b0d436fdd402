"""What only a run can show: recordings, live graphs and experiments, compared with what the rules derive from sources."""
