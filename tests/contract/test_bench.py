"""plumbline bench: the document, complete. Speeds are printed as met or missed; no test fails on time."""


def test_bench(plumbline):
    result = plumbline("bench", json=True, timeout=200)
    assert result.code == 0
    kernels = result.json()["kernels"]
    assert all(kernel["threads"] == 1 for kernel in kernels)
    assert all(kernel["energy_drift"] is not None for kernel in kernels)
