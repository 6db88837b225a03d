#!/usr/bin/env python3
"""Tests the engines with quick jobs and jobs that die. GNU parallel is real, on this machine and with a stand-in for
ssh; Slurm has a stand-in for sbatch, which takes the options that are used.

try_ssh.sh and try_slurm.sh test the services themselves with the suites."""

import argparse
import contextlib
import io
import json
import os
import pathlib
import shlex
import stat
import sys
import tempfile
import unittest

import engines
import merge
import sharding

HERE = pathlib.Path(__file__).resolve().parent

# A suite whose job notes that it ran, and dies, hangs or fails as a file of its number says.
SUITE = '''
import os, pathlib, signal, sys
sys.path.insert(0, {here!r})
import merge_test, results
from shards import Shard
folder, extra, shard, path = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[4], sys.argv[6]
shard = Shard.parse(shard)
with open(folder / "ran", "a") as ran:
    ran.write("%d %s\\n" % (shard.index, extra))
plan = folder / ("plan-%d" % shard.index)
what = plan.read_text() if plan.exists() else ""
plan.unlink(missing_ok=True)
if what == "die":
    pathlib.Path(path).write_text('{{"schema": 1, "run": {{')
    os.kill(os.getpid(), signal.SIGKILL)
if what == "refuse":
    sys.exit(1)
result = merge_test.differential_result(shard, failing=(11,) if what == "fail" else ())
results.write(path, result)
'''

# Takes the options that engines.py passes to sbatch, and runs tasks one after another.
SBATCH = '''#!{python}
import os, subprocess, sys
options = dict(zip(sys.argv[1:], sys.argv[2:]))
assert "--wait" in sys.argv and "--parsable" in sys.argv
print("4711;cluster", flush=True)
status = 0
for index in options["--array"].split(","):
    with open(options["--output"].replace("%a", index), "ab") as log:
        status = max(status, abs(subprocess.run(
            [sys.argv[-1]] if os.access(sys.argv[-1], os.X_OK) else ["bash", sys.argv[-1]],
            env={{**os.environ, "SLURM_ARRAY_TASK_ID": index}}, cwd=options["--chdir"],
            stdout=log, stderr=log).returncode))
sys.exit(status)
'''

# The host `down` refuses each connection; commands for any other host run here.
SSH = '''#!/bin/bash
while [[ $1 == -* ]]; do case $1 in -[lpioFS]) shift 2 ;; *) shift ;; esac; done
host=$1
shift
[[ $1 == -- ]] && shift
[[ $host == down ]] && exit 255
echo "$host" >>{folder}/hosts
exec bash -c "$*"
'''


class Case(unittest.TestCase):
    engine = None
    extra = "object namespace pollution@program it's $HOME \"x\""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory(prefix="arbiter engines ")
        self.addCleanup(temporary.cleanup)
        self.folder = pathlib.Path(temporary.name)
        self.script("suite.py", SUITE.format(here=str(HERE)))
        self.args = argparse.Namespace(engine=self.engine, shards=5, hosts=":", engine_option=[],
                                       fresh=False, counts=None)
        import merge_test
        self.run_of = dict(merge_test.DIFFERENTIAL)

    def script(self, name, text):
        path = self.folder / name
        path.write_text(text)
        path.chmod(path.stat().st_mode | stat.S_IXUSR)
        return path

    def plan(self, **of):
        for index, what in of.items():
            (self.folder / ("plan-" + index[1:])).write_text(what)

    def run_engine(self):
        """Returns (exit status, shards that ran, output)."""
        (self.folder / "ran").write_text("")
        text = io.StringIO()
        command = [sys.executable, str(self.folder / "suite.py"), str(self.folder), self.extra]
        with contextlib.redirect_stdout(text), contextlib.redirect_stderr(text):
            status = sharding.run_engine(self.args, self.run_of, command, self.folder / "out")
        lines = (self.folder / "ran").read_text().splitlines()
        self.assertEqual({line.partition(" ")[2] for line in lines} - {self.extra}, set())
        return status, sorted(int(line.partition(" ")[0]) for line in lines), text.getvalue()

    def result(self, index):
        return self.folder / "out/shards" / ("shard-%d-of-5.json" % index)


