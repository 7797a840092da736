"""What second computations found is kept, or compared with what is kept: second_values.py."""
import os
import pathlib

import second_values


def pytest_sessionfinish(session, exitstatus):
    passed = {pathlib.Path(item.nodeid.split("::")[0]).name + "::" + item.nodeid.split("::", 1)[1]
              for item in session.items}
    if exitstatus or session.config.option.collectonly:
        return
    if os.environ.get("PLUMBLINE_KEEP_SECOND_VALUES"):
        others = [entry for entry in second_values.stored() if entry["by"] not in passed]
        second_values.write(others + second_values.entries_of_this_run())
        return
    for test in second_values.complaints(passed):
        print(f"\n{test}: reference/second_values.json holds other requests; PLUMBLINE_KEEP_SECOND_VALUES=1 writes them")
        session.exitstatus = 1
