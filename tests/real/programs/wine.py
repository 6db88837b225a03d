"""Wine's Direct3D 9 over its ARB back end: pixel shaders 1.1, 1.4, 2.0 and the fixed function.

data/tiles.cpp is a small Direct3D program of ours; Wine translates what it asks for into vertex and
fragment programs.
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
        binary, source = work / "tiles.exe", DATA / "tiles.cpp"
        if not binary.exists() or binary.stat().st_mtime < source.stat().st_mtime:
            shell(["x86_64-w64-mingw32-g++", "-O1", "-static", "-o", str(binary), str(source),
                   "-ld3d9", "-ld3dx9_43"])
        return [Case("wine-d3d9", ["wine", str(binary)], output="o.ppm", environment=environment,
                     least_programs=6)]

    def finish(self, work: Path) -> None:
        # Its status says only whether a server was there to end.
        subprocess.run(["wineserver", "-k"], env={**os.environ, **self._environment(work)},
                       check=False)

    @staticmethod
    def _environment(work: Path) -> dict[str, str]:
        return {"WINEPREFIX": str(work / "prefix"), "WINEARCH": "win64", "WINEDEBUG": "-all",
                "WINEDLLOVERRIDES": "mscoree,mshtml=;winemenubuilder.exe=d",
                "DISPLAY": os.environ.get("DISPLAY", "")}


PROGRAM = Wine("wine", ("wine", "wine64", "g++-mingw-w64-x86-64", "xvfb", "libgl1-mesa-dri"),
               "a Direct3D 9 program of ours through Wine's ARB shader back end")
