"""Findings: what checks report, and what becomes of it by policy, baseline, suppressions and configuration."""
