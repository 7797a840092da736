"""A material point method on a line, written from the papers and not from Plumbline: a stranger for `plumbline score`.

Points carry mass, velocity and stress; a step maps mass and momentum to the nodes, adds the forces, and maps back:
  D. Sulsky, Z. Chen, H. L. Schreyer, Comput. Methods Appl. Mech. Engrg. 118 (1994) 179        the method, linear shapes
  D. Sulsky, S.-J. Zhou, H. L. Schreyer, Comput. Phys. Commun. 87 (1995) 236                   second map before the strains
  M. Steffen, R. M. Kirby, M. Berzins, Int. J. Numer. Meth. Engng 76 (2008) 922               quadratic B-splines
  C. Jiang, C. Schroeder, A. Selle, J. Teran, A. Stomakhin, ACM Trans. Graph. 34 (2015) 51    affine transfer
  M. L. Wilkins, J. Comput. Phys. 36 (1980) 281                                                artificial viscosity
"""
import json
import time

import h5py
import numpy


# Choices of `Mpm`: quadratic B-splines, velocities half a step apart from positions: second order in space and time.
SECOND_ORDER = {"shape": "quadratic", "step": "usl", "staggered": True}


def linear(u):
    """Nodes below a point at u cells and the one above: first node, weights, slopes per cell."""
    base = numpy.floor(u).astype(int)
    f = u - base
    return base, numpy.stack([1 - f, f]), numpy.stack([-numpy.ones_like(f), numpy.ones_like(f)])


def quadratic(u):
    """Three nodes around a point: quadratic B-splines."""
    base = numpy.floor(u - 0.5).astype(int)
    f = u - base - 1  # from the middle node, in [-1/2, 1/2]
    weights = numpy.stack([0.5 * (0.5 - f) ** 2, 0.75 - f ** 2, 0.5 * (0.5 + f) ** 2])
    return base, weights, numpy.stack([f - 0.5, -2 * f, f + 0.5])


class Gas:
    """Ideal gas with artificial viscosity; the density follows the divergence."""

    def __init__(self, parameters, columns, h):
        self.gamma = parameters["gamma"]
        self.linear, self.quadratic = parameters["viscosity_linear"], parameters["viscosity_quadratic"]
        self.mass, self.h = columns["mass"], h
        self.density, self.energy = columns["density"].copy(), columns["energy"].copy()
        self.rate = numpy.zeros_like(self.mass)
        self.find_stress()

    def find_stress(self):
        self.volume = self.mass / self.density
        self.pressure = (self.gamma - 1) * self.density * self.energy
        closing = numpy.maximum(-self.rate * self.h, 0)
        self.stress = -self.pressure - self.density * closing * (self.linear * self.sound() + self.quadratic * closing)

    def sound(self):
        return numpy.sqrt(self.gamma * (self.gamma - 1) * numpy.maximum(self.energy, 0))

    def advance(self, rate, dt):
        """The old stress works over the new strain rate; then density, then the new stress."""
        self.energy = self.energy + dt * self.volume * self.stress * rate / self.mass
        self.density = self.density / (1 + dt * rate)
        self.rate = rate
        self.find_stress()

    def columns(self):
        return {"density": self.density, "energy": self.energy, "pressure": self.pressure}


class Bar:
    """Hooke's law on a line; strains add up, volumes stay."""

    def __init__(self, parameters, columns, h):
        self.modulus, self.rest_density = parameters["youngs_modulus"], parameters["density"]
        self.volume = columns["volume"].copy()
        self.strain = columns["strain"].copy()
        self.find_stress()

    def find_stress(self):
        self.stress = self.modulus * self.strain

    def sound(self):
        return numpy.sqrt(self.modulus / self.rest_density)

    def advance(self, rate, dt):
        self.strain = self.strain + dt * rate
        self.find_stress()

    def columns(self):
        return {"volume": self.volume, "stress": self.stress}


class Line:
    """Nodes of a line with a ghost beyond each end. Walls are mirrors: what lies beyond one is folded back."""

    def __init__(self, low, h, cells, walls):
        self.low, self.h, self.cells, self.walls = low, h, cells, walls

    def scatter(self, base, parts, odd):
        """Sums `parts` (nodes of a point x points) on the nodes; `odd`: turns its sign at a mirror."""
        at = base + 1 + numpy.arange(len(parts))[:, None]
        nodes = numpy.bincount(at.ravel(), parts.ravel(), self.cells + 3)
        for ghost, wall, mirror, kind in ((0, 1, 2, self.walls[0]), (-1, -2, -3, self.walls[1])):
            if kind == "symmetry":
                nodes[mirror] += -nodes[ghost] if odd else nodes[ghost]
                nodes[wall] = 0 if odd else nodes[wall]
        return nodes

    def mirrored(self, velocity):
        for ghost, wall, mirror, kind in ((0, 1, 2, self.walls[0]), (-1, -2, -3, self.walls[1])):
            if kind == "symmetry":
                velocity[wall], velocity[ghost] = 0, -velocity[mirror]
        return velocity

    def gather(self, base, weights, nodes):
        return sum(w * nodes[base + 1 + k] for k, w in enumerate(weights))


