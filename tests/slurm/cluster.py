# SPDX-License-Identifier: GPL-3.0-or-later
"""A Slurm of this machine alone, as root: munged, slurmctld and slurmd in a folder of their own, and how to end them."""
import os
import pathlib
import socket
import subprocess

from waiting import PATIENCE, wait_until

CONFIGURATION = """
ClusterName=test
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={controller}
SlurmdPort={node}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=5
CryptoType=crypto/munge
ProctrackType=proctrack/pgid
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SwitchType=switch/none
MpiDefault=none
ReturnToService=2
KillWait=30
MinJobAge=300
SchedulerType=sched/builtin
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=0
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd.log
NodeName={host} NodeAddr=127.0.0.1 CPUs={cpus} RealMemory={memory} State=UNKNOWN
PartitionName=all Nodes={host} Default=YES MaxTime=INFINITE State=UP
"""


def free_port():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


class Cluster:
    """All that it runs ends with `end`."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.folder.chmod(0o755)  # munged refuses a folder that others may write to
        self.environment = os.environ | {"SLURM_CONF": str(self.folder / "slurm.conf")}
        self.started = []
        for name in ("state", "spool"):
            (self.folder / name).mkdir()
        memory = os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES") // 2**20 - 500
        text = CONFIGURATION.format(folder=self.folder, host=socket.gethostname().split(".")[0], cpus=os.cpu_count(),
                                    memory=memory, controller=free_port(), node=free_port())
        (self.folder / "slurm.conf").write_text(text)
        key = self.folder / "munge.key"
        key.write_bytes(os.urandom(128))
        key.chmod(0o400)
        self.start("munged", "--foreground", f"--key-file={key}", f"--socket={self.folder}/munge.socket",
                   f"--pid-file={self.folder}/munged.pid", f"--log-file={self.folder}/munged.log",
                   f"--seed-file={self.folder}/munged.seed", "--force")
        self.wait_for(lambda: (self.folder / "munge.socket").exists(), "the socket of munged")
        self.start("slurmctld", "-D")
        self.start("slurmd", "-D")
        self.wait_for(lambda: "idle" in self.say("sinfo", "--noheader", "--format=%T"), "an idle node")

    def start(self, *words):
        with open(self.folder / f"{words[0]}.out", "w") as output:
            self.started.append(subprocess.Popen(words, env=self.environment, stdin=subprocess.DEVNULL, stdout=output,
                                                 stderr=output))

    def say(self, *words):
        return subprocess.run(words, env=self.environment, capture_output=True, text=True, timeout=PATIENCE).stdout

    def wait_for(self, condition, what, patience=PATIENCE):
        """As wait_until; what is not seen is said with what the daemons have written."""
        try:
            return wait_until(condition, what, *self.started, patience=patience)
        except AssertionError as late:
            late.add_note("\n".join(f"{log}: {log.read_text()[-2000:]}" for log in self.folder.glob("*.log")))
            raise

    def jobs(self):
        """The jobs that are not over, a line each."""
        return self.say("squeue", "--noheader", "--format=%i %T %k").splitlines()

    def wait_for_no_job(self, patience=PATIENCE):
        self.wait_for(lambda: not self.jobs(), "the end of all jobs", patience)

    def end(self):
        for process in reversed(self.started):
            process.terminate()
        for process in reversed(self.started):
            try:
                process.wait(timeout=PATIENCE)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()
