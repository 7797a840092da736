#!/usr/bin/env python3
"""The end of a test run, where a log is cut first: what each failed test of a JUnit file says of its failure.

Usage: ci/failed_tests.py JUNIT
"""
import re
import sys
import xml.etree.ElementTree as Xml

MOST_LINES = 12  # of one test
MOST_COLUMNS = 240
# What pytest, GoogleTest and `plumbline verify` put before the lines that say why.
TELLING = re.compile(r"E  |FAILED|\S+:\d+: (Failure|Error)|\s+(Which is|Actual|Expected)|(FAIL|XPASS|INVALID) |plumbline: ")


def telling_lines(text):
    """The lines that say why; the last ones where none is known to."""
    lines = [line.rstrip() for line in text.splitlines() if line.strip()]
    return [line for line in lines if TELLING.match(line)][:MOST_LINES] or lines[-MOST_LINES:]


def main(path):
    for test in Xml.parse(path).getroot().iter("testcase"):
        if test.get("status") == "fail":
            print(f"== failed: {test.get('name')}")
            for line in telling_lines(test.findtext("system-out") or ""):
                print(line[:MOST_COLUMNS])


if __name__ == "__main__":
    main(*sys.argv[1:])
