"""Selects the recordings of a command: programs by name, given traces, or all."""

from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Callable, Iterator

from cases import PrepareError, Program
from programs import PROGRAMS
from recordings import traces
from recordings.traces import Recording

SHARED = Path(__file__).resolve().parents[4] / "shared" / "cases"
Make = Callable[[], Recording]


@dataclass(frozen=True)
class Choice:
    """`names` of programs and files `traces`; with neither, all programs and the traces of SHARED."""

    names: list[str]
    traces: list[Path]
    case: str | None  # only cases whose name contains this
    work: Path  # inputs and traces, kept between runs
    frames: int  # of a longer trace only this many first frames

    @property
    def everything(self) -> bool:
        return not self.names and not self.traces

    def unknown(self) -> list[str]:
        return [name for name in self.names if name not in PROGRAMS]

    def files(self) -> list[Path]:
        return self.traces + (sorted(SHARED.glob("*.trace")) if self.everything else [])

    def recordings(self) -> Iterator[Make]:
        """Yields the makers of the recordings, one at a time: a program's server ends before the next begins."""
        for path in self.files():
            for variant in traces.variants(path):
                if not self.case or self.case in path.stem + variant.suffix:
                    yield partial(traces.of_file, path.absolute(), self.work.absolute() / "files",
                                  self.frames, variant)
        for name in PROGRAMS if self.everything else self.names:
            yield from self._of_program(PROGRAMS[name])

    def _of_program(self, program: Program) -> Iterator[Make]:
        work = (self.work / program.name).absolute()
        work.mkdir(parents=True, exist_ok=True)
        try:
            for case in program.cases(work):
                if not self.case or self.case in case.name:
                    yield partial(traces.of_case, program.name, case, work,
                                  case.frames or self.frames)
        except PrepareError as error:
            yield partial(_raise, PrepareError(f"{program.name}: {error}"))
        finally:
            program.finish(work)


def _raise(error: PrepareError) -> Recording:
    raise error
