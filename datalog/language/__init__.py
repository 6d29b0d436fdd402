"""The language: from the text of rules to checked clauses."""
