"""Rule programs: which files of rules an analysis runs, their variants, options and checks, and the tools of those who write rules."""