class Mpm:
    """One body on a line. shape: linear or quadratic; transfer: flip or apic; step: usl or musl. staggered: velocities are those
    of half a step ago, as in central differences, which makes the step of second order."""

    def __init__(self, start, shape="linear", transfer="flip", step="musl", staggered=False, **wrong):
        with h5py.File(start, "r") as file:
            self.about = json.loads(file["description"].asstr()[()])
            body = self.about["bodies"][0]
            columns = {name: file[body["group"]][name][()] for name in body["datasets"]}
        grid = self.about["grid"]
        if grid["dim"] != 1 or self.about["pistons"] or body["load"]:
            raise SystemExit("this program knows a line without pistons and loads")
        self.body, self.shape = body["name"], {"linear": linear, "quadratic": quadratic}[shape]
        self.transfer, self.kind, self.staggered, self.before = transfer, step, staggered, 0
        self.line = Line(grid["low"][0], grid["h"], grid["cells"][0], grid["walls"]["x"])
        self.mass = columns["mass"]
        self.position, self.velocity = columns["position"][:, 0].copy(), columns["velocity"][:, 0].copy()
        self.affine = columns["affine"][:].ravel().copy() if "affine" in columns else numpy.zeros_like(self.mass)
        parameters = {name: of["value"] for name, of in body["material"]["parameters"].items()}
        parameters.update(wrong)
        law = {"ideal_gas": Gas, "linear_elastic": Bar}[body["material"]["name"]]
        self.material = law(parameters, columns, grid["h"])
        self.time = self.steps = 0

    def step(self, dt):
        line, h, material = self.line, self.line.h, self.material
        base, weights, slopes = self.shape((self.position - line.low) / h)
        slopes = slopes / h
        mass = line.scatter(base, weights * self.mass, odd=False)
        moving = numpy.maximum(mass, 1e-300)
        away = (base + numpy.arange(len(weights))[:, None]) * h + line.low - self.position  # x_i - x_p
        carried = self.velocity + (self.affine * away if self.transfer == "apic" else 0)
        momentum = line.scatter(base, weights * self.mass * carried, odd=True)

        force = line.scatter(base, -slopes * material.volume * material.stress, odd=True)
        kick = (self.before + dt) / 2 if self.staggered else dt
        advanced = line.mirrored((momentum + kick * force) / moving)
        self.position = self.position + dt * line.gather(base, weights, advanced)
        if self.transfer == "apic":
            self.velocity = line.gather(base, weights, advanced)
            self.affine = line.gather(base, weights * away, advanced) / (h * h / 4)
        else:
            self.velocity = self.velocity + kick * line.gather(base, weights, line.mirrored(force / moving))
        if self.kind == "musl":
            advanced = line.mirrored(line.scatter(base, weights * self.mass * self.velocity, odd=True) / moving)
        material.advance(line.gather(base, slopes, advanced), dt)
        self.time, self.steps, self.before = self.time + dt, self.steps + 1, dt

    def run(self, end=None, cfl=0.3, dt=None):
        end = self.about["end_time"] if end is None else end
        begun = time.perf_counter()
        while end - self.time > 1e-12 * end:
            longest = dt or cfl * self.line.h / numpy.max(self.material.sound() + abs(self.velocity))
            self.step(min(longest, end - self.time))
        if self.staggered:  # the other half of the last kick
            self.step(0)
            self.steps -= 1
        self.wall_s = time.perf_counter() - begun
        return self

    def write(self, path, **attributes):
        with h5py.File(path, "w") as file:
            said = {"exchange_format": 1, "kind": "final-state", "case": self.about["case"], "cells": self.about["cells"],
                    "problem": self.about["problem"], "start": self.about["start"], "time": self.time, "steps": self.steps, "wall_s": self.wall_s,
                    "program": "stranger", "version": "1"}
            file.attrs.update({**said, **attributes})
            group = file.create_group(f"bodies/{self.body}")
            for name, values in {"position": self.position, "velocity": self.velocity, "mass": self.mass,
                                 **self.material.columns()}.items():
                group[name] = values
        return path
