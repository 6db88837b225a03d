"""The report of the differential suite, from the rows of all shards of a run.

A shard's content is {"ways": {name: row}}, with rows from row(), or from fault() if a way could not be run;
`faults` lists what is missing in the rasterizer's or the layer's statistics."""

import json

KIND = "differential"
# These vary from run to run: the layer chooses back ends by what it has drawn, and they differ in the last bits.
MEASURED = ("worst_error",)


def row(name, document):
    """Returns a way's row of a shard, from the report of the program that draws."""
    return {"name": name, "renderers": [document["renderer"]], "programs": document["programs"],
            "values": document["values"], "ill_conditioned": document["ill_conditioned"],
            "worst_error": document["worst_error"], "failures": document["failures"], "faults": []}


def fault(name, text):
    return {"name": name, "renderers": [], "programs": 0, "values": 0, "ill_conditioned": 0,
            "worst_error": 0, "failures": [], "faults": [text]}


def add(one, other):
    """Adds two rows of the same way."""
    return {"name": one["name"], "renderers": sorted(set(one["renderers"] + other["renderers"])),
            **{key: one[key] + other[key] for key in ("programs", "values", "ill_conditioned")},
            "worst_error": max(one["worst_error"], other["worst_error"]),
            "failures": sorted(one["failures"] + other["failures"], key=lambda f: f["seed"]),
            "faults": one["faults"] + [f for f in other["faults"] if f not in one["faults"]]}


def document(run, parts):
    ways = {}
    for part in parts:
        for name, its in part.content["ways"].items():
            ways[name] = add(ways[name], its) if name in ways else its
    rows = []
    for name in run["ways"]:
        if name not in ways:
            rows.append(fault(name, "no shard drew it"))
        else:
            rows.append(ways[name])
    failed = sum(len(r["failures"]) + (1 if r["faults"] else 0) for r in rows)
    passed = sum(r["programs"] - len(r["failures"]) for r in rows)
    return {"schema": 1, "rows": rows, "passed": passed, "failed": failed, "skipped": 0}


def line(its):
    text = "%-15s %-40.40s programs %4d  values %9d  ill-conditioned %7d  worst %.3f  failed %d" % (
        its["name"], ", ".join(its["renderers"]), its["programs"], its["values"],
        its["ill_conditioned"], its["worst_error"], len(its["failures"]))
    lines = [text] + ["  seed %d: %s" % (f["seed"], f["reason"]) for f in its["failures"]]
    return "\n".join(lines + ["  %s: %s" % (its["name"], text) for text in its["faults"]])


def show(its):
    for each in its["rows"]:
        print(line(each))


def counts(its):
    failures = [f"{row['name']}: seed {failure['seed']}: {failure['reason']}"
                for row in its["rows"] for failure in row["failures"]]
    failures += [f"{row['name']}: {fault}" for row in its["rows"] for fault in row["faults"]]
    return {**{key: its[key] for key in ("passed", "failed", "skipped")}, "failures": failures, "skips": {}}


def files(its):
    return {"report.json": json.dumps(its, indent=1) + "\n"}
