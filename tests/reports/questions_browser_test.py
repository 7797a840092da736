"""Ten questions of readers: each is answered within three clicks from the index, by a number that is the one in the results file."""

import json
import math
import os
import re
import shlex
import shutil
import statistics
import subprocess

import numpy
import pytest
from plumbline import reader

import history
import render
import synthetic_costs
import synthetic_results

DESK = (1440, 1000)
MOST_CLICKS = 3
DIGITS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻−", "0123456789--", "\u00a0\u2009\u202f")
FAILING = synthetic_results.gate(
    "sod", "default", "overshoot", "overshoot of density", None, 0.01, "XFAIL", 0.0374,
    band={"low": 0.03, "high": 0.045}, origin="requirement", cause="the contact is not limited")  # fmt: skip
HOOP = synthetic_results.gate("spring-mass", "default", "hoop-stress", "hoop_stress at 32 cells", None, 0.05, "PASS", 0.02731)
NUMBERED = re.compile(r"(-?[\d ]*\d(?:\.\d+)?(?: ?[×·] ?10-?\d+)?)( ms\b)?")


# --- results, and the report of them --------------------------------------------------------------


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """Folder of results, with costs, earlier results and a known failure of the default scheme."""
    folder = tmp_path_factory.mktemp("results")
    verdicts = synthetic_results.write_all(folder, damaged=False)["verdicts"]
    (folder / verdicts).unlink()
    synthetic_results.write_verdicts(folder, [*synthetic_results.all_gates(), FAILING, HOOP])
    for path in folder.glob("spring-mass-*.h5"):
        synthetic_results.state_command(path, "plumbline verify spring-mass --tier quick")
    synthetic_costs.write(folder)
    now = history.entry(reader.load_folder(folder), "quick")
    constants = {name: 1.37 * value for name, value in now["constants"].items()}
    earlier = {**now, "commit": "f" * 40, "started": "2026-11-14T08:00:00Z", "constants": constants}
    for entry in (earlier, now):
        history.append(folder / history.HISTORY_FILE, entry)
    return folder


@pytest.fixture(scope="module")
def report(made, tmp_path_factory):
    output = tmp_path_factory.mktemp("report")
    assert render.main([str(made), str(output)]) == 0
    return output


def document(folder, name):
    return json.loads((folder / name).read_text(encoding="utf-8"))


def study(folder, case, scheme):
    return next(
        found.study for found in reader.load_folder(folder).studies
        if (found.study["case"], found.study["scheme"], found.study["vary"]) == (case, scheme, "cells"))  # fmt: skip


def whole(name):
    """A regular expression for a name that does not go on: `period` is not `period-frozen`."""
    return re.escape(name) + r"(?![-/])"


# --- a reader -------------------------------------------------------------------------------------


