"""Joins results of shards to those of the whole run, or tells why they do not fit."""

from results import Damaged, read


class Incomplete(Exception):
    """The shards are not a whole run; has a sentence for each reason, and the shards without a result."""

    def __init__(self, complaints, missing=()):
        super().__init__("; ".join(complaints))
        self.complaints, self.missing = complaints, list(missing)


def difference(one, other):
    """Returns the first field in which two descriptions of runs differ, as words."""
    for field in sorted(set(one) | set(other)):
        if one.get(field) != other.get(field):
            return "%s: %s and %s" % (field, one.get(field), other.get(field))
    return ""


def read_all(paths):
    """Returns (results, notes): a damaged or missing file has no result, but a note."""
    found, notes = [], []
    for path in paths:
        try:
            found.append(read(path))
        except Damaged as problem:
            notes.append("%s does not count: %s" % (path, problem))
        except OSError as problem:
            notes.append("%s does not count: %s" % (path, problem.strerror))
    return found, notes


def whole(results):
    """Returns (results in the order of their shards, notes). Raises Incomplete if they contradict each other or one
    is missing."""
    if not results:
        raise Incomplete(["there is no whole result file"])
    first = results[0]
    complaints, notes, by_index = [], [], {}
    for result in results:
        if result.run != first.run:
            complaints.append("%s and %s are of different runs (%s)" % (
                first.where, result.where, difference(first.run, result.run)))
        elif result.shard.of != first.shard.of:
            complaints.append("%s is one of %d shards, %s one of %d" % (
                first.where, first.shard.of, result.where, result.shard.of))
        elif result.shard.index not in by_index:
            by_index[result.shard.index] = result
        elif by_index[result.shard.index].content != result.content:
            complaints.append("%s and %s are both shard %s, and do not say the same" % (
                by_index[result.shard.index].where, result.where, result.shard))
        else:
            notes.append("%s and %s are both shard %s and say the same: counted once" % (
                by_index[result.shard.index].where, result.where, result.shard))
    missing = [index for index in range(1, first.shard.of + 1) if index not in by_index]
    if missing:
        complaints.append("of %d shards these are missing: %s" % (
            first.shard.of, ", ".join(map(str, missing))))
    if complaints:
        raise Incomplete(complaints, missing)
    return [by_index[index] for index in sorted(by_index)], notes
