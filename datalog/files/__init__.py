"""Rows in files: tab-separated facts, JSON, SQLite, and what `.input` and `.output` name."""