class Visitor:
    """Starts at the index, and clicks with the mouse on what is to be seen."""

    def __init__(self, browser, folder):
        self.browser, self.clicks = browser, 0
        browser.open(folder / "index.html", *DESK)

    def click(self, choice, called):
        """Clicks the element of a JavaScript expression."""
        place = self.browser.evaluate(
            f"(() => {{ const part = {choice}; if (!part) return null; part.scrollIntoView({{block: 'center', behavior: 'instant'}});"
            "const box = part.getClientRects()[0], x = box.x + Math.min(12, box.width / 2), y = box.y + box.height / 2;"
            "return part.contains(document.elementFromPoint(x, y)) ? [x, y] : null; })()"
        )
        assert place, f"nothing to be seen is called {called!r} on {self.browser.evaluate('location.pathname')}"
        self.clicks += 1
        assert self.clicks <= MOST_CLICKS
        self.browser.leave()
        for kind in ("mousePressed", "mouseReleased"):
            self.browser.mouse(kind, *place, button="left", clickCount=1)

    def seen(self, selector, words):
        return (
            f"[...document.querySelectorAll({json.dumps(selector)})].find(part => part.getClientRects().length &&"
            f"part.textContent.trim().replace(/\\s+/g, ' ').includes({json.dumps(words)}))"
        )

    def follow(self, words, within="main a"):
        self.click(self.seen(within, words), words)
        self.browser.arrive()

    def press(self, figure, button):
        """Presses a button that a figure has while the pointer is over it."""
        figure = self.seen(".results figure", figure)
        x, y = self.browser.evaluate(
            f"(() => {{ const part = {figure}; part.scrollIntoView({{block: 'center', behavior: 'instant'}});"
            "const box = part.getBoundingClientRect(); return [box.x + box.width / 2, box.y + box.height / 2]; })()"
        )
        self.browser.mouse("mouseMoved", x, y)
        self.click(f"[...{figure}.querySelectorAll('button')].find(part => part.textContent === {json.dumps(button)})", button)

    def search(self, words, found):
        """Types into the search, and clicks the answer that says this."""
        self.browser.press("/", 191, "/")
        for letter in words:
            self.browser.press(letter, 0, letter)
        for _ in range(40):
            if self.browser.evaluate(f"Boolean({self.seen('#found a', found)})"):
                break
            self.browser.evaluate("new Promise(done => setTimeout(done, 100))")
        self.follow(found, "#found a")

    def cell(self, column, *words):
        """Text in a column of the row with these words, in the first table that shows both."""
        text = self.browser.evaluate(
            f"""(() => {{ const column = {json.dumps(column)}, words = {json.dumps([whole(word) for word in words])}.map(word => new RegExp(word));
            for (const table of document.querySelectorAll('main table')) {{
              const at = [...table.querySelectorAll('thead th')].findIndex(head => head.textContent.trim() === column);
              const above = []; // cells that reach down from earlier rows, by column
              if (at >= 0) for (const row of table.querySelectorAll('tbody tr')) {{
                const line = []; let next = 0;
                for (const cell of row.cells) {{
                  while (above[next]?.rows > 0) line.push(above[next++].cell);
                  for (let wide = 0; wide < cell.colSpan; ++wide, ++next) {{ above[next] = {{cell, rows: cell.rowSpan}}; line.push(cell); }}
                }}
                while (above[next]?.rows > 0) line.push(above[next++].cell);
                above.forEach(entry => --entry.rows);
                const whole = [...new Set(line)].map(cell => cell.textContent).join(' ');
                if (row.getClientRects().length && line[at] && words.every(part => part.test(whole))) return line[at].textContent.trim();
              }}
            }} return null; }})()"""
        )
        assert text, f"no row with {words} and a column {column} on {self.browser.evaluate('location.pathname')}"
        return text

    def command(self, identifier):
        """The command that the row of a gate shows."""
        return self.browser.evaluate(
            f"[...document.querySelectorAll('main tr')].find(row => row.getClientRects().length && new RegExp({json.dumps(whole(identifier))}).test(row.textContent))"
            ".querySelector('.reproduce code').textContent"
        )

    def words(self, selector="main"):
        """Text that is to be seen."""
        return " ".join(self.browser.evaluate(f"document.querySelector({json.dumps(selector)}).innerText").translate(DIGITS).split())


@pytest.fixture
def visitor(browser, report):
    return Visitor(browser, report)


def printed(text):
    """The first number of a text, and the worth of its last digit: the third at most, for pages leave zeros at the end out."""
    found = NUMBERED.search(text.translate(DIGITS))
    assert found, f"no number in {text!r}"
    digits, _, power = found[1].replace(" ", "").replace("×", "*").replace("·", "*").partition("*10")
    scale = 10.0 ** int(power or 0) * (1e-3 if found[2] else 1)
    number = float(digits) * scale
    last = 10.0 ** -len(digits.partition(".")[2]) * scale
    return number, min(last, 10.0 ** (math.floor(math.log10(abs(number))) - 2)) if number else last


def is_printed(text, value, rounding=0.5):
    """Whether the first number of a text is the value, to the last digit that is printed; `rounding` is 1 where it is rounded down."""
    number, last = printed(text)
    return abs(number - value) <= rounding * last * (1 + 1e-9)


