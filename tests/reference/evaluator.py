"""Runs the reference under test: many requests at once through the small executable."""
import os
import subprocess

import numpy


def wide(random, low=1e-3, high=1e3):
    """A number of any size between these: its logarithm is uniform."""
    return float(10 ** random.uniform(numpy.log10(low), numpy.log10(high)))


def request(name, settings, at=()):
    words = [name, *(f"{key}={float(value)!r}" for key, value in settings.items())]
    return " ".join([*words, "@", *(repr(float(v)) for v in at)])


class Value(tuple):
    """(value, bound) of a reference; its name in the answer and the request that it answers."""

    def __new__(cls, value, bound, name, request):
        made = super().__new__(cls, (value, bound))
        made.value, made.bound, made.name, made.request = value, bound, name, request
        return made


def evaluate(requests):
    """One list of Values for each request; RuntimeError with the message of a refusal."""
    run = subprocess.run([os.environ["PLUMBLINE_EVALUATE_REFERENCE"]], input="\n".join(requests) + "\n",
                         capture_output=True, text=True, check=True)
    lines = run.stdout.splitlines()
    assert len(lines) == len(requests)
    answers = []
    for line, asked in zip(lines, requests):
        if line.startswith("error"):
            raise RuntimeError(line)
        words = line.split()
        answers.append([Value(float(value), float(bound), name, asked)
                        for name, value, bound in zip(words[::3], words[1::3], words[2::3])])
    return answers
