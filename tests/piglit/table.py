"""Writes a comparison's report for people: one Markdown table of every difference, with its reason."""

KINDS = ("unexpected", "explained", "flake", "stale")


def rows(report):
    """Returns (kind, test, bare, layer, reason) of every difference of one profile, the worst kind first."""
    out = []
    for test, result in report["unexpected"].items():
        out.append(("unexpected", test, result["bare"], result["layer"], "none known"))
    for test, result in report["explained"].items():
        out.append(("explained", test, result["bare"], result["layer"], result["reason"]))
    for test, result in report["flakes"].items():
        out.append(("flake", test, result["bare"], result["layer"],
                    "the same on both sides when run again"))
    for where, pattern in report["stale"].items():
        out.append(("stale", pattern, "", "", "%s: no such difference any more" % where))
    return sorted(out, key=lambda row: (KINDS.index(row[0]), row[1]))


def cell(text):
    return text.replace("|", "\\|")


def markdown(document):
    out = ["# piglit on the bare host and under the layer\n", "Set: %s.\n" % document["set"]]
    for report in document["reports"]:
        out.append("## Profile %s\n" % report["profile"])
        statuses = sorted(set(report["bare"]) | set(report["layer"]))
        out.append("| | %s |" % " | ".join(statuses))
        out.append("|---|" + "---|" * len(statuses))
        for side in ("bare", "layer"):
            counts = [str(report[side].get(status, 0)) for status in statuses]
            out.append("| %s | %s |" % (side, " | ".join(counts)))
        table = rows(report)
        if not table:
            out.append("\nNo difference.\n")
            continue
        out += ["", "| kind | test | bare host | under the layer | reason |", "|---|---|---|---|---|"]
        out += ["| %s |" % " | ".join(map(cell, row)) for row in table]
        out.append("")
    return "\n".join(out)