@pytest.mark.parametrize("text, value, same", [
    ("0.0117", 0.01171, True), ("0.0117", 0.01176, False), ("4.4 × 10⁻⁴", 4.4e-4, True), ("4.4 × 10⁻⁴", 4.5e-4, False), ("−44", -44.04, True), ("−44", -44.2, False),
    ("1\u202f600 cells", 1600, True), ("1\u202f600 cells", 1606, False), ("≤ 2.0", 2.004, True), ("2", 2.004, True), ("2", 2.4, False), ("0", 0.4, True), ("100 ms", 0.1004, True)])  # fmt: skip
def test_a_number_is_compared_to_its_last_digit(text, value, same):
    assert is_printed(text, value) is same


# --- the questions --------------------------------------------------------------------------------


def test_is_my_integrator_as_good_as_the_other(visitor, made):
    card = document(made, "scorecard-mine.json")
    visitor.follow("Judge an integrator")
    visitor.follow(card["integrator"], "main table a")
    for row in card["factors"]:
        if row["factor"] is not None:
            assert is_printed(visitor.cell("Factor", row["case"]), row["factor"]), row
    assert is_printed(visitor.cell("Factor", "median"), card["factor"]["factor"])


def test_which_scheme_to_choose(visitor, made):
    """Time to an error of 1 %: of the level that has it."""
    visitor.follow("Choose a scheme")
    levels = [run for run in document(made, "cost.json")["runs"] if run["case"] == "sod"]
    for scheme in ("default", "york1997"):
        (level,) = (run for run in levels if run["scheme"] == scheme and run["errors"]["density.L1"]["relative_error"] == 0.01)
        assert is_printed(visitor.cell(scheme, synthetic_results.sod_catalog()["title"]), statistics.median(level["wall_s"])), scheme


def test_what_changed_since_last_week(visitor, made):
    visitor.follow("What changed")
    earlier, now = (json.loads(line) for line in (made / history.HISTORY_FILE).read_text(encoding="utf-8").splitlines())
    name = next(iter(now["constants"]))
    assert is_printed(visitor.cell("Before", "constant", name), earlier["constants"][name])
    assert is_printed(visitor.cell("Now", "constant", name), now["constants"][name])


def test_how_york_did_on_sod(visitor, made):
    """Order of his errors, and the values of his velocity and pressure, read off the figures as far as they are drawn."""
    visitor.follow(synthetic_results.sod_catalog()["title"])
    found = study(made, "sod", "york1997")
    order, _ = printed(visitor.words().partition("York’s own choices: order")[2])
    assert order == pytest.approx(found["measures"]["density.L1"]["order"], abs=5e-4)  # three decimals
    (finest,) = (run for run in reader.load_folder(made).runs if run.name == found["levels"][-1]["file"])
    for field in ("velocity", "pressure"):
        visitor.press(field.capitalize(), "Values")
        shown = visitor.browser.evaluate(
            f"[...{visitor.seen('.results figure', field.capitalize())}.querySelectorAll('.values tbody tr')].filter(row => row.textContent.startsWith('York'))"
            ".map(row => row.cells[3].textContent)"
        )
        values, exact = [printed(text)[0] for text in shown], finest.profile[field]
        assert len(values) > 4 and [min(values), max(values)] == pytest.approx([min(exact), max(exact)], abs=5e-3 * numpy.ptp(exact)), field


def test_where_a_word_stands(visitor, made):
    (verdicts,) = reader.load_folder(made).verdicts
    (gate,) = (gate for gate in verdicts.gates if gate["id"] == HOOP["id"])
    visitor.search("hoop", gate["quantity"])
    assert is_printed(visitor.cell("Measured", gate["id"]), gate["measured"])