class Common:
    """Tests for each engine."""

    def test_all_shards_and_their_sum(self):
        status, ran, text = self.run_engine()
        self.assertEqual((status, ran), (0, [1, 2, 3, 4, 5]), text)
        self.assertIn("25 passed, 0 failed, 0 skipped", text)
        report = json.loads((self.folder / "out/report.json").read_text())
        self.assertEqual(report["rows"][0]["programs"], 20)

    def test_a_failure_is_the_status_and_is_not_run_again(self):
        self.plan(_3="fail")
        self.assertEqual(self.run_engine()[:2], (1, [1, 2, 3, 4, 5]))
        status, ran, text = self.run_engine()
        self.assertEqual((status, ran), (1, []), text)
        self.assertIn("24 passed, 1 failed, 0 skipped", text)

    def test_what_died_is_said_and_alone_run_again(self):
        self.plan(_2="die", _4="refuse")
        status, _, text = self.run_engine()
        self.assertEqual(status, merge.PIECES)
        self.assertIn("without a whole result: 2, 4 of 5", text)
        self.assertFalse((self.folder / "out/report.json").exists())
        status, ran, text = self.run_engine()
        self.assertEqual((status, ran), (0, [2, 4]), text)

    def test_a_damaged_result_is_run_again(self):
        self.run_engine()
        data = self.result(3).read_bytes()
        self.result(3).write_bytes(data[:len(data) // 2])
        self.result(5).unlink()
        # The result of another shard has this one's name.
        self.result(1).write_bytes(self.result(2).read_bytes())
        status, ran, text = self.run_engine()
        self.assertEqual((status, ran), (0, [1, 3, 5]))
        self.assertIn("shard-3-of-5.json does not count: cut short", text)
        self.assertIn("shard-1-of-5.json is of shard 2/5", text)

    def test_results_of_another_run_are_none(self):
        self.run_engine()
        import merge_test
        self.run_of["sources"] = "changed"
        status, ran, text = self.run_engine()
        self.assertEqual(ran, [1, 2, 3, 4, 5])
        # The stand-in's results say that they belong to the old run.
        self.assertEqual(status, merge.PIECES, text)
        self.assertIn("is of another run (sources: d2 and changed)", text)
        self.run_of = dict(merge_test.DIFFERENTIAL)
        self.args.fresh = True
        self.assertEqual(self.run_engine()[:2], (0, [1, 2, 3, 4, 5]))
        self.assertEqual(self.run_engine()[:2], (0, [1, 2, 3, 4, 5]))


class Parallel(Common, Case):
    engine = "parallel"

    def test_a_host_that_is_down_is_gone_around(self):
        fake = self.script("ssh", SSH.format(folder=shlex.quote(str(self.folder))))
        link = pathlib.Path(tempfile.mkdtemp()) / "ssh"  # a path without blanks
        link.symlink_to(fake)
        self.addCleanup(link.parent.rmdir)
        self.addCleanup(link.unlink)
        self.args.hosts = "down,one,other"
        self.args.engine_option = ["--ssh", str(link)]
        status, ran, text = self.run_engine()
        self.assertEqual((status, ran), (0, [1, 2, 3, 4, 5]), text)
        self.assertEqual(set((self.folder / "hosts").read_text().split()), {"one", "other"})


class Slurm(Common, Case):
    engine = "slurm"

    def setUp(self):
        super().setUp()
        self.script("sbatch", SBATCH.format(python=sys.executable))
        before = os.environ["PATH"]
        os.environ["PATH"] = "%s:%s" % (self.folder, before)
        self.addCleanup(os.environ.__setitem__, "PATH", before)

    def test_it_is_said_where_to_look(self):
        text = self.run_engine()[2]
        self.assertIn("Slurm's job 4711, 5 tasks", text)
        self.assertTrue((self.folder / "out/shards/log/task-5.txt").exists())

    def test_a_refusal_is_none_of_its_jobs(self):
        self.script("sbatch", "#!/bin/sh\necho 'sbatch: error: no partition' >&2\nexit 1\n")
        status, ran, text = self.run_engine()
        self.assertEqual((status, ran), (merge.PIECES, []))
        self.assertNotIn("Slurm's job", text)


class Commands(unittest.TestCase):
    def test_a_result_is_fetched_by_its_whole_path(self):
        job = engines.Job("n", ["a", "{}/4"], "/f/shard-{}-of-4.json", "/r", "/l", ["a", "ssh -p 3 b"])
        words = engines.parallel_command(job, [2, 3])
        self.assertEqual(words[words.index("--return") + 1], "/f/shard-{}-of-4.json")
        self.assertEqual(words[words.index("--sshlogin") + 1], "a,ssh -p 3 b")
        self.assertEqual(words[-3:], [":::", "2", "3"])


class Options(unittest.TestCase):
    def parsed(self, *words):
        parser = argparse.ArgumentParser()
        sharding.add_options(parser)
        args = parser.parse_args(words)
        sharding.check(parser, args)
        return args

    def test_what_does_not_go_together_is_refused(self):
        self.assertEqual(str(self.parsed("--shard", "2/3").shard), "2/3")
        for words in (["--shard", "0/3"], ["--shard", "1/3", "--engine", "slurm", "--shards", "3"],
                      ["--engine", "slurm"], ["--shards", "3"], ["--result", "x"],
                      ["--engine", "slurm", "--shards", "3", "--hosts", "a"],
                      ["--engine", "parallel", "--shards", "0"], ["--engine", "other", "--shards", "2"]):
            with self.assertRaises(SystemExit), contextlib.redirect_stderr(io.StringIO()):
                self.parsed(*words)


if __name__ == "__main__":
    unittest.main()
