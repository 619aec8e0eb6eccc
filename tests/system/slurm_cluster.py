"""A Slurm cluster of two nodes on this machine: real daemons, loopback only, all files in one folder. It does not
touch an installed Slurm or munge of the machine."""

import contextlib
import os
import shutil
import socket
import subprocess

from waiting import wait_until

PROGRAMS = ["munged", "slurmctld", "slurmd", "sbatch", "scontrol", "sinfo", "squeue"]
NODES = ["n1", "n2"]
SECONDS_TO_START = 30
SECONDS_TO_STOP = 10

# cred_expire: delay of a task that is queued again. Nodes of less weight get tasks first. config_overrides: a
# node may have less than its configuration says.
CONFIG = """
ClusterName=flownav
SlurmctldHost={host}(127.0.0.1)
SlurmctldPort={ports[slurmctld]}
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
AuthInfo=socket={folder}/munge.socket,cred_expire=10
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
StateSaveLocation={folder}/state
SlurmctldPidFile={folder}/slurmctld.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdSpoolDir={folder}/spool.%n
SlurmdPidFile={folder}/slurmd.%n.pid
SlurmdLogFile={folder}/slurmd.%n.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
JobCompType=jobcomp/filetxt
JobCompLoc={folder}/completed.txt
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=batch_sched_delay=0,sched_min_interval=10000,bf_interval=1
ReturnToService=2
SlurmdParameters=config_overrides
SlurmdTimeout=10
KillWait=2
MinJobAge=3600
JobRequeue=1
NodeName=n1 NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[n1]} CPUs=2 RealMemory=16000 Weight=2
NodeName=n2 NodeHostname={host} NodeAddr=127.0.0.1 Port={ports[n2]} CPUs=2 RealMemory=16000 Weight=1
PartitionName=all Nodes=n1,n2 Default=YES MaxTime=INFINITE State=UP
"""


def missing_programs():
    path = os.environ["PATH"] + ":/usr/sbin"
    return [program for program in PROGRAMS if not shutil.which(program, path=path)]


def free_ports(names):
    """Returns an unused port for each name."""
    with contextlib.ExitStack() as open_sockets:
        ports = {}
        for name in names:
            listener = open_sockets.enter_context(socket.socket())
            listener.bind(("127.0.0.1", 0))
            ports[name] = listener.getsockname()[1]
    return ports


class SlurmCluster:
    def __init__(self, folder):
        self.folder = folder
        self.daemons = {}
        folder.mkdir(parents=True)
        folder.chmod(0o755)  # munged refuses folders that others may write
        (folder / "state").mkdir()
        config = CONFIG.format(host=socket.gethostname().split(".")[0], folder=folder,
                               ports=free_ports(["slurmctld", *NODES]))  # fmt: skip
        (folder / "slurm.conf").write_text(config)

    def start(self):
        self.start_munged()
        self.start_daemon("slurmctld", ["slurmctld", "-D", "-f", self.folder / "slurm.conf"])
        for node in NODES:
            self.start_node(node)
        self.wait_for_state(NODES, "idle", SECONDS_TO_START)

    def start_munged(self):
        key, munge_socket = self.folder / "munge.key", self.folder / "munge.socket"
        key.touch(mode=0o600)
        key.write_bytes(os.urandom(1024))
        self.start_daemon("munged", ["munged", "--foreground", "--force", f"--socket={munge_socket}",
                                     f"--key-file={key}", f"--pid-file={self.folder}/munge.pid",
                                     f"--log-file={self.folder}/munge.log",
                                     f"--seed-file={self.folder}/munge.seed"])  # fmt: skip
        wait_until(munge_socket.exists, SECONDS_TO_START, "munged answers")

    def start_node(self, node):
        """Starts a node in its own process namespace: killing its first process ends all processes of the node."""
        (self.folder / f"spool.{node}").mkdir(exist_ok=True)
        self.start_daemon(node, ["unshare", "--pid", "--fork", "--mount-proc", "--kill-child",
                                 "slurmd", "-D", "-f", self.folder / "slurm.conf", "-N", node])  # fmt: skip

    def start_daemon(self, name, command):
        """Starts a daemon that is killed when this process ends."""
        with open(self.folder / f"{name}.out", "wb") as out:
            self.daemons[name] = subprocess.Popen(["setpriv", "--pdeathsig", "KILL", *command], env=self.environment(),
                                                  stdin=subprocess.DEVNULL, stdout=out, stderr=out)  # fmt: skip

    def environment(self):
        """Returns the environment without the variables of an installed Slurm."""
        foreign = ("SLURM", "SBATCH", "SQUEUE", "SINFO", "SCONTROL")
        kept = {name: value for name, value in os.environ.items() if not name.startswith(foreign)}
        return dict(kept, SLURM_CONF=str(self.folder / "slurm.conf"), PATH=os.environ["PATH"] + ":/usr/sbin")

    def ask(self, *command):
        """Returns the output of a Slurm command; None when it failed."""
        done = subprocess.run(command, env=self.environment(), stdin=subprocess.DEVNULL, capture_output=True,
                              text=True, timeout=SECONDS_TO_START, check=False)  # fmt: skip
        return done.stdout.strip() if done.returncode == 0 else None

    def wait_for_state(self, nodes, state, seconds):
        def reached():
            states = [self.ask("sinfo", "-h", "-n", node, "-o", "%T") for node in nodes]
            return all(found and found.startswith(state) for found in states)

        wait_until(reached, seconds, f"{', '.join(nodes)} {state}")

    def wait_for_jobs(self, seconds):
        """Waits until no job is queued or running."""
        wait_until(lambda: self.ask("squeue", "-h", "-r", "-o", "%i") == "", seconds, "all jobs have ended")

    def job(self, number):
        """Returns scontrol's values of a job by name."""
        words = (self.ask("scontrol", "-o", "show", "job", str(number)) or "").split()
        return dict(word.split("=", 1) for word in words if "=" in word)

    def lose_node(self, node):
        """Kills a node, as a power failure would."""
        self.end(self.daemons.pop(node))

    def end(self, daemon):
        daemon.kill()
        daemon.wait(SECONDS_TO_STOP)

    def close(self):
        while self.daemons:
            self.end(self.daemons.popitem()[1])
