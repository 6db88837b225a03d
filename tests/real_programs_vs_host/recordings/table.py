"""Prints the comparison: a line for each run as it ends, and a table of all of them."""

from recordings.judge import Row
from recordings.replay import Way


def progress(row: Row) -> None:
    took = f"{row.seconds[0]:6.1f} s {row.seconds[1]:6.1f} s" if row.seconds else ""
    print(f"{'pass' if row.passed else 'FAIL'} {row.recording:26} {row.way:10} "
          f"{row.steady:4}/{row.frames:<4} {took:20} {row.reason}", flush=True)


def write(rows: list[Row], chosen: list[Way]) -> None:
    """Prints a line for each recording: its frames, how many are steady, and for each way the wrong ones."""
    names = [way.name for way in chosen]
    by_recording: dict[str, dict[str, Row]] = {}
    for row in rows:
        by_recording.setdefault(row.recording, {})[row.way] = row
    print(f"\n{'recording':28}{'frames':>7}{'steady':>7}" + "".join(f"{n:>11}" for n in names))
    for name, found in by_recording.items():
        first = next(iter(found.values()))
        cells = "".join(f"{_cell(found.get(n)):>11}" for n in names)
        print(f"{name:28}{first.frames:7}{first.steady:7}{cells}")
    print("A cell is the number of steady frames that are wrong; ! stands for another problem, whose "
          "reason is above.\n")


def _cell(row: Row | None) -> str:
    return "-" if row is None else f"{len(row.wrong)}{'!' if row.problems else ''}"
