"""Compares one recording in all ways and reports what is wrong with each."""

import shutil
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Callable

import evidence
import picture
import session
from recordings import traces
from recordings.frames import Comparison, FrameStore
from recordings.replay import Run, Way, replay
from recordings.traces import Recording


@dataclass
class Row:
    """The result of one recording in one way; its fields are those of result.json."""

    recording: str
    program: str
    way: str
    frames: int = 0  # of the first bare run
    steady: int = 0  # the frames on which two bare runs agree, which are compared
    wrong: list[dict] = field(default_factory=list)  # call, pixels, maximum, same_size
    maximum: int = 0  # largest difference in any steady frame, wrong or not
    status: int = 0
    bare_status: int = 0
    seconds: list[float] = field(default_factory=list)  # bare, this way
    evidence: dict = field(default_factory=dict)
    problems: list[str] = field(default_factory=list)  # other than wrong frames

    @property
    def passed(self) -> bool:
        return not self.problems and not self.wrong

    @property
    def reason(self) -> str:
        frames = []
        if self.wrong:
            worst = max(self.wrong, key=lambda d: d["pixels"])
            frames = [f"{len(self.wrong)} frames wrong, the worst at call {worst['call']}: "
                      f"{worst['pixels']} pixels"]
        return "; ".join(frames + self.problems)


def compare(recording: Recording, ways: list[Way], out: Path, timeout: float,
            show: Callable[[Row], None]) -> list[Row]:
    """Replays bare twice and once each way; calls `show` with each row as it is known."""
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    calls = traces.snapshot_calls(recording.trace)
    store = FrameStore(out / "bare.frames")
    rows: list[Row] = []

    def run(way: Way, take) -> Run:
        return replay(recording, calls, way, out / way.name, timeout, take)

    try:
        bare = run(Way(session.Mode("bare"), cold=True), store.add)
        repeat = Comparison(store, recording.wrong_pixels, step=recording.step)
        again = run(Way(session.Mode("again")), repeat.compare)
        steady = repeat.agreeing()
        head = Row(recording.name, recording.program, "bare", len(store), len(steady),
                   status=again.status, bare_status=bare.status)
        head.problems = _unfit(bare, again, store, steady)
        if head.problems:
            show(head)
            return [head]
        for way in ways:
            if way.name in recording.ways_left_out:
                continue
            seen = Comparison(store, recording.wrong_pixels, steady, recording.step)
            row = judge(recording, way, bare, run(way, seen.compare), seen, head)
            if row.wrong:
                _draw_worst(seen, out / way.name)
            rows.append(row)
            show(row)
    finally:
        store.close()
        (out / "bare.frames").unlink()
    return rows


def _unfit(bare: Run, again: Run, store: FrameStore, steady: set[int]) -> list[str]:
    """Returns why the bare host's runs cannot serve for comparison; empty if they can."""
    found = [run.problem for run in (bare, again) if run.problem]
    if bare.status != again.status:
        found.append(f"status {bare.status}, then {again.status}")
    if not steady:
        found.append(f"none of {len(store)} frames is the same in two runs")
    elif not store.any_shown:
        found.append("every frame is blank")
    return [f"bare host: {each}" for each in found]


def judge(recording: Recording, way: Way, bare: Run, run: Run, seen: Comparison,
          head: Row) -> Row:
    """Returns what is wrong with a run: its end, its frames, or what it drew them with. For one that was cut
    off it reports nothing else, as its last frame may be incomplete."""
    if run.cut_off:
        return Row(recording.name, recording.program, way.name, head.frames, head.steady,
                   status=run.status, bare_status=bare.status,
                   seconds=[round(bare.seconds, 2), round(run.seconds, 2)], problems=[run.problem])
    summary = evidence.summarise(run.stats)
    row = Row(recording.name, recording.program, way.name, head.frames, head.steady,
              [asdict(each) for each in seen.wrong()],
              max((each.maximum for each in seen.distances.values()), default=0),
              run.status, bare.status, [round(bare.seconds, 2), round(run.seconds, 2)], summary)
    if run.problem:
        row.problems.append(run.problem)
    if run.status != bare.status:
        last = " | ".join(run.log.strip().splitlines()[-2:])[-160:]
        row.problems.append(f"status {run.status}, bare {bare.status} ({last})")
    if seen.seen != head.frames:
        row.problems.append(f"{seen.seen} frames, bare {head.frames}")
    row.problems += _unproved(recording, way, summary)
    return row


def _unproved(recording: Recording, way: Way, summary: dict) -> list[str]:
    """Returns why the statistics do not show that the layer drew, and with the recording's programs."""
    if recording.refused is None:
        return []
    idle = way.mode.backend == "swrast" and not recording.least_programs and not summary["draws_rasterizer"]
    return (["the rasterizer drew nothing"] if idle else []) + \
        evidence.problems(summary, recording.least_programs, recording.refused)


def _draw_worst(seen: Comparison, folder: Path) -> None:
    """Draws bare, layer, and 16 times their difference, side by side."""
    if not seen.worst:
        return
    before, after = (frame.picture for frame in seen.worst)
    shown = [before, after]
    if (before.width, before.height) == (after.width, after.height):
        shown.append(picture.magnified(before, after))
    picture.write_png(folder / f"worst-{seen.worst[0].call}.png", picture.side_by_side(shown))
