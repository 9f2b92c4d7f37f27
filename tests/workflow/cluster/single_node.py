"""A cluster of one node: SLURM without accounting, from Debian's packages, in a temporary
folder."""

import getpass
import os
import platform
import shutil
import signal
import socket
import subprocess
import time
from pathlib import Path

PROGRAMS = ("munged", "slurmctld", "slurmd")
NODE, PARTITION = "node", "batch"
# Snakemake's plugin: not beside Snakemake, as it slows every command where no controller answers
PLUGIN = Path(__file__).resolve().parents[3] / ".venv" / "slurm"
# The node has a host name and temporary files of its own; its configuration is where clusters have
# theirs.
ANOTHER_HOST = f"""
set -e
hostname {NODE}
mount -t tmpfs none {{place}}/own
mount --bind {{place}} /etc/slurm
slurmd -D &
wait  # and reap what the jobs leave
"""
SLURM = """
ClusterName=tests
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[0]}
SlurmdPort={ports[1]}
SlurmUser={user}
SlurmdUser={user}
AuthInfo=socket={place}/munge.socket
StateSaveLocation={place}/state
SlurmdSpoolDir={place}/spool
SlurmctldPidFile={place}/slurmctld.pid
SlurmdPidFile={place}/slurmd.pid
ProctrackType=proctrack/pgid
TaskPlugin=task/none
TaskProlog={place}/prolog
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
ReturnToService=2
KillWait=2
MessageTimeout=2
MinJobAge=3600
SchedulerParameters=sched_interval=1,bf_interval=1
NodeName={node} NodeAddr=127.0.0.1 CPUs=2 RealMemory=4000
PartitionName={partition} Nodes=ALL Default=YES State=UP
"""
WAIT = 60.0  # seconds, for a machine that is busy


class Cluster:
    """The daemons, and what is asked of them.

    ``place`` is the folder of all their files.
    """

    def __init__(self, place: Path):
        self.place = place
        self.daemons = {}
        for name in ("state", "spool", "own"):
            (place / name).mkdir()
        ports = free_ports(2)
        known = {
            "host": platform.node().partition(".")[0],
            "node": NODE,
            "partition": PARTITION,
            "place": place,
            "ports": ports,
            "user": getpass.getuser(),
        }
        self.write("munge.key", os.urandom(128), 0o600)
        self.write("prolog", f"#!/bin/sh\necho export TMPDIR={place}/own\n".encode(), 0o755)
        self.write("slurm.conf", SLURM.format(**known).encode(), 0o644)
        os.environ["SLURM_CONF"] = str(place / "slurm.conf")

    def write(self, name, content, mode):
        """Write one of the daemons' files."""
        (self.place / name).write_bytes(content)
        (self.place / name).chmod(mode)

    def start(self, name, *options):
        """Start a daemon, which writes to a file of its name."""
        with open(self.place / f"{name}.log", "a") as log:
            self.daemons[name] = subprocess.Popen(
                [shutil.which(name), *options], stdout=log, stderr=log, start_new_session=True
            )

    def start_all(self):
        """Start all daemons, and wait until the node can be had."""
        self.start_munge()
        self.start_controller()
        self.start_node()

    def start_munge(self):
        """Start the daemon by which the others know each other."""
        files = {"key-file": "key", "socket": "socket", "pid-file": "pid", "seed-file": "seed"}
        options = [f"--{option}={self.place}/munge.{kind}" for option, kind in files.items()]
        self.start("munged", "--foreground", "--force", f"--log-file={self.place}/munge", *options)
        wait_until((self.place / "munge.socket").exists)

    def start_node(self):
        """Start the node, and wait until it can be had."""
        own = ("--uts", "--mount", "--pid", "--mount-proc", "--fork", "--kill-child")
        self.start("unshare", *own, "sh", "-c", ANOTHER_HOST.format(place=self.place))
        wait_until(lambda: self.ask("sinfo", "--noheader", "--format=%T") == "idle")

    def cut_power_of_node(self):
        """Kill all that runs on the node, and tell the controller."""
        self.daemons["unshare"].kill()
        self.daemons["unshare"].wait()
        self.ask("scontrol", "update", f"nodename={NODE}", "state=down", "reason=test")

    def start_controller(self):
        """Start the controller, with what it knew when it was stopped."""
        self.start("slurmctld", "-D")

    def stop_controller(self):
        """Stop the controller, which keeps what it knows."""
        self.daemons["slurmctld"].terminate()
        self.daemons["slurmctld"].wait()

    def stop(self):
        """End all daemons, and what they started."""
        subprocess.run(["scancel", "--user", getpass.getuser()], capture_output=True)
        self.daemons["unshare"].kill()
        for daemon in reversed(self.daemons.values()):
            daemon.terminate()
            try:
                daemon.wait(10)
            except subprocess.TimeoutExpired:
                os.killpg(daemon.pid, signal.SIGKILL)
                daemon.wait()

    def ask(self, *command):
        """What a command says."""
        return subprocess.run(command, capture_output=True, text=True).stdout.strip()

    def jobs(self, *states):
        """Numbers of the jobs that are in one of these states, in order."""
        wanted = f"--states={','.join(states)}"
        return self.ask("squeue", "--noheader", "--format=%A", "--sort=i", wanted).split()

    def submitted(self, purpose, but):
        """How many jobs, all ``but`` those with these numbers, were submitted for a rule or
        group."""
        listed = self.ask("squeue", "--noheader", "--format=%A %k", "--states=all").splitlines()
        jobs = dict(line.split(" ", 1) for line in listed)
        return sum(jobs[job].startswith(f"rule_{purpose}") for job in jobs.keys() - set(but))

    def hurry(self, job):
        """Have a job start that was put back into the queue, not minutes later."""
        self.ask("scontrol", "release", job)
        self.ask("scontrol", "update", f"jobid={job}", "starttime=now")

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