def test_reproduce_this_number(browser, tmp_path):
    """Of a run of the program: the command beside a number makes it again."""
    program = os.environ.get("PLUMBLINE")
    if not program:
        pytest.skip("the environment variable PLUMBLINE names no executable")
    results, folder, again = (tmp_path / name for name in ("results", "report", "again"))
    judged = subprocess.run([program, "verify", "spring-mass", "--results", results], capture_output=True, check=False)
    assert judged.returncode in (0, 1) and render.main([str(results), str(folder)]) == 0
    visitor = Visitor(browser, folder)
    (verdicts,) = reader.load_folder(results).verdicts
    chosen = next(gate for gate in verdicts.gates if gate["measured"] and gate["origin"] != "identity" and gate["case"] == "spring-mass")
    visitor.follow(verdicts.catalog["spring-mass"]["title"])
    command = shlex.split(visitor.command(chosen["id"]))
    made = subprocess.run([program, *command[1:], "--results", again, "--json", "-"], capture_output=True, text=True, check=False)
    (gate,) = (gate for gate in json.loads(made.stdout)["gates"] if gate["id"] == chosen["id"])
    assert is_printed(visitor.cell("Measured", chosen["id"]), gate["measured"]) and gate["measured"] == chosen["measured"]


def test_what_failed_by_default(visitor, made):
    (verdicts,) = reader.load_folder(made).verdicts
    failed = [gate for gate in verdicts.gates if gate["verdict"] == "XFAIL" and gate["scheme"] == "default"]
    assert is_printed(re.search(r"([^,;]*) by the default scheme", visitor.words("h1"))[1], len(failed))
    visitor.follow("Expected failures", "nav a")
    for gate in failed:
        assert is_printed(visitor.cell("Measured", gate["id"]), gate["measured"])
    assert is_printed(next(line for line in re.findall(r"\d+ failures? [^:.]*", visitor.words()) if "default" in line.lower()), len(failed))


def test_the_largest_stable_step_of_usl(visitor, made):
    """The smallest limit known, and the one inside a body beside it."""
    visitor.follow("Choose a step")
    (usl,) = (known for known in document(made, "stability.json")["known_limits"] if known["integrator"] == "usl")
    smallest, *others = sorted(row["limit"] for row in usl["rows"] if row["limit"] and row["unit"] == "h/c")
    assert is_printed(visitor.cell("Smallest known", "usl"), smallest, rounding=1)
    assert is_printed(visitor.cell("Others, the smallest first", "usl"), others[0], rounding=1)


def test_a_quantity_without_reference_has_no_error(visitor, made):
    visitor.follow(synthetic_results.spring_catalog()["title"])
    (run,) = (found for found in reader.load_folder(made).runs if found.case == "spring-mass")
    assert run.measures["energy_drift"]["error"] is None
    assert is_printed(visitor.cell("Measured", "energy_drift"), run.measures["energy_drift"]["value"])
    assert (visitor.cell("Reference", "energy_drift"), visitor.cell("Relative error", "energy_drift")) == ("no reference", "—")


LOOKS = """[...document.querySelectorAll('.results figure, .plots figure')].map(figure => [...figure.querySelectorAll('ul.key li')].map(entry =>
  [entry.querySelector('svg').getAttribute('class'), entry.querySelector('svg').style.color, entry.querySelector('use').getAttribute('href')].join()))"""
FIRST_AXES = "({}).querySelector('svg[data-plot]').dataset.plot"
# Labels of numbers to the right of a picture: those of the scale of its colours.
SCALE = """(() => {{ const figure = {}, edge = figure.querySelector('image').getBoundingClientRect().right;
  return [...figure.querySelectorAll('text')].filter(part => part.getBoundingClientRect().left >= edge).map(part => part.textContent.trim()); }})()"""


