"""Made-up results as crowded as the largest real ones: a case of many lines, quantities and gates, limits of many integrators."""

import synthetic_results as made

LINES, QUANTITIES, GATES, INTEGRATORS, LIMITS = 12, 13, 60, 14, 30
CASE = "spring-mass"


def write(folder):
    """The usual folder, crowded."""
    made.write_all(folder, damaged=False)
    for line in range(LINES):
        measures = {f"angle-of-normals-{k}.max_error_in_degrees": made.measure(0.1 * k, 90.0 + k, 90.0, "deg") for k in range(QUANTITIES)}
        run = made.run_object(CASE, "default", 20, {"integrator": "energy", "shape": "quadratic", "arc": float(line)}, measures, points=10)
        made.write_run(folder, run, made.spring_profile(), "history")
    gates = [
        made.gate(CASE, "default", f"normals/angle-{k}", f"angle-of-normals-{k}.max_error_in_degrees at 20 cells", None, 1.0, "PASS", 0.1,
                  reason=f"a polygon of {k + 3} sides turns by as much from one side to the next, and no method without connections sees more")
        for k in range(GATES)
    ]  # fmt: skip
    made.write_verdicts(folder, [*made.all_gates(), *gates])
    document = made.stability_document()
    document["known_limits"] = [
        made._known(f"integrator-{k}", {}, [
            made._limit(f"problem-{n}", 0.1 + 0.05 * n, choices="contiguous-gimp apic, ppc 2, mass_ratio 0.02, placed 0.25", smallest=n == 0)
            for n in range(LIMITS)])
        for k in range(INTEGRATORS)
    ]  # fmt: skip
    made.write_stability(folder, document)
