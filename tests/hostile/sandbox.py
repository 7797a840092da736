"""Runs one call in a folder of its own, within limits, and keeps what it did there."""
import dataclasses
import os
import resource
import shlex
import signal
import subprocess
import time
from pathlib import Path

FLOOR = 12.0     # processor seconds beyond ten times the estimate: set-up, references, verdicts, the laboratory
IDLE = 20.0      # seconds on the clock without any work: of the processor alone a busy machine gives little
MEMORY = 6 << 30


@dataclasses.dataclass(frozen=True)
class Call:
    """Arguments after the program's name, as text or as bytes that are no text, and where the call is made."""
    arguments: tuple
    stdout: str = "pipe"          # pipe, full (a device without space), closed, gone (a pipe whose reader has left)
    stdin: bytes | None = None    # None: closed
    environment: tuple = ()       # (name, value)
    estimate: float = 0.0         # s that the program itself expects, without set-up
    floor: float = FLOOR
    interrupted: tuple = ()       # (signal, after so many seconds)
    statuses: tuple = (0, 1, 2, 3, 4)
    why: str = ""                 # of `statuses`, where these are fewer
    may_exist: tuple = ()         # patterns of files that the call may write

    @property
    def command(self):
        return self.arguments[0] if self.arguments and isinstance(self.arguments[0], str) else None

    @property
    def json(self):
        """Whether the document is wanted on standard output."""
        return any(pair == ("--json", "-") for pair in zip(self.arguments, self.arguments[1:]))

    def option(self, name, default=None):
        """The last value of an option."""
        found = default
        for word, following in zip(self.arguments, self.arguments[1:]):
            if word == name:
                found = following
        return found

    def line(self, executable="plumbline"):
        """As it is typed in a shell."""
        words = [f"{name}={shlex.quote(value)}" for name, value in self.environment]
        words += [executable, *(quoted(word) for word in self.arguments)]
        if self.stdin is not None:
            words = [f"printf {quoted(self.stdin)} |", *words] if len(self.stdin) < 300 else [f"# {len(self.stdin)} bytes |", *words]
        after = {"pipe": "", "full": " > /dev/full", "closed": " >&-", "gone": " | true"}[self.stdout]
        after += f"  # {self.interrupted[0].name} after {self.interrupted[1]:.2f} s" if self.interrupted else ""
        return " ".join(words) + after


def quoted(word):
    """For bash; long runs of one character abridged."""
    raw = word if isinstance(word, bytes) else word.encode("utf-8", "surrogateescape")
    if len(raw) > 200:
        return f"\"$(head -c {len(raw)} < /dev/zero | tr '\\0' {shlex.quote(chr(raw[0]))})\"" if len(set(raw)) == 1 else "..." + str(len(raw))
    try:
        plain = raw.decode("utf-8")
        if plain.isprintable():
            return shlex.quote(plain)
    except UnicodeDecodeError:
        pass
    return "$'" + "".join(chr(b) if 32 <= b < 127 and b not in b"'\\" else f"\\x{b:02x}" for b in raw) + "'"


@dataclasses.dataclass
class Outcome:
    call: Call
    code: int
    out: bytes
    err: bytes
    seconds: float            # on the clock
    late: str                 # why it was ended, or nothing
    before: dict
    after: dict               # name -> (what it is, size, time of change), relative to the folder
    folder: Path
    answered: float = 0.0     # s between the signal and the end
    heard: bool = True        # whether the program had begun to listen for the signal when it was sent

    @property
    def text(self):
        return (self.out + self.err).decode("utf-8", "replace")

    @property
    def new(self):
        """Files that are new or changed."""
        return sorted(name for name, what in self.after.items() if self.before.get(name) != what and what[0] != "folder")


