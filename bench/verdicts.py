"""The counts of a table of measured rows: a row beyond its bound is a failure."""

import contextlib
import io

MEANINGS = {"ok": "pass", "met": "pass", "OVER": "FAIL", "MISSED": "FAIL", "noisy": "skip", "unclear": "skip"}


def finish(rows):
    """Prints which rows are beyond their bounds, and the counts of those with bounds. Returns the exit status."""
    counts = dict.fromkeys(("pass", "FAIL", "skip"), 0)
    for row in rows:
        meaning = MEANINGS.get(row["verdict"])
        if meaning is None:  # without a bound
            continue
        counts[meaning] += 1
        if meaning == "FAIL":
            print(f"FAIL {row['name']}: {row.get('cost', row.get('figure')):.3f}, bound {row['bound']:g}")
        elif meaning == "skip":
            print(f"skip {row['name']}: too noisy to tell")
    print(f"{counts['pass']} passed, {counts['FAIL']} failed, {counts['skip']} skipped")
    return 1 if counts["FAIL"] else 0


def self_test():
    """Checks the status and the counts of planted rows."""
    for verdicts, status, counts in ((("ok", "met", ""), 0, "2 passed, 0 failed, 0 skipped"),
                                     (("ok", "noisy", "unclear"), 0, "1 passed, 0 failed, 2 skipped"),
                                     (("ok", "OVER"), 1, "1 passed, 1 failed, 0 skipped"),
                                     (("MISSED", "noisy"), 1, "0 passed, 1 failed, 1 skipped")):
        said = io.StringIO()
        rows = [{"name": f"row {i}", "verdict": verdict, "cost": 2.0, "bound": 1.0}
                for i, verdict in enumerate(verdicts)]
        with contextlib.redirect_stdout(said):
            found = finish(rows)
        if (found, said.getvalue().splitlines()[-1]) != (status, counts):
            raise SystemExit(f"{verdicts}: status {found}, {said.getvalue()}")
