"""A Slurm cluster of two nodes on the loopback: own munged, own ports, all files in one folder, gone at the end."""
import contextlib
import ctypes
import os
import pwd
import re
import shutil
import signal
import socket
import subprocess
import tempfile
import time
from pathlib import Path

from sweeps import await_

NODES = ("n1", "n2")
TOOLS = ("munged", "munge", "unmunge", "slurmctld", "slurmd", "sbatch", "scancel", "scontrol", "sinfo", "squeue")
PATH = os.environ["PATH"] + ":/usr/sbin:/sbin"

CONFIGURATION = """
ClusterName=plumbline
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller_port}
SlurmUser={user}
SlurmdUser={user}
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=5
CredType=cred/munge
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobacctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
SchedulerType=sched/backfill
SchedulerParameters=sched_interval=1,batch_sched_delay=0,bf_interval=1
SlurmdParameters=config_overrides
SlurmdTimeout=2
MessageTimeout=2
KillWait=2
UnkillableStepTimeout=10
EpilogMsgTime=0
ReturnToService=2
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool/%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.%n.log
NodeName={nodes} NodeHostname={host} NodeAddr=127.0.0.1 Port={node_ports} CPUs=2 RealMemory=4000 State=UNKNOWN
PartitionName=work Nodes=ALL Default=YES MaxTime=INFINITE State=UP
"""


class CannotStart(Exception):
    """This machine cannot run such a cluster; the text says why."""


def missing_tools():
    return [tool for tool in TOOLS if not shutil.which(tool, path=PATH)]


def _end_with_parent():
    """In a child: it is killed when this process ends, however that ends."""
    ctypes.CDLL(None).prctl(1, signal.SIGKILL)   # 1: PR_SET_PDEATHSIG


def _free_ports(count):
    """The first of `count` ports in a row that nobody listens on."""
    for first in range(20000 + os.getpid() % 10000, 60000, count):
        with contextlib.ExitStack() as held:
            try:
                for port in range(first, first + count):
                    held.enter_context(socket.socket()).bind(("127.0.0.1", port))
                return first
            except OSError:
                continue
    raise CannotStart("no free ports")


