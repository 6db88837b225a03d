"""QuteMol builds its programs as text and, on a card that it does not know, loads the text "END".

It tests the error path, which must continue as on the bare host."""

from pathlib import Path

from cases import DATA, Case, Program


class QuteMol(Program):
    def cases(self, work: Path) -> list[Case]:
        return [Case("qutemol", ["qutemol", str(DATA / "molecule.pdb")], stop_after=10.0,
                     recorded=True, least_programs=0, refused=2)]


PROGRAM = QuteMol("qutemol", ("qutemol", "apitrace", "xvfb", "libgl1-mesa-dri"),
                  "program strings that are no programs, from a record")
