#!/usr/bin/env python3
"""Joins the result files of shards into the report, and the exit status, of a whole run on one machine.

Ends with "N passed, N failed, N skipped", and status 0 or 1 accordingly. If shards are missing or contradict
one another, it ends with status 2 and a sentence for each reason. A damaged file counts as missing."""

import argparse
import json
import pathlib
import sys

import join
import of_differential
import of_piglit

KINDS = {kind.KIND: kind for kind in (of_piglit, of_differential)}
PIECES = 2  # the exit status if the shards are not one whole run


def results_of(document, measured):
    """Returns a report without the parts that differ from run to run."""
    if isinstance(document, dict):
        return {key: results_of(value, measured) for key, value in document.items()
                if key not in measured}
    if isinstance(document, list):
        return [results_of(value, measured) for value in document]
    return document


def differences(one, other, where=""):
    """Yields the differences of two documents, as words."""
    if isinstance(one, dict) and isinstance(other, dict):
        for key in sorted(set(one) | set(other)):
            yield from differences(one.get(key), other.get(key), "%s/%s" % (where, key))
    elif isinstance(one, list) and isinstance(other, list) and len(one) == len(other):
        for index, pair in enumerate(zip(one, other)):
            yield from differences(*pair, "%s/%d" % (where, index))
    elif one != other:
        yield "%s: %s and %s" % (where or "/", json.dumps(one), json.dumps(other))


def against(path, run, parts):
    """Compares with the report of another run; returns the exit status."""
    kind = KINDS[run["kind"]]
    try:
        theirs = json.loads(pathlib.Path(path).read_text())
    except (OSError, ValueError) as problem:
        print("merge: %s cannot be read: %s" % (path, problem), file=sys.stderr)
        return PIECES
    ours = json.loads(json.dumps(kind.document(run, parts)))
    unequal = list(differences(results_of(theirs, kind.MEASURED), results_of(ours, kind.MEASURED)))
    for text in unequal[:20]:
        print("merge: not as %s has it: %s" % (path, text), file=sys.stderr)
    if unequal:
        return PIECES
    print("as %s has it, %s aside" % (path, ", ".join(kind.MEASURED)))
    return 0


def finish(run, parts, folder=None, counts=None):
    """Writes and shows the report of a whole run; returns its exit status."""
    kind = KINDS[run["kind"]]
    document = kind.document(run, parts)
    sums = kind.counts(document)
    if folder:
        pathlib.Path(folder).mkdir(parents=True, exist_ok=True)
        for name, text in kind.files(document).items():
            (pathlib.Path(folder) / name).write_text(text)
    if counts:
        pathlib.Path(counts).write_text(json.dumps({"name": run["kind"], **sums}) + "\n")
    kind.show(document)
    print("%(passed)d passed, %(failed)d failed, %(skipped)d skipped" % sums, flush=True)
    return 1 if sums["failed"] else 0


def merge(paths, folder=None, counts=None, other=None):
    """Merges files; returns the exit status. other: a report that this one must equal"""
    results, notes = join.read_all(paths)
    try:
        parts, more = join.whole(results)
    except join.Incomplete as reason:
        for text in notes + reason.complaints:
            print("merge: %s" % text, file=sys.stderr)
        return PIECES
    for text in notes + more:
        print("merge: %s" % text, file=sys.stderr)
    if parts[0].run.get("kind") not in KINDS:
        print("merge: %s: no kind of run that is known here" % parts[0].where, file=sys.stderr)
        return PIECES
    status = finish(parts[0].run, parts, folder, counts)
    return against(other, parts[0].run, parts) or status if other else status


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--report", type=pathlib.Path, help="folder for the report")
    parser.add_argument("--counts", type=pathlib.Path, help="file for the counts, as JSON")
    parser.add_argument("--against", type=pathlib.Path, metavar="REPORT",
                        help="a report.json of the same run, made otherwise: 2 if its results differ")
    parser.add_argument("files", nargs="+", type=pathlib.Path)
    args = parser.parse_args()
    return merge(args.files, args.report, args.counts, args.against)


if __name__ == "__main__":
    sys.exit(main())
