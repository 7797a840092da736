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


def evaluate(requests):
    """One list of (value, bound) pairs for each request; RuntimeError with the message of a refusal."""
    run = subprocess.run([os.environ["PLUMBLINE_EVALUATE_REFERENCE"]], input="\n".join(requests) + "\n",
                         capture_output=True, text=True, check=True)
    lines = run.stdout.splitlines()
    assert len(lines) == len(requests)
    answers = []
    for line in lines:
        if line.startswith("error"):
            raise RuntimeError(line)
        numbers = [float(word) for word in line.split()]
        answers.append(list(zip(numbers[::2], numbers[1::2])))
    return answers
