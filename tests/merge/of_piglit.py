"""The report of piglit on the bare host and under the layer, from the tables of all shards of a run.

A shard's content is {"bare": {test: status}, "profiles": {profile: {"layer": {test: status}, "flakes":
{test: [bare, layer]}, "skips": {test: reason}}}}. The whole run is judged: an expectation is stale if no shard saw its
difference."""

import collections
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "piglit"))

import expectations
import table

KIND = "piglit"
MEASURED = ("seconds",)  # varies from run to run


def report(profile, bare, layer, flaky, reasons, seconds, is_part):
    """Returns the report of one profile. flaky: tests whose difference did not persist; reasons: of the layer's skips;
    is_part: tests were chosen by name, so that an unused expectation means nothing."""
    rows = expectations.load(profile)
    explained, unexpected = expectations.judge(expectations.differences(bare, layer), rows)
    flakes = {key: unexpected.pop(key) for key in list(unexpected) if key in flaky}
    unused = [] if is_part else expectations.unused_rows(rows, set(bare) | set(layer))
    skips = collections.Counter(reasons.get(test, "no reason is given") for test, status in layer.items()
                                if status == "skip" and bare.get(test) == "skip")
    skipped = sum(skips.values())
    return {
        "profile": profile, "seconds": round(seconds, 1),
        "bare": collections.Counter(bare.values()), "layer": collections.Counter(layer.values()),
        "explained": {k: {"bare": bare.get(k, "missing"), "layer": layer.get(k, "missing"),
                          "reason": reason} for k, reason in explained.items()},
        "unexpected": {k: {"bare": b, "layer": l} for k, (b, l) in unexpected.items()},
        "flakes": {k: {"bare": b, "layer": l} for k, (b, l) in flakes.items()},
        "stale": {row.where: row.pattern for row in unused}, "skips": dict(skips.most_common()),
        "passed": len(set(bare) | set(layer)) - len(unexpected) - skipped,
        "failed": len(unexpected) + len(unused), "skipped": skipped,
    }


def document(run, parts):
    def joined(table_of):
        every = {key: value for part in parts for key, value in table_of(part).items()}
        return {key: every[key] for key in sorted(every)}

    bare = joined(lambda part: part.content["bare"])
    reports = []
    for profile in run["profiles"]:
        layer, flaky, reasons = (joined(lambda part: part.content["profiles"][profile].get(kind, {}))
                                 for kind in ("layer", "flakes", "skips"))
        seconds = sum(part.seconds[profile] for part in parts)
        reports.append(report(profile, bare, layer, flaky, reasons, seconds, bool(run["filter"])))
    return {"schema": 2, "set": run["set"], "reports": reports}


def show_one(its):
    print("\nprofile %s (%.0f s)" % (its["profile"], its["seconds"]))
    for side in ("bare", "layer"):
        print("  %-6s %s" % (side, "  ".join("%s %d" % pair for pair in sorted(its[side].items()))))
    for kind, test, bare, layer, reason in table.rows(its):
        results = ": %s on the bare host, %s under the layer" % (bare, layer) if bare else ""
        print("  %-11s %s%s (%s)" % (kind, test, results, reason))
    sys.stdout.flush()


def show(its):
    for each in its["reports"]:
        show_one(each)
    print()


def counts(its):
    sums = {key: sum(each[key] for each in its["reports"]) for key in ("passed", "failed", "skipped")}
    failures = []
    for each in its["reports"]:
        failures += [f"{each['profile']}: {test}: {sides['bare']} on the bare host, {sides['layer']} under the layer"
                     for test, sides in each["unexpected"].items()]
        failures += [f"{each['profile']}: {where}: no such difference any more" for where in each["stale"]]
    skips = sum((collections.Counter(each["skips"]) for each in its["reports"]), collections.Counter())
    return {**sums, "failures": failures, "skips": dict(skips.most_common())}


def files(its):
    return {"report.json": json.dumps(its, indent=1) + "\n", "report.md": table.markdown(its)}
