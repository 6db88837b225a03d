#!/usr/bin/env python3
"""Tests Direct3D 9's shader models 2.x and 3.0: Wine's ARB back end under the layer against its GLSL one without.

  shader_models.py --build DIR [--out DIR]
  shader_models.py --packages          the packages that it needs

Under a profile with NVIDIA's options (nv40), Wine's ARB back end writes these models in their languages: branches,
loops, subroutines, textures in vertex programs, facing, gradients, explicit levels of detail. data/models.cpp draws
a tile of each. The bare host runs the same client by GLSL, which Wine writes with other code. A tile may differ by
a level in any pixel.
"""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import picture
import session
from cases import DATA, PrepareError, shell

PACKAGES = ("wine", "wine64", "g++-mingw-w64-x86-64", "xvfb", "libgl1-mesa-dri")
KEY = r"HKCU\Software\Wine\Direct3D"
TILE, COLUMNS = 128, 4
TILES = ("facing: front", "facing: back", "inputs in a loop", "loop with break", "texldl", "subroutine",
         "vertices: loop, if", "vertices: texture", "gradients", "branches", "dependent lookups", "loops in loops")
MOST = 1  # in 255ths
BACKENDS = ("auto", "host")


def environment(prefix: Path, display: str) -> dict[str, str]:
    made = {**os.environ, "LIBGL_ALWAYS_SOFTWARE": "1", "DISPLAY": display,
            "WINEPREFIX": str(prefix), "WINEARCH": "win64", "WINEDEBUG": "-all",
            "WINEDLLOVERRIDES": "mscoree,mshtml=;winemenubuilder.exe=d"}
    for name in ("WAYLAND_DISPLAY", "XAUTHORITY"):
        made.pop(name, None)
    return made


def drawn(folder: Path, back_end: str, command: list, setting: dict[str, str]) -> picture.Picture:
    """Returns the picture that the command writes to o.ppm, with Wine's back end `arb` or `glsl`."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "o.ppm").unlink(missing_ok=True)
    # With a core context, which newer versions get, Wine only has its GLSL back end.
    for name, kind, value in (("shader_backend", "REG_SZ", back_end), ("MaxVersionGL", "REG_DWORD", "131073")):
        shell(["wine", "reg", "add", KEY, "/v", name, "/t", kind, "/d", value, "/f"], environment=setting)
    with open(folder / "log", "wb") as log:
        subprocess.run(command, cwd=folder, env=setting, stdin=subprocess.DEVNULL, stdout=log, stderr=log,
                       timeout=300, check=True)
    return picture.read(folder / "o.ppm")


def tile(whole: picture.Picture, index: int) -> picture.Picture:
    left, top = index % COLUMNS * TILE, index // COLUMNS * TILE
    rows = (whole.rgb[(y * whole.width + left) * 3:(y * whole.width + left + TILE) * 3]
            for y in range(top, top + TILE))
    return picture.Picture(TILE, TILE, b"".join(rows))


def steps(build: Path, out: Path) -> int:
    client = out / "models.exe"
    shell(["x86_64-w64-mingw32-g++", "-std=c++17", "-O1", "-static", "-o", str(client), str(DATA / "models.cpp"),
           "-ld3d9", "-ld3dx9_43"])
    with session.XServer(out / "screen") as server:
        setting = environment(out / "prefix", server.display)
        shell(["wine", "wineboot", "-i"], environment=setting)
        try:
            bare = drawn(out / "bare", "glsl", ["wine", client, "inline"], setting)
            command = [build / "src/apps/tools/arbiter", "run", "--profile", "nv40", "--", "wine", client]
            layers = {}
            for backend in BACKENDS:
                folder = out / backend
                layers[backend] = drawn(folder, "arb", command,
                                        {**setting, "ARBITER_BACKEND": backend,
                                         "ARBITER_STATS": str(folder / "stats.%p.json")})
        finally:
            subprocess.run(["wineserver", "-k"], env=setting, check=False)
    rows = []
    for backend, layer in layers.items():
        picture.write_png(out / f"bare_{backend}_difference.png",
                          picture.side_by_side([bare, layer, picture.magnified(bare, layer)]))
        rows += compared(backend, bare, layer)
        programs = sum(len(stats["programs"]) for stats in session.read_stats(out / backend))
        rows.append({"backend": backend, "tile": "programs", "result": "pass" if programs else "fail"})
        if not programs:
            print(f"fail  {backend}: the layer compiled no program: Wine's ARB back end did not draw")
    (out / "report.json").write_text(json.dumps(rows, indent=1) + "\n")
    failed = sum(row["result"] == "fail" for row in rows)
    print(f"shader models: pictures: {out}")
    print(f"{len(rows) - failed} passed, {failed} failed, 0 skipped")
    return 1 if failed else 0


def compared(backend: str, bare: picture.Picture, layer: picture.Picture) -> list[dict]:
    rows = []
    for index, name in enumerate(TILES):
        of_bare = tile(bare, index)
        difference = picture.compare(of_bare, tile(layer, index))
        result = "fail" if difference.maximum > MOST or of_bare.is_blank() else "pass"
        rows.append({"backend": backend, "tile": name, "maximum": difference.maximum,
                     "pixels": difference.pixels, "result": result})
        print(f"{result}  {backend:4}  {name:20} up to {difference.maximum} of 255 apart in "
              f"{difference.pixels} pixels", flush=True)
    return rows


def main() -> int:
    options, out = session.command_line(__doc__, PACKAGES, "models")
    for backend in BACKENDS:
        shutil.rmtree(out / backend, ignore_errors=True)
    try:
        return steps(options.build, out)
    except (PrepareError, session.SessionError, picture.PictureError, OSError,
            subprocess.SubprocessError) as failure:
        print(f"shader models: FAIL: {failure}; see {out}")
        return 1


if __name__ == "__main__":
    sys.exit(main())
