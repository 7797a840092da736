"""Reads and makes results of Plumbline, the verification and validation harness of the Material Point Method."""