def contents(folder):
    """What there is below a folder, without following links."""
    found = {}
    for path in sorted(folder.rglob("*")):
        status = path.lstat()
        kind = "link" if path.is_symlink() else "folder" if path.is_dir() else "file" if path.is_file() else "device"
        found[str(path.relative_to(folder))] = (kind, status.st_size, status.st_mtime_ns if kind == "file" else 0)
    return found


def standard_output(kind):
    if kind == "full":
        return os.open("/dev/full", os.O_WRONLY)
    if kind == "gone":
        reader, writer = os.pipe()
        os.close(reader)
        return writer
    return None


def make(executable, call, folder, slow=1.0, memory=MEMORY):
    """The outcome of one call. `slow`: how much longer this program takes than a plain build; `memory`: bytes it may map, 0 for any."""
    cpu = slow * (10 * call.estimate + call.floor)

    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (int(cpu) + 1, int(cpu) + 4))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        if memory:
            resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
        if call.stdout == "closed":
            os.close(1)

    before = contents(folder)
    environment = {"PATH": os.environ.get("PATH", ""), "HOME": os.environ.get("HOME", ""), "OMP_NUM_THREADS": "1", "OMP_WAIT_POLICY": "passive", "LC_ALL": "C.UTF-8",
                   **{name: value for name, value in os.environ.items() if name.endswith("SAN_OPTIONS")}, **dict(call.environment)}
    target = standard_output(call.stdout)
    begin = time.monotonic()
    with subprocess.Popen([executable, *call.arguments], cwd=folder, env=environment, preexec_fn=limit, start_new_session=True,
                          stdin=subprocess.DEVNULL if call.stdin is None else subprocess.PIPE,
                          stdout=subprocess.PIPE if target is None else target, stderr=subprocess.PIPE) as process:
        if target is not None:
            os.close(target)
        out, err, late, answered, heard = wait(process, call, min(IDLE, 8 * slow * call.floor))
    return Outcome(call, process.returncode, out or b"", err or b"", time.monotonic() - begin, late, before, contents(folder), folder, answered, heard)


def wait(process, call, idle):
    """(standard output, standard error, why it was ended, seconds from the signal to the end, whether it listened). `idle`: s without any work"""
    stdin, sent, heard = call.stdin, 0.0, True
    if call.interrupted:
        try:
            out, err = process.communicate(stdin, timeout=call.interrupted[1])
            return out, err, "", 0.0, heard
        except subprocess.TimeoutExpired:
            heard = listens(process.pid, call.interrupted[0])
            process.send_signal(call.interrupted[0])
            stdin, sent = None, time.monotonic()
    late, worked, last = "", -1.0, time.monotonic()
    while True:
        try:
            out, err = process.communicate(stdin, timeout=min(idle, 5))
            break
        except subprocess.TimeoutExpired:
            stdin = None
            so_far, paused = work(process.pid)
            if so_far != worked or paused:
                worked, last = so_far, time.monotonic()
            elif time.monotonic() - last >= idle:
                late = f"nothing done for {idle:.0f} s"
                os.killpg(process.pid, signal.SIGKILL)
    if process.returncode == -signal.SIGXCPU:
        late = "processor time used up"
    return out, err, late, time.monotonic() - sent if sent else 0.0, heard


def listens(process, number):
    """Whether a process has a handler for a signal: none while it is loaded, however long a busy machine takes for that."""
    try:
        status = Path(f"/proc/{process}/status").read_text(encoding="utf-8", errors="replace")
    except OSError:
        return True
    return bool(int(status.partition("SigCgt:")[2].split()[0], 16) >> (number - 1) & 1)


def work(session):
    """(processor time of all processes of a session, whether one of them is stopped from outside)"""
    ticks, paused = 0, False
    for entry in Path("/proc").glob("[0-9]*/stat"):
        try:
            fields = entry.read_text(encoding="utf-8", errors="replace").rpartition(")")[2].split()
        except OSError:
            continue
        if int(fields[3]) == session:
            ticks += int(fields[11]) + int(fields[12])
            paused |= fields[0] == "T"
    return ticks, paused
