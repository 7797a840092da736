"""Integrators that are known to be right, weak or wrong, judged by `plumbline verify --integrator`."""
