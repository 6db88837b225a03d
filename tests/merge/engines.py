"""Ways to run shards on several machines. Each takes the job's command, with {} for the shard's number,
and the numbers to run, and returns when all have ended; the results are in their files."""

import os
import pathlib
import shlex
import subprocess


class Job:
    """The command to run for each shard, and where.

    command: words, {} in them is the shard's number; result: the path of its file, with {} too; root: the
    folder that it runs in, which has the same path on each machine; log: a folder for the jobs' output;
    hosts: for `parallel`, names as ssh takes them, or `:` for this machine; options: more of the engine's own."""

    def __init__(self, name, command, result, root, log, hosts=(":",), options=()):
        self.name, self.command, self.result = name, command, str(result)
        self.root, self.log = pathlib.Path(root), pathlib.Path(log)
        self.hosts, self.options = list(hosts), list(options)


def parallel_command(job, numbers):
    """Runs GNU parallel over ssh, one shard for each machine at a time; a failed shard is retried on another machine.

    A result is fetched from a machine that does not share the folder. --return takes its whole path, as
    one with /./ in it would be looked up in the home folder there."""
    remote = [] if job.hosts == [":"] else ["--return", job.result]
    return ["parallel", "--will-cite", "--jobs", "1", "--sshlogin", ",".join(job.hosts),
            "--workdir", str(job.root), *remote, "--line-buffer",
            "--tagstring", "shard {}", "--joblog", str(job.log / "parallel.log"),
            "--retries", str(min(len(job.hosts), 3)), *job.options,
            " ".join(shlex.quote(word) for word in job.command), ":::", *map(str, numbers)]


def run_parallel(job, numbers):
    # The command is quoted for this shell, whatever the user's own is.
    return subprocess.run(parallel_command(job, numbers), stdin=subprocess.DEVNULL,
                          env={**os.environ, "SHELL": "/bin/bash"}).returncode


def slurm_script(job):
    words = (shlex.quote(word).replace("{}", "'\"$SLURM_ARRAY_TASK_ID\"'") for word in job.command)
    return "#!/bin/bash\n# One task of the array is one shard.\nexec %s\n" % " ".join(words)


def slurm_command(job, numbers):
    """Returns a job array's command, for machines that Slurm chooses and that share the folder."""
    return ["sbatch", "--wait", "--parsable", "--requeue", "--job-name", job.name,
            "--array", ",".join(map(str, numbers)), "--chdir", str(job.root),
            "--output", str(job.log / "task-%a.txt"), "--open-mode", "append", *job.options,
            str(job.log / "task.sh")]


def run_slurm(job, numbers):
    (job.log / "task.sh").write_text(slurm_script(job))
    submitted = subprocess.Popen(slurm_command(job, numbers), stdin=subprocess.DEVNULL,
                                 stdout=subprocess.PIPE, text=True)
    number = submitted.stdout.readline().strip().partition(";")[0]
    if not number:
        return submitted.wait()
    print("Slurm's job %s, %d tasks; what they say: %s/task-*.txt" % (number, len(numbers), job.log),
          flush=True)
    try:
        return submitted.wait()
    except KeyboardInterrupt:
        subprocess.run(["scancel", number])
        raise


ENGINES = {"parallel": run_parallel, "slurm": run_slurm}
