"""Errors and order that the paper states are those of its commands."""
import re

from contract import ROOT

PAPER = (ROOT / "ci/packaging/paper/paper.md").read_text(encoding="utf-8")


def errors(plumbline, case, measure, cells, *options):
    study = plumbline("converge", case, "--cells", ",".join(cells), *options, json=True).json()["studies"][0]
    return [f"{level['measures'][measure]['error']:.4g}" for level in study["levels"]], study


def row(scheme):
    """The errors of a scheme in the paper's table, by cells."""
    head, values = ([cell.strip() for cell in re.search(rf"^\| {name} *\|(.*)\|$", PAPER, re.MULTILINE)[1].split("|")] for name in ("scheme", scheme))
    return dict(zip(head, values, strict=True))


def test_the_default_schemes_row_and_order(plumbline):
    stated = row("default")
    found, study = errors(plumbline, "sod", "density.L1", [*stated, "1600"])
    assert found[:-1] == list(stated.values())
    fit = study["measures"]["density.L1"]
    assert f"order {fit['order']:.3f} (95 % interval {fit['order_low']:.3f} to {fit['order_high']:.3f}," in " ".join(PAPER.split())


def test_yorks_row_on_coarse_meshes(plumbline):
    stated = row("york1997")
    cells = ["100", "200"]   # finer ones take most of a minute
    assert errors(plumbline, "sod", "density.L1", cells, "--scheme", "york1997")[0] == [stated[n] for n in cells]


def test_the_manufactured_bar(plumbline):
    cells, first, last = ["64", "256"], *re.search(r"falls from (\S+) m at 64 cells to (\S+) m at 256", PAPER).groups()
    assert errors(plumbline, "mms-bar", "displacement.worst", cells)[0] == [first, last]
