"""Builds a second program beside a finished one from changed copies of a few of its sources.

What the finished build knows is used as it is: its commands (compile_commands.json and `ninja -t commands`) and which object
needs which file (`ninja -t deps`). Only objects that need a changed file are compiled again, from a folder of copies that
stands first among the include folders; everything else is linked from where it is. One such build holds all bugs as
switches, so that the kernel is compiled once and not once a bug.
"""

import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
from dataclasses import dataclass, field

from .declarations import switched_text

HEADER = "plumbline_mutant.hpp"

# Where a switch stands. Number 0 is the program as it is; below 0 it is, too, and the switches that were met are written
# to the file PLUMBLINE_REACHED at the end. An inline variable: the executable and its libraries share one. Each switch that
# the compiler makes code of leaves its number in a section of the file: templates that nobody asks for leave none.
SWITCH = """#pragma once
#include <cstdio>
#include <cstdlib>
namespace plumbline_mutants {
inline const int chosen = [] {
  const char* text = std::getenv("PLUMBLINE_MUTANT");
  return text ? std::atoi(text) : 0;
}();
struct Reached {
  bool at[%(count)d] = {};
  ~Reached() {
    const char* path = chosen < 0 ? std::getenv("PLUMBLINE_REACHED") : nullptr;
    std::FILE* file = path ? std::fopen(path, "a") : nullptr;
    if (!file) return;
    for (int n = 0; n < %(count)d; ++n)
      if (at[n]) std::fprintf(file, "%%d\\n", n);
    std::fclose(file);
  }
};
inline Reached reached;
[[gnu::noinline, gnu::cold]] inline bool note(int n) {
  reached.at[n] = true;
  return false;
}
template <int n>
[[gnu::always_inline]] inline bool on() {
  asm volatile(".pushsection %(section)s,\\"\\",@progbits\\n.long %%c0\\n.popsection" : : "i"(n));
  return chosen == n || (chosen < 0 && note(n));
}
}  // namespace plumbline_mutants
#define PLUMBLINE_MUTANT(n) plumbline_mutants::on<n>()
"""
SECTION = "plumbline_switches"


