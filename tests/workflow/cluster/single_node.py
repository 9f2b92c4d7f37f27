"""A cluster of one node: the daemons of SLURM, from Debian's packages, in a temporary folder."""

import getpass
import os
import platform
import shutil
import signal
import socket
import subprocess
import time
from collections import Counter
from pathlib import Path

PROGRAMS = "munged", "slurmctld", "slurmd", "sbatch", "squeue", "scancel", "scontrol"
NODE = "node"
# the node has a name, a home and temporary files of its own; the clock of its jobs is a minute late
ANOTHER_HOST = f"""
set -e
hostname {NODE}
mkdir -p ~/.cache
mount -t tmpfs none ~/.cache
mount -t tmpfs none "$1"
exec slurmd -D
"""
CONFIGURATION = """
ClusterName=tests
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
SlurmUser={user}
SlurmdUser={user}
AuthInfo=socket={place}/munge.socket,cred_expire=5
StateSaveLocation={place}/state
SlurmdSpoolDir={place}/spool
SlurmctldPidFile={place}/slurmctld.pid
SlurmdPidFile={place}/slurmd.pid
ProctrackType=proctrack/pgid
TaskPlugin=task/none
TaskProlog={place}/prolog
SwitchType=switch/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
ReturnToService=2
MessageTimeout=2
KillWait=2
MinJobAge=3600
SchedulerParameters=sched_interval=1,bf_interval=1
NodeName={node} NodeAddr=127.0.0.1 CPUs=2 RealMemory=4000
PartitionName=all Nodes=ALL Default=YES State=UP
"""
PROLOG = """#!/bin/sh
echo export HOME={place}/own TMPDIR={place}/own PYTHONPATH={place}/clock:$PYTHONPATH
"""
CLOCK = """
import time
right = time.time
time.time = lambda: right() - 60
"""
WAIT = 60.0  # seconds, for a machine that is busy


class Cluster:
    """The daemons, and what is asked of them.

    ``place`` is the folder of all their files.
    """

    def __init__(self, place: Path):
        self.place = place
        self.daemons = {}
        for name in ("state", "spool", "own", "clock"):
            (place / name).mkdir()
        (place / "munge.key").write_bytes(os.urandom(128))
        (place / "munge.key").chmod(0o600)
        ports, user = free_ports(2), getpass.getuser()
        host = platform.node().partition(".")[0]
        (place / "slurm.conf").write_text(
            CONFIGURATION.format(host=host, node=NODE, ports=ports, user=user, place=place)
        )
        (place / "prolog").write_text(PROLOG.format(place=place))
        (place / "prolog").chmod(0o755)
        (place / "clock/sitecustomize.py").write_text(CLOCK)
        os.environ["SLURM_CONF"] = str(place / "slurm.conf")

    def start(self, name, *options):
        """Start a daemon, which writes to a file of its name."""
        with open(self.place / f"{name}.log", "a") as log:
            self.daemons[name] = subprocess.Popen(
                [shutil.which(name), *options], stdout=log, stderr=log, start_new_session=True
            )

    def start_all(self):
        """Start munge, the controller and the node, and wait until the node can be had."""
        files = {"key-file": "key", "socket": "socket", "pid-file": "pid", "seed-file": "seed"}
        options = [f"--{option}={self.place}/munge.{kind}" for option, kind in files.items()]
        self.start("munged", "--foreground", "--force", f"--log-file={self.place}/munge", *options)
        wait_until((self.place / "munge.socket").exists)
        self.start_controller()
        own = self.place / "own"
        self.start("unshare", "--uts", "--mount", "sh", "-c", ANOTHER_HOST, "sh", str(own))
        wait_until(lambda: self.ask("sinfo", "--noheader", "--format=%T") == "idle")

    def kill_controller(self):
        """Kill the controller at once, when its file of jobs has what it knows of that which runs."""
        (job,) = self.jobs("running")
        mark = f"kept-of-{job}"
        self.ask("scontrol", "update", f"jobid={job}", f"admincomment={mark}")
        wait_until(lambda: mark.encode() in (self.place / "state/job_state").read_bytes())
        self.daemons["slurmctld"].kill()
        self.daemons["slurmctld"].wait()

    def start_controller(self):
        """Start the controller, with what it knew when it was stopped."""
        self.start("slurmctld", "-D")

    def stop_controller(self):
        """Stop the controller, which keeps what it knows: killed at once, it loses some seconds."""
        self.daemons["slurmctld"].terminate()
        self.daemons["slurmctld"].wait()

    def stop(self):
        """End all daemons, and what they started."""
        subprocess.run(["scancel", "--user", getpass.getuser()], capture_output=True)
        for daemon in reversed(self.daemons.values()):
            daemon.terminate()
        for daemon in self.daemons.values():
            try:
                daemon.wait(5)
            except subprocess.TimeoutExpired:
                os.killpg(daemon.pid, signal.SIGKILL)

    def ask(self, *command):
        """What a command says."""
        return subprocess.run(command, capture_output=True, text=True).stdout.strip()

    def jobs(self, *states):
        """Numbers of the jobs that are in one of these states, in order."""
        wanted = f"--states={','.join(states)}"
        return self.ask("squeue", "--noheader", "--format=%A", "--sort=i", wanted).split()

    def purposes(self, but):
        """How many jobs, all ``but`` those with these numbers, were submitted for each rule or group."""
        told = self.ask("squeue", "--noheader", "--format=%A %k", "--states=all").splitlines()
        jobs = dict(line.split(" ", 1) for line in told)
        return Counter(jobs[job].rpartition(" ")[0] for job in jobs.keys() - set(but))

    def running(self, but=None):
        """Wait until a job runs, another than ``but``; its number."""
        wait_until(lambda: self.jobs("running") not in ([], [but]))
        return self.jobs("running")[0]


def free_ports(count):
    """Ports at which nobody listens."""
    sockets = [socket.create_server(("127.0.0.1", 0)) for _ in range(count)]
    ports = [each.getsockname()[1] for each in sockets]
    for each in sockets:
        each.close()
    return ports


def wait_until(happens):
    """Wait until ``happens`` returns something true."""
    end = time.monotonic() + WAIT
    while not happens():
        assert time.monotonic() < end, "it does not happen"
        time.sleep(0.1)
