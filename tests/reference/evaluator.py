"""Runs the reference under test: many requests at once through the small executable."""
import os
import subprocess


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
