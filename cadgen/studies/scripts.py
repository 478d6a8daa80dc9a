"""Job scripts for clusters on which no scheduler of dask runs: each job computes a shard, and a last command merges.

They are texts that a user reads and hands to the cluster; nothing here talks to one. The shards' journals lie in a
folder that all jobs see, and a job that was killed goes on where it was when it is handed in again.
"""

from collections.abc import Callable
from dataclasses import dataclass
from json import dumps
from pathlib import Path
from shlex import quote

from cadgen.registry import Registry


@dataclass(frozen=True)
class Jobs:
    """A study in jobs.

    Attributes:
        name: name of the study.
        study: path of its file.
        out: folder for its results.
        count: number of jobs, each a shard.
        processes: processes of each job.
    """

    name: str
    study: Path
    out: Path
    count: int
    processes: int

    @property
    def merge(self) -> str:
        """The command that puts the shards together."""
        return f"cadgen merge {quote(str(self.out))} --out {quote(str(self.out))}"

    def explore(self, processes: str, shard: str) -> str:
        """The command of one job; both arguments as a shell has them."""
        named = f"cadgen explore {quote(str(self.study))} --out {quote(str(self.out))}"
        return f"{named} --processes {processes} --shard {shard}/{self.count}"


@dataclass(frozen=True)
class ClusterKind:
    """A kind of cluster.

    Attributes:
        code: name for `--cluster`.
        ending: ending of the script's name.
        text: function that makes the script.
        hand_in: function of the jobs and the script's path: the command that hands it in.
    """

    code: str
    ending: str
    text: Callable[[Jobs], str]
    hand_in: Callable[[Jobs, Path], str]


def _slurm(jobs: Jobs) -> str:
    return f"""#!/bin/bash
# Study {jobs.name} in {jobs.count} shards. Set account, partition and time limit as your cluster asks for them.
# A job that is killed or runs out of time goes on where it was: hand the script in again.
#SBATCH --job-name=cadgen-{jobs.name}
#SBATCH --array=1-{jobs.count}
#SBATCH --cpus-per-task={jobs.processes}
#SBATCH --requeue
set -euo pipefail
export OMP_NUM_THREADS=1 OPENBLAS_NUM_THREADS=1
{jobs.explore('"${SLURM_CPUS_PER_TASK}"', '"${SLURM_ARRAY_TASK_ID}"')}
"""


def _kubernetes(jobs: Jobs) -> str:
    shard = jobs.explore(str(jobs.processes), '"$((JOB_COMPLETION_INDEX + 1))"')
    return f"""# Study {jobs.name} in {jobs.count} shards. The image needs cadgen and the study's file; the volume
# claim is a folder that all jobs see, mounted where the results lie. A pod that is lost begins again where it was.
apiVersion: batch/v1
kind: Job
metadata:
  name: {dumps(_label(jobs.name))}
spec:
  completionMode: Indexed
  completions: {jobs.count}
  parallelism: {jobs.count}
  backoffLimit: {6 * jobs.count}
  template:
    spec:
      restartPolicy: OnFailure
      containers:
        - name: cadgen
          image: cadgen
          command: ["/bin/sh", "-c"]
          args: [{dumps(shard)}]
          env:
            - {{name: OMP_NUM_THREADS, value: "1"}}
            - {{name: OPENBLAS_NUM_THREADS, value: "1"}}
          resources:
            requests: {{cpu: "{jobs.processes}", memory: "{jobs.processes}Gi"}}
          volumeMounts:
            - {{name: study, mountPath: {dumps(str(jobs.out.parent))}}}
      volumes:
        - name: study
          persistentVolumeClaim: {{claimName: cadgen}}
"""


def _label(name: str) -> str:
    """A name as Kubernetes takes it: small letters, digits and hyphens, at most 63."""
    return "cadgen-" + "".join(sign if sign.isalnum() else "-" for sign in name.lower())[:50].strip("-")


def _sbatch(jobs: Jobs, script: Path) -> str:
    return f"sbatch --wait {quote(str(script))} && {jobs.merge}"


def _kubectl(jobs: Jobs, script: Path) -> str:
    waiting = f"kubectl wait --for=condition=complete --timeout=-1s job/{_label(jobs.name)}"
    return f"kubectl apply -f {quote(str(script))} && {waiting} && {jobs.merge}"


_CLUSTERS = Registry(
    "cluster",
    (
        ClusterKind("slurm", ".slurm", _slurm, _sbatch),
        ClusterKind("kubernetes", ".kubernetes.yaml", _kubernetes, _kubectl),
    ),
)
codes, kind_of = _CLUSTERS.codes, _CLUSTERS.kind_of
