"""The manufactured solutions in 40-digit arithmetic, from the displacement and the stress law alone.

Velocity, acceleration, deformation and the divergence of the stress come from numerical derivatives of high precision
(central differences, truncation below 1e-20), so nothing is shared with the closed forms under test.
"""
import mpmath

mp = mpmath.mp
mp.dps = 60
R = mpmath.mpf
STEP = R(10) ** -11  # truncation h^4 d5f/30 about 1e-44, rounding 1e-60/h^2 = 1e-38


def first(f, h=STEP):
    """f'(0) to fourth order."""
    return (8 * (f(h) - f(-h)) - (f(2 * h) - f(-2 * h))) / (12 * h)


def second(f, h=R(10) ** -8):
    return (16 * (f(h) + f(-h)) - (f(2 * h) + f(-2 * h)) - 30 * f(R(0))) / (12 * h * h)


def moved(X, i, h):
    return [x + h if k == i else x for k, x in enumerate(X)]


def axis_aligned(s):
    """The displacement as a function of position and time, from the settings of a request."""
    L, A = R(s["length"]), R(s["amplitude"])
    c = mpmath.sqrt(R(s["youngs_modulus"]) / R(s["density"]))
    phases = [R(s.get("phase_" + axis, 0)) for axis in "xyz"]

    def u(X, t):
        return [A * mpmath.sin(mp.pi * x / L) * mpmath.sin(mp.pi * (c * t / L + phase)) for x, phase in zip(X, phases)]
    return u


def ring(s):
    Ri, Ro, A = R(s["inner"]), R(s["outer"]), R(s["amplitude"])
    c = mpmath.sqrt(R(s["youngs_modulus"]) / R(s["density"]))
    c3 = -2 / (Ro**2 * (Ro - 3 * Ri))
    c2 = 3 * (Ri + Ro) / (Ro**2 * (Ro - 3 * Ri))
    c1 = -6 * Ri / (Ro * (Ro - 3 * Ri))

    def u(X, t):
        r = mpmath.hypot(*X)
        radial = A * mpmath.cos(mp.pi * c * t) * (c3 * r**3 + c2 * r**2 + c1 * r)
        return [radial * x / r for x in X]
    return u


def vortex(s):
    Ri, Ro, A, T = R(s["inner"]), R(s["outer"]), R(s["amplitude"]), R(s["period"])

    def u(X, t):
        q = (mpmath.hypot(*X) - (Ri + Ro) / 2) / (Ri - Ro)
        alpha = A * mpmath.sin(mp.pi * t / T) * (1 - 8 * q**2 + 16 * q**4)
        c, s_ = mpmath.cos(alpha), mpmath.sin(alpha)
        return [c * X[0] - s_ * X[1] - X[0], s_ * X[0] + c * X[1] - X[1]]
    return u


def lame(s):
    E, nu = R(s["youngs_modulus"]), R(s.get("poisson", 0))
    return E * nu / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu))


def deformation(u, X, t):
    dim = len(X)
    columns = [[first(lambda h, i=i, j=j: u(moved(X, j, h), t)[i]) for i in range(dim)] for j in range(dim)]
    return mpmath.matrix([[columns[j][i] + (i == j) for j in range(dim)] for i in range(dim)])


def stress(F, lam, mu):
    """P from the Cauchy stress (lambda ln J I + mu (F F^T - I))/J, pulled back."""
    J, one = mpmath.det(F), mpmath.eye(F.rows)
    sigma = (lam * mpmath.log(J) * one + mu * (F * F.T - one)) / J
    return J * sigma * (F**-1).T


def state(u, s, X, t):
    """displacement, velocity, acceleration, body force, deformation, stress as one list, as the rows are printed."""
    X, t, dim = [R(x) for x in X], R(t), len(X)
    lam, mu = lame(s)
    velocity = [first(lambda h, i=i: u(X, t + h)[i]) for i in range(dim)]
    acceleration = [second(lambda h, i=i: u(X, t + h)[i]) for i in range(dim)]
    F = deformation(u, X, t)
    P = stress(F, lam, mu)
    gap = R(10) ** -7

    def stress_at(j, h):
        return stress(deformation(u, moved(X, j, h), t), lam, mu)
    force = []
    samples = {(j, k): stress_at(j, k * gap) for j in range(dim) for k in (-2, -1, 1, 2)}
    for i in range(dim):
        divergence = sum((8 * (samples[j, 1][i, j] - samples[j, -1][i, j])
                          - (samples[j, 2][i, j] - samples[j, -2][i, j])) / (12 * gap) for j in range(dim))
        force.append(acceleration[i] - divergence / R(s["density"]))
    return [*u(X, t), *velocity, *acceleration, *force, *[F[i, j] for i in range(dim) for j in range(dim)],
            *[P[i, j] for i in range(dim) for j in range(dim)]]