def switch(largest):
    """The header. Room for a round number of switches: a few more of them change nothing else."""
    return SWITCH % {"count": (largest // 1000 + 1) * 1000, "section": SECTION}


class BuildError(Exception):
    """The finished build is not there, or the second one failed."""


@dataclass
class Program:
    """What was built: run with `environment`."""

    plumbline: pathlib.Path
    libraries: pathlib.Path
    tests: dict = field(default_factory=dict)  # path of a *_test.cpp: executable
    evaluate: pathlib.Path = None  # the evaluator of references, where it was asked for

    def environment(self, **more):
        inherited = {k: v for k, v in os.environ.items() if not k.startswith("PLUMBLINE_")}
        return {**inherited, "LD_LIBRARY_PATH": str(self.libraries), "OMP_NUM_THREADS": "1", **more}


class Base:
    """A finished build: what it was made of."""

    def __init__(self, root, build):
        self.root, self.build = pathlib.Path(root).resolve(), pathlib.Path(build).resolve()
        commands = self.build / "compile_commands.json"
        if not commands.exists() or not (self.build / "build.ninja").exists():
            raise BuildError(f"no finished build in {build}: cmake --preset release && cmake --build --preset release")
        self.compile, self.units_of_tests = {}, set()
        self.sources = {}  # by object: the files compiled in it, one or those of a unit
        for entry in json.loads(commands.read_text()):
            words = shlex.split(entry["command"])
            self.compile[words[words.index("-o") + 1]] = (self._relative(entry["file"]), words)
        self._take_units_apart()
        self.needs = self._dependencies()

    def _take_units_apart(self):
        """Files of tests that are compiled several at a time have commands of their own, too: those of their unit."""
        for name, (unit, words) in list(self.compile.items()):
            if "/Unity/unity_" not in name:
                self.sources[name] = [unit]
                continue
            files = re.findall(r'^#include "(.+)"$', (self.root / unit).read_text(encoding="utf-8"), re.M)
            self.sources[name] = [self._relative(file) for file in files]
            if not name.startswith("tests/"):
                continue
            for file, source in zip(files, self.sources[name]):
                if file.endswith("_test.cpp"):
                    self.units_of_tests.add(name)
                alone = f"{name.split('/Unity/')[0]}/{source.removeprefix('tests/')}.o"
                own = list(words)
                own[own.index("-c") + 1], own[own.index("-o") + 1] = file, alone
                self.compile[alone] = (source, own)

    def _relative(self, path):
        path = pathlib.Path(os.path.normpath(self.build / path))
        return str(path.relative_to(self.root)) if path.is_relative_to(self.root) else str(path)

    def _ninja(self, *arguments):
        done = subprocess.run(["ninja", "-C", self.build, *arguments], capture_output=True, text=True)
        if done.returncode:
            raise BuildError(f"ninja {' '.join(arguments)}: {done.stderr or done.stdout}")
        return done.stdout

    def _dependencies(self):
        needs, own = {}, None
        for line in self._ninja("-t", "deps").splitlines():
            if line.startswith(" "):
                own.add(self._relative(line.strip()))
            elif ": #deps" in line:
                own = needs.setdefault(line.split(":", 1)[0], set())
        return needs

    def affected(self, files):
        """Objects that must be compiled again if these files change."""
        files = set(files)
        return {o for o, (source, _) in self.compile.items() if source in files or files & self.needs.get(o, set())}

    def is_up_to_date(self, name, changed):
        """Whether the finished build holds the object, newer than all it is made of, none of it changed."""
        made, needs = self.build / name, self.needs.get(name, set())
        if not made.exists() or not needs or needs & set(changed):
            return False
        return all((self.root / file).stat().st_mtime <= made.stat().st_mtime for file in needs)

    def link_words(self, target, output):
        """The command that makes `output`, as words."""
        for line in self._ninja("-t", "commands", target).splitlines():
            for part in line.split("&&"):
                words = shlex.split(part)
                archives = words[1:2] == ["qc"] and words[2:3] == [output]
                links = "-o" in words and words[words.index("-o") + 1] == output and "-c" not in words
                if archives or links:
                    return words
        raise BuildError(f"the build has no command for {output}")


def build(base, folder, mutants, tests=(), evaluator=False, jobs=1, plain=False, whole=()):
    """The program with all these (compiled) mutants as switches; with `plain` the same objects without any.

    tests: paths of *_test.cpp, each of which becomes an executable of its own; whole: parts, whose tests stay one.
    """
    folder = pathlib.Path(folder).resolve()
    overlay = folder / "overlay"
    by_file = {}
    for mutant in mutants:
        if mutant.compiled:
            by_file.setdefault(mutant.file, []).append(mutant)
    remove_stale(overlay, by_file)
    write(overlay / HEADER, switch(max((m.number for m in mutants), default=0)))
    for file, own in by_file.items():
        text = (base.root / file).read_text(encoding="utf-8")
        write(overlay / file, text if plain else switched_text(text, own, HEADER))
    affected = base.affected(by_file)
    recipe = _Recipe(base, folder, overlay, by_file)
    for name in sorted(affected):
        if not name.startswith("tests/"):
            recipe.compile(name)
    kernel = (base.build / "lib/libplumbline_kernel.so").resolve().name  # older ones may lie beside it
    recipe.link("plumbline_kernel", f"lib/{kernel}", also="libplumbline_kernel.so.0")
    recipe.link("plumbline_reference", "reference/libplumbline_reference.so")
    recipe.link("plumbline", "cases/libplumbline_harness.a")
    recipe.link("plumbline", "bin/plumbline")
    program = Program(folder / "bin/plumbline", folder / "lib")
    for test in tests:
        program.tests[test] = recipe.test(test)
    for part in whole:
        program.tests[f"tests/{part}"] = recipe.whole_test(part, affected)
    if evaluator:
        program.evaluate = recipe.link("evaluate_reference", "tests/reference/evaluate_reference")
    recipe.run(jobs)
    return program


def remove_stale(overlay, kept):
    """Copies of an earlier build, which would stand before the sources."""
    for path in [*overlay.rglob("*")]:
        if path.is_file() and "/Unity/" not in str(path) and str(path.relative_to(overlay)) not in {HEADER, *kept}:
            path.unlink()


def write(path, text):
    """Only if it changes: what depends on it stays."""
    path = pathlib.Path(path)
    if path.exists() and path.read_text(encoding="utf-8") == text:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


class _Recipe:
    """The build as a file for ninja."""

    def __init__(self, base, folder, overlay, changed):
        self.base, self.folder, self.overlay, self.changed = base, folder, overlay, changed
        self.new, self.edges = {}, []  # {path in the finished build: path here}

    def _edge(self, output, words, inputs, depfile=None):
        escaped = shlex.join(str(word) for word in words).replace("$", "$$")
        lines = [f"build {output}: run {' '.join(map(str, inputs))}", f"  cmd = cd {self.base.build} && {escaped}",
                 f"  description = {output.relative_to(self.folder)}"]  # fmt: skip
        if depfile:
            lines += [f"  depfile = {depfile}", "  deps = gcc"]
        self.edges.append("\n".join(lines))

    def compile(self, name, more=()):
        source, words = self.base.compile[name]
        output = self.folder / "objects" / name
        if "-ffp-contract=fast" in words and "-include" in words:  # headers precompiled with fusing would bring it along
            first = words.index("-include")
            words = [*words[:first], *words[first + 2:]]
        # Products and sums fused at the compiler's choice would be other ones beside a switch; -O2 compiles faster.
        words = [{"-ffp-contract=fast": "-ffp-contract=off", "-O3": "-O2"}.get(word, word) for word in words]
        here = self._copy(source) if source in self.changed or "/Unity/unity_" in name else self.base.root / source
        words[words.index("-c") + 1] = str(here)
        words[words.index("-o") + 1] = str(output)
        includes = [f"-I{self.overlay}", f"-I{self.base.root}", "-w", "-MD", "-MF", f"{output}.d", *more]
        words[1:1] = includes
        launcher = shutil.which("ccache")
        self._edge(output, [*([launcher] if launcher else []), *words], [here], f"{output}.d")
        self.new[name] = output

    def _copy(self, source):
        """The changed copy of a source; of a unit of several sources one that includes the changed copies of these."""
        if "/Unity/unity_" in source:
            text = (self.base.root / source).read_text(encoding="utf-8")
            for file in self.changed:
                text = text.replace(f'"{self.base.root / file}"', f'"{self.overlay / file}"')
            write(self.overlay / source, text)
        return self.overlay / source

    def link(self, target, output, also=None, words=None, as_name=None):
        """Makes a library or executable again if any part of it is new; else it stays the one that is there."""
        words = words or self.base.link_words(target, output)
        if not any(word in self.new for word in words):
            if output.endswith((".so", ".a")) or ".so." in output:
                return self.base.build / output
        place = {"lib": "lib", "reference": "lib"}.get(output.split("/")[0], "bin")
        here = self.folder / (as_name or f"{place}/{pathlib.Path(output).name}")
        words = [str(here) if word == output else self.new.get(word, word) for word in words]
        inputs = self._parts(words, here)
        if words[1] == "qc":
            words = ["sh", "-c", f"rm -f {here} && {shlex.join(map(str, words))} && ranlib {here}"]
        if also:
            words = ["sh", "-c", f"{shlex.join(map(str, words))} && ln -sf {here.name} {here.parent / also}"]
        self._edge(here, words, inputs)
        self.new[output] = here
        return here

    def _parts(self, words, output):
        """What a link takes in: new parts, and those of the finished build, which may have been made again since."""
        new = set(map(str, self.new.values()))
        parts = [self.base.build / word for word in map(str, words[1:]) if word != str(output)]  # a new one's path is whole
        return [part for part in parts if str(part) in new or (re.search(r"\.(o|a|so)(\.|$)", part.name) and part.is_file())]

    def test(self, path):
        """An executable of one file of tests, with what the executable of its whole part is linked to."""
        part = path.split("/")[1]
        own = f"tests/CMakeFiles/{part}_test.dir/{path.removeprefix('tests/')}.o"
        if own not in self.base.compile:
            raise BuildError(f"{path} is no test of the build")
        if own not in self.new and not self.base.is_up_to_date(own, self.changed):
            self.compile(own)
        words = self.base.link_words(f"{part}_test", f"tests/{part}_test")
        folder = f"tests/CMakeFiles/{part}_test.dir/"
        tests = [word for word in words if word in self.base.units_of_tests or (word.startswith(folder) and word.endswith("_test.cpp.o"))]
        first = words.index(tests[0])
        words = [*words[:first], own, *(word for word in words[first:] if word not in tests)]
        name = path.removeprefix("tests/").removesuffix(".cpp").replace("/", "-")
        whole = f"tests/{part}_test"
        here = self.link(None, whole, words=words, as_name=f"bin/{name}")
        del self.new[whole]
        return here

    def whole_test(self, part, affected):
        words = self.base.link_words(f"{part}_test", f"tests/{part}_test")
        for word in words:
            if word in affected and word not in self.new:
                self.compile(word)
        return self.link(None, f"tests/{part}_test", words=words)

    def run(self, jobs):
        rule = "rule run\n  command = $cmd\n  description = $description\n"
        write(self.folder / "build.ninja", f"{rule}\n" + "\n\n".join(self.edges) + "\n")
        for edge in self.new.values():
            pathlib.Path(edge).parent.mkdir(parents=True, exist_ok=True)
        for folder in ("bin", "lib"):
            (self.folder / folder).mkdir(parents=True, exist_ok=True)
        log = self.folder / "build.log"
        with open(log, "w", encoding="utf-8") as stream:
            command = ["ninja", "-C", self.folder, "-j", str(jobs), "-k", "0"]
            status = subprocess.run(command, stdout=stream, stderr=subprocess.STDOUT).returncode
        if status:
            raise BuildError(f"the build failed; see {log}")
