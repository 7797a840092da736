"""Seeded bugs: declared, drawn, built into one program as switches, and judged by the gates and tests."""
