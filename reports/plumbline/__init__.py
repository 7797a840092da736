"""Results of Plumbline, the verification and validation harness of the Material Point Method, as arrays of numpy.

    import plumbline
    run = plumbline.run("sod", cells=200)
    run.profile["density"], run.measures["density.L1"]["error"], run.verdict
    run.plot("density")
    study = plumbline.converge("sod", cells=[50, 100, 200, 400, 800])
    study.measures["density.L1"]["order"], study.errors("density.L1")
    plumbline.verify("sod").gates
    plumbline.results("results").studies

`run`, `converge` and `verify` call the executable `plumbline`: the one given as `executable`, else the one that the environment variable
PLUMBLINE names, else the one on PATH. What it refuses is raised with its own message. Numbers are in SI units; every column has its unit
beside it, `run.profile.units["density"]`.
"""

from plumbline.execution import ExecutableNotFound, ExecutionError, RunStopped, converge, run, verify
from plumbline.reader import Columns, DamagedFile, Folder, Frames, NewerFormat, NotInstalled, Result, ResultsError, load
from plumbline.reader import load_folder as results

__version__ = "0.6.0"
__all__ = [
    "Columns",
    "DamagedFile",
    "ExecutableNotFound",
    "ExecutionError",
    "Folder",
    "Frames",
    "NewerFormat",
    "NotInstalled",
    "Result",
    "ResultsError",
    "RunStopped",
    "converge",
    "load",
    "results",
    "run",
    "verify",
]
