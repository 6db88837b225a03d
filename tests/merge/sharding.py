"""Shared parts of the suites' runners: options for a part of a run, and for a whole run on many machines."""

import argparse
import pathlib
import sys

import engines
import join
import merge
import results
from shards import WHOLE, Shard

ROOT = pathlib.Path(__file__).resolve().parents[2]


def shard_option(text):
    try:
        return Shard.parse(text)
    except ValueError as problem:
        raise argparse.ArgumentTypeError(str(problem)) from None


def count_option(text):
    if not text.isdecimal() or not 1 <= int(text) <= 10000:
        raise argparse.ArgumentTypeError("%r: a count from 1 to 10000" % text)
    return int(text)


def add_options(parser):
    group = parser.add_argument_group("on several machines (docs/driver/shards.md)")
    group.add_argument("--shard", type=shard_option, metavar="I/N",
                       help="only this part, into a result file that tests/merge/merge.py joins")
    group.add_argument("--result", type=pathlib.Path, help="that file, in the results' folder without")
    group.add_argument("--engine", choices=sorted(engines.ENGINES),
                       help="run all shards with GNU parallel over ssh or as a Slurm job array, and "
                            "merge; again, only those that have no whole result")
    group.add_argument("--shards", type=count_option, metavar="N", help="how many, of an engine")
    group.add_argument("--hosts", default=":", help="of parallel: A,B,… as ssh takes them; : is this one")
    group.add_argument("--engine-option", action="append", default=[], metavar="OPTION",
                       help="given to parallel or sbatch as it is, such as --partition=long")
    group.add_argument("--fresh", action="store_true", help="of an engine: run shards with a result too")


def check(parser, args):
    if args.shard and args.engine:
        parser.error("--shard is one part, --engine runs all of them")
    if bool(args.engine) != bool(args.shards):
        parser.error("--engine and --shards go together")
    if args.result and not args.shard:
        parser.error("--result is of one --shard")
    if args.engine == "slurm" and args.hosts != ":":
        parser.error("Slurm chooses the hosts: --engine-option=--nodelist=… or SBATCH_PARTITION")


def result_path(folder, shard):
    return pathlib.Path(folder).resolve() / "shards" / ("shard-%s-of-%d.json" % (shard.index, shard.of))


def pieces_folder(folder, args):
    """Returns a part's working folder, as several parts may run on one machine."""
    if not args.shard:
        return folder
    return folder / "shards" / ("work-%d-of-%d" % (args.shard.index, args.shard.of))


def wanting(run, shards, folder):
    """Returns the numbers of a run's shards without a complete result. Removes results of other runs, and
    prints why."""
    numbers = []
    for index in range(1, shards + 1):
        shard = Shard(index, shards)
        path = result_path(folder, shard)
        if path.exists():
            found, notes = join.read_all([path])
            if found and found[0].run != run:
                notes.append("%s is of another run (%s)" % (path, join.difference(found[0].run, run)))
            elif found and str(found[0].shard) != str(shard):
                notes.append("%s is of shard %s" % (path, found[0].shard))
            if not notes:
                continue
            print("\n".join(notes), file=sys.stderr)
            path.unlink()
        numbers.append(index)
    return numbers


def run_engine(args, run, command, folder):
    """Runs all shards that have no complete result yet and merges them; returns the exit status."""
    paths = [result_path(folder, Shard(index, args.shards)) for index in range(1, args.shards + 1)]
    if args.fresh:
        for path in paths:
            path.unlink(missing_ok=True)
    numbers = wanting(run, args.shards, folder)
    if numbers:
        print("%d of %d shards to run: %s" % (len(numbers), args.shards, " ".join(map(str, numbers))),
              flush=True)
        template = str(paths[0]).replace("shard-1-of", "shard-{}-of")
        log = paths[0].parent / "log"
        log.mkdir(parents=True, exist_ok=True)
        job = engines.Job("arbiter-" + run["kind"],
                          [*command, "--shard", "{}/%d" % args.shards, "--result", template], template,
                          ROOT, log, args.hosts.split(","), args.engine_option)
        status = engines.ENGINES[args.engine](job, numbers)
        numbers = wanting(run, args.shards, folder)
        if numbers:
            print("%s ended with %d; without a whole result: %s of %d. The same command again runs "
                  "those alone." % (args.engine, status, ", ".join(map(str, numbers)), args.shards),
                  file=sys.stderr)
            return merge.PIECES
    return merge.merge(paths, folder, args.counts)


def main(args, run, work, command, folder):
    """Executes a run by its options; returns the exit status.

    run: the description, the same in each of its shards; work: a function of a Shard that returns (content,
    seconds of its parts), or None if it could not be done; command: the command line of the same run,
    for an engine; folder: for the report."""
    if args.engine:
        return run_engine(args, run, command, folder)
    shard = args.shard or WHOLE
    path = args.result or result_path(folder, shard)
    if args.shard:
        path.unlink(missing_ok=True)  # a file of another run must not remain
    done = work(shard)
    if done is None:
        return 1
    result = results.Result(run, shard, *done)
    if not args.shard:
        return merge.finish(run, [result], folder, args.counts)
    results.write(path, result)
    print("shard %s: %s" % (shard, path), flush=True)
    return 0