def test_figures_can_be_read(visitor, made):
    """Axes that the exact solution fills, lines that differ, and scales beside the colours of a field."""
    visitor.follow(synthetic_results.sod_catalog()["title"])
    looks = [entries for entries in visitor.browser.evaluate(LOOKS) if entries]
    assert len(looks) > 4 and [entries for entries in looks if len(set(entries)) < len(entries)] == []
    runs = {run.name: run for run in reader.load_folder(made).runs}
    finest = runs[study(made, "sod", "york1997")["levels"][-1]["file"]]
    for field in ("density", "velocity", "pressure"):
        exact = finest.profile[f"{field}_reference"]
        *_, low, high, _, _ = json.loads(visitor.browser.evaluate(FIRST_AXES.format(visitor.seen(".results figure", field.capitalize()))))["a"][0]
        assert low <= exact.min() and exact.max() <= high and high - low < 2.5 * numpy.ptp(exact), field
    (drawn,) = (run for run in runs.values() if run.frames)
    figure = visitor.seen("figure.plot", "Pressure of the gas at the end of the run")
    visitor.browser.evaluate(f"(() => {{ for (let part = {figure}; part; part = part.parentElement) if (part.open === false) part.open = true; }})()")
    gas = [body["kind"] for body in drawn.frames.bodies].index("gas")
    values = drawn.frames.body(len(drawn.frames) - 1, gas)["pressure"]
    low, high = re.search(r" from (\S+) to (\S+) ", visitor.browser.evaluate(f"{figure}.querySelector('figcaption').textContent").translate(DIGITS)).groups()
    assert is_printed(low, values.min()) and is_printed(high, values.max())
    scale = [printed(label)[0] for label in visitor.browser.evaluate(SCALE.format(figure)) if re.search(r"\d", label)]
    least, most = numpy.percentile(values, (1, 99))
    step = max(numpy.diff(scale))
    assert len(scale) > 2 and least - step <= min(scale) <= least + step and most - step <= max(scale) <= most + step


@pytest.mark.skipif(not shutil.which("pdfinfo"), reason="pdfinfo is not installed (apt-get install poppler-utils)")
def test_a_case_prints_on_few_sheets(visitor, made, tmp_path):
    """With all that it says: the numbers of its gates are those of the file."""
    visitor.follow(synthetic_results.sod_catalog()["title"])
    target = tmp_path / "page.pdf"
    target.write_bytes(visitor.browser.pdf())
    assert int(re.search(r"Pages:\s*(\d+)", subprocess.run(["pdfinfo", target], capture_output=True, text=True, check=True).stdout)[1]) <= 10
    printed_words = subprocess.run(["pdftotext", "-raw", target, "-"], capture_output=True, text=True, check=True).stdout
    (verdicts,) = reader.load_folder(made).verdicts
    (gate,) = (gate for gate in verdicts.gates if gate["id"] == FAILING["id"] and gate["case"] == "sod")
    after_its_band = printed_words.partition(gate["quantity"])[2].partition(f"{gate['band']['high']}")[2]
    assert is_printed(after_its_band, gate["measured"])


def test_how_long_it_takes_to_make_it_again(visitor, made):
    """All runs together stand on the index itself; what to type, and what each command took, on the page that it leads to."""
    runs = reader.load_folder(made).runs
    assert is_printed(visitor.words().partition("Duration")[2], sum(run.run["wall_s"] for run in runs))
    visitor.follow("Reproduce", "nav a")
    said = visitor.words()
    assert "git clone REPOSITORY plumbline cd plumbline ci/report" in said and "ci/test" in said
    commands = {run.provenance["command"] for run in runs}
    assert len(commands) > 1
    for command in commands:
        walls = [run.run["wall_s"] for run in runs if run.provenance["command"] == command]
        assert is_printed(visitor.cell("Runs in this folder", command), len(walls)), command
        assert is_printed(visitor.cell("They took", command), sum(walls)), command


def test_what_the_gates_see_of_bugs(visitor, made):
    visitor.follow("Mutation testing", "nav a")
    found = document(made, "mutants.json")
    counts, said = found["counts"], visitor.words()
    of_the_list = said.rpartition("Gates of cases see")[2]  # the first is of the bugs drawn at random
    assert is_printed(of_the_list, counts["by_gates_of_cases"])
    assert is_printed(said.partition("unit tests alone see")[2], counts["killed"] - counts["by_gates_of_cases"])
    assert found["commit"][:7] in said
