#!/usr/bin/env python3
"""Tells Snakemake how a Slurm job stands: success, running or failed. No accounting database is needed, one is used.

Usage: status.py JOB
"""
import subprocess
import sys

SUCCESS = {"COMPLETED"}
FAILED = {"BOOT_FAIL", "CANCELLED", "DEADLINE", "FAILED", "NODE_FAIL", "OUT_OF_MEMORY", "PREEMPTED", "REVOKED", "TIMEOUT"}


def ask(*command):
    """(output, error) of a command; a command that is not there or hangs says nothing."""
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=20)
    except (OSError, subprocess.TimeoutExpired) as error:
        return "", str(error)
    return done.stdout, done.stderr


def state(job):
    """The state in Slurm's words; None while the controller does not answer."""
    shown, why = ask("scontrol", "-o", "show", "job", job)
    for word in shown.split():
        if word.startswith("JobState="):
            return word.partition("=")[2]
    if "Invalid job id" not in why:
        return None
    # The controller forgets a job after MinJobAge; the accounting, where there is one, does not.
    shown, _ = ask("sacct", "-X", "-n", "-P", "-o", "State", "-j", job)
    return shown.split()[0].rstrip("+") if shown.split() else "FAILED"


def main(job):
    now = state(job)
    return "success" if now in SUCCESS else "failed" if now in FAILED else "running"


if __name__ == "__main__":
    print(main(sys.argv[1]))
