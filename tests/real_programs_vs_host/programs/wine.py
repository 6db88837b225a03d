"""Wine's Direct3D 8 and 9 over its ARB back end: pixel shaders 1.1, 1.4, 2.0 and the fixed function.

data/tiles.cpp and data/stages.cpp are small Direct3D programs of the project; Wine translates their
state and shaders into vertex and fragment programs.
"""

import os
import subprocess
from pathlib import Path

from cases import DATA, Case, Program, shell

KEY = r"HKCU\Software\Wine\Direct3D"


class Wine(Program):
    def cases(self, work: Path) -> list[Case]:
        environment = self._environment(work)
        if not (work / "prefix" / "ready").exists():
            shell(["wine", "wineboot", "-i"], environment=environment)
            for name, kind, value in (("shader_backend", "REG_SZ", "arb"),
                                      ("MaxVersionGL", "REG_DWORD", "131073")):
                shell(["wine", "reg", "add", KEY, "/v", name, "/t", kind, "/d", value, "/f"],
                      environment=environment)
            shell(["wineserver", "-w"], environment=environment)
            (work / "prefix" / "ready").touch()
        tiles = self._compiled(work, "tiles", ["-ld3d9", "-ld3dx9_43"])
        stages = self._compiled(work, "stages", [])
        return [Case("wine-d3d9", ["wine", str(tiles)], output="o.ppm", least_programs=6,
                     environment=environment),
                Case("wine-d3d8", ["wine", str(stages)], environment=environment, recorded=True,
                     least_programs=4)]

    @staticmethod
    def _compiled(work: Path, name: str, libraries: list[str]) -> Path:
        binary, source = work / f"{name}.exe", DATA / f"{name}.cpp"
        changed = max(path.stat().st_mtime for path in (source, DATA / "tiled.h"))
        if not binary.exists() or binary.stat().st_mtime < changed:
            shell(["x86_64-w64-mingw32-g++", "-O1", "-static", "-o", str(binary), str(source),
                   *libraries])
        return binary

    def finish(self, work: Path) -> None:
        # The status only tells whether there was a server to end.
        subprocess.run(["wineserver", "-k"], env={**os.environ, **self._environment(work)},
                       check=False)

    @staticmethod
    def _environment(work: Path) -> dict[str, str]:
        return {"WINEPREFIX": str(work / "prefix"), "WINEARCH": "win64", "WINEDEBUG": "-all",
                "WINEDLLOVERRIDES": "mscoree,mshtml=;winemenubuilder.exe=d",
                "DISPLAY": os.environ.get("DISPLAY", "")}


PROGRAM = Wine("wine", ("wine", "wine64", "g++-mingw-w64-x86-64", "xvfb", "libgl1-mesa-dri"),
               "Direct3D 8 and 9 programs of the project through Wine's ARB shader back end")