class Cluster:
    """Use as `with Cluster() as cluster`; `environment` is that of the commands of Slurm."""

    def __init__(self):
        self.folder = Path(tempfile.mkdtemp(prefix="plumbline-slurm-"))
        self.folder.chmod(0o755)   # munged wants its socket within reach
        self.environment = {**os.environ, "PATH": PATH, "SLURM_CONF": str(self.folder / "slurm.conf")}
        self.daemons = {}

    def __enter__(self):
        try:
            self._start_munge()
            self._start_slurm()
        except BaseException:
            self.stop()
            raise
        return self

    def __exit__(self, *_):
        self.stop()

    def ask(self, *command, seconds=20):
        """Standard output of a command of Slurm."""
        done = subprocess.run(["timeout", "-k", "2", str(seconds), *command], env=self.environment, capture_output=True, text=True,
                              stdin=subprocess.DEVNULL)
        if done.returncode != 0:
            raise RuntimeError(f"{' '.join(command)}: exit status {done.returncode}: {done.stderr}")
        return done.stdout

    def running_jobs(self, node):
        return self.ask("squeue", "--noheader", "--states=R", f"--nodelist={node}", "--format=%A").split()

    def hold(self, node, word):
        """Stops a process with this word in its command line that runs in a job on the node; whether there was one."""
        for pid in self._processes():
            if self._variable(pid, "SLURMD_NODENAME") == node and word in self._line(pid).split():
                with contextlib.suppress(ProcessLookupError):
                    os.kill(pid, signal.SIGSTOP)
                    return True
        return False

    def kill_node(self, node):
        """As if the node lost its power: its daemon and all that its jobs run, at once. The command lines of the latter."""
        keepers = tuple(f"slurmstepd: [{job}." for job in self.running_jobs(node))
        lines = {pid: self._line(pid) for pid in self._processes()}
        jobs = [pid for pid in lines if self._variable(pid, "SLURMD_NODENAME") == node]
        for pid in [self.daemons[f"slurmd {node}"].pid, *(pid for pid in lines if keepers and lines[pid].startswith(keepers)), *jobs]:
            self._kill(pid)
        return [lines[pid] for pid in jobs]

    def state(self, node):
        """In Slurm's words, with a star at the end if the node does not answer."""
        return self.ask("sinfo", "--noheader", f"--nodes={node}", "--format=%T").strip()

    def restarts(self, job):
        return int(re.search(r"Restarts=(\d+)", self.ask("scontrol", "-o", "show", "job", job))[1])

    def logs(self):
        texts = [f"== {path.name}\n{path.read_text(errors='replace')[-3000:]}" for path in sorted(self.folder.glob("*.log"))]
        return "\n".join(texts)

    def stop(self):
        """Ends every process that this cluster started, and removes its folder."""
        for daemon in self.daemons.values():
            daemon.kill()
        for daemon in self.daemons.values():
            daemon.wait()
        for pid in self._processes():
            self._kill(pid)
        for _ in range(50):
            shutil.rmtree(self.folder, ignore_errors=True)
            if not self.folder.exists():
                return
            time.sleep(0.1)

    def _launch(self, name, *command):
        tool = shutil.which(command[0], path=PATH)
        with open(self.folder / f"{name.replace(' ', '-')}.output.log", "w") as output:
            self.daemons[name] = subprocess.Popen([tool, *command[1:]], env=self.environment, stdin=subprocess.DEVNULL, stdout=output,
                                                  stderr=output, cwd=self.folder, preexec_fn=_end_with_parent)

    def _start_munge(self):
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        files = {f"--{what}-file": self.folder / f"munged.{what}" for what in ("pid", "log", "seed")}
        files["--key-file"], files["--socket"] = key, self.folder / "munge.socket"
        self._launch("munged", "munged", "--foreground", "--force", *(f"{option}={path}" for option, path in files.items()))
        await_("munged", 10, lambda: self._alive() and files["--socket"].exists())

    def _start_slurm(self):
        ports = _free_ports(1 + len(NODES))
        for folder in ("state", *(f"spool/{node}" for node in NODES)):
            (self.folder / folder).mkdir(parents=True)
        text = CONFIGURATION.format(
            host=socket.gethostname().partition(".")[0], folder=self.folder, user=pwd.getpwuid(os.geteuid()).pw_name,
            controller_port=ports, nodes=f"n[1-{len(NODES)}]", node_ports=f"[{ports + 1}-{ports + len(NODES)}]")
        (self.folder / "slurm.conf").write_text(text)
        version = re.search(r"(\d+)\.(\d+)", self.ask("sinfo", "--version"))
        # Jobs are tracked without control groups; newer daemons look for them all the same unless told not to.
        if (int(version[1]), int(version[2])) >= (23, 2):
            (self.folder / "cgroup.conf").write_text("CgroupPlugin=disabled\n")
        self._launch("slurmctld", "slurmctld", "-D", "-f", self.environment["SLURM_CONF"])
        for node in NODES:
            self._launch(f"slurmd {node}", "slurmd", "-D", "-N", node, "-f", self.environment["SLURM_CONF"])
        await_("two idle nodes", 30, lambda: self._alive() and self._idle())

    def _alive(self):
        for name, daemon in self.daemons.items():
            if daemon.poll() is not None:
                raise CannotStart(f"{name} ended with status {daemon.returncode}\n{self.logs()}")
        return True

    def _idle(self):
        try:
            return self.ask("sinfo", "--noheader", "--format=%T %D", seconds=5).split() == ["idle", str(len(NODES))]
        except RuntimeError:   # the controller does not answer yet
            return False

    def _processes(self):
        """All that runs with this cluster's SLURM_CONF: daemons, keepers of jobs, jobs."""
        own = os.getpid()
        return [pid for pid in map(int, filter(str.isdigit, os.listdir("/proc")))
                if pid != own and self._variable(pid, "SLURM_CONF") == self.environment["SLURM_CONF"]]

    @staticmethod
    def _variable(pid, name):
        with contextlib.suppress(OSError):
            for entry in Path(f"/proc/{pid}/environ").read_bytes().split(b"\0"):
                if entry.startswith(name.encode() + b"="):
                    return entry.partition(b"=")[2].decode(errors="replace")
        return None

    @staticmethod
    def _line(pid):
        with contextlib.suppress(OSError):
            return Path(f"/proc/{pid}/cmdline").read_bytes().replace(b"\0", b" ").decode(errors="replace")
        return ""

    @staticmethod
    def _kill(pid):
        with contextlib.suppress(ProcessLookupError):
            os.kill(pid, signal.SIGKILL)
