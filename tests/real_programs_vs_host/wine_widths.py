#!/usr/bin/env python3
"""Compares 64-bit and 32-bit Windows programs under one installation of the layer with bare Wine.

  wine_widths.py [--arbiter COMMAND] [--clients FOLDER] [--out DIR]

They use OpenGL's assembly programs through opengl32, and Direct3D 8 and 9 through Wine's ARB back end. Each client is
built for both word sizes (or is in FOLDER as NAME.64.exe and NAME.32.exe) and runs in a 64-bit Windows, which has
both, and in a 32-bit one. It needs wine, wine64, wine32:i386, Xvfb, and the layer for both word sizes.
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

import picture
import session
from cases import DATA, PrepareError, shell

KEY = r"HKCU\Software\Wine\Direct3D"
COMPILERS = {64: "x86_64-w64-mingw32-g++", 32: "i686-w64-mingw32-g++"}
# By name: the libraries it is linked with, its arguments, and the least number of programs that it loads.
CLIENTS = {"opengl32": (["-lopengl32", "-lgdi32"], [], 5),
           "tiles": (["-ld3d9", "-ld3dx9_43"], [], 6),
           "stages": ([], ["o.ppm"], 4)}
WINDOWS = {"win64": (64, 32), "win32": (32,)}  # the word sizes of the programs that each runs
BACKENDS = ("host", "swrast")
MOST = 2  # the allowed difference of pixels, in 255ths
OTHERS = 4  # the number of pixels that may differ more, where a shader's comparison goes the other way


def environment(prefix: Path, windows: str, display: str) -> dict[str, str]:
    made = {**os.environ, "LIBGL_ALWAYS_SOFTWARE": "1", "DISPLAY": display,
            "WINEPREFIX": str(prefix), "WINEARCH": windows, "WINEDEBUG": "-all",
            "WINEDLLOVERRIDES": "mscoree,mshtml=;winemenubuilder.exe=d"}
    for name in ("WAYLAND_DISPLAY", "XAUTHORITY"):
        made.pop(name, None)
    return made


def build_clients(folder: Path) -> None:
    for name, (libraries, _, _) in CLIENTS.items():
        for width, compiler in COMPILERS.items():
            shell([compiler, "-std=c++17", "-O1", "-static", "-o", str(folder / f"{name}.{width}.exe"),
                   str(DATA / f"{name}.cpp"), *libraries])


def drawn(folder: Path, command: list, setting: dict[str, str]) -> picture.Picture:
    """Returns the picture that the command writes to o.ppm."""
    folder.mkdir(parents=True)
    with open(folder / "log", "wb") as log:
        subprocess.run(command, cwd=folder, env=setting, stdin=subprocess.DEVNULL, stdout=log, stderr=log,
                       timeout=300, check=True)
    said = (folder / "log").read_text(errors="replace")
    if "ld.so" in said:
        raise PrepareError(f"the loader complains: {said[-300:]}")
    return picture.read(folder / "o.ppm")


def problem(bare: picture.Picture, layer: picture.Picture, stats: list[dict], least: int) -> str:
    """Returns what is wrong; empty if nothing is."""
    programs = sum(not program["error"] for one in stats for program in one["programs"])
    draws = sum(one["draws"][path] for one in stats for path in ("host_glsl", "host_assembly", "rasterizer"))
    apart = picture.compare(bare, layer)
    if bare.is_blank():
        return "bare Wine draws nothing"
    if not apart.same_size or apart.pixels_over > OTHERS:
        return f"more than {MOST} of 255 apart in {apart.pixels_over} pixels"
    if programs < least or draws == 0:
        return f"the layer compiled {programs} programs, of {least}, and drew {draws} times"
    return ""


def compared(folder: Path, command: list, setting: dict[str, str], arbiter: str, least: int) -> str:
    """Returns what is wrong with a client under either back end; empty if nothing is."""
    try:
        bare = drawn(folder / "bare", command, setting)
        for backend in BACKENDS:
            layered = [arbiter, "run", "--backend", backend, "--stats", str(folder / backend / "stats.%p.json"),
                       "--", *command]
            layer = drawn(folder / backend, layered, setting)
            if wrong := problem(bare, layer, session.read_stats(folder / backend), least):
                return f"{backend}: {wrong}"
    except (PrepareError, picture.PictureError, OSError, subprocess.SubprocessError) as failure:
        return f"{failure}; see {folder}"
    return ""


def run_windows(windows: str, clients: Path, arbiter: str, out: Path, display: str) -> list[str]:
    """Runs the clients in one installation of Windows; returns the names of those that fail."""
    setting = environment(out / windows / "prefix", windows, display)
    failed = []
    (out / windows).mkdir()
    shell(["wine", "wineboot", "-i"], environment=setting, timeout=600)
    try:
        for name, kind, value in (("shader_backend", "REG_SZ", "arb"), ("MaxVersionGL", "REG_DWORD", "131073")):
            shell(["wine", "reg", "add", KEY, "/v", name, "/t", kind, "/d", value, "/f"], environment=setting)
        for width in WINDOWS[windows]:
            for name, (_, arguments, least) in CLIENTS.items():
                folder = out / windows / f"{name}.{width}"
                command = ["wine", str(clients / f"{name}.{width}.exe"), *arguments]
                wrong = compared(folder, command, setting, arbiter, least)
                print(f"{'fail' if wrong else 'pass'}  {windows}  {name:8} of {width} bits  {wrong}", flush=True)
                if wrong:
                    failed.append(f"{windows} {name} {width}")
    finally:
        subprocess.run(["wineserver", "-k"], env=setting, check=False)
    return failed


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--arbiter", default="arbiter", help="the command (default: the installed one)")
    parser.add_argument("--clients", type=Path, help="folder of clients that are built")
    parser.add_argument("--build-clients", type=Path, metavar="FOLDER", help="build the clients there and stop")
    parser.add_argument("--out", type=Path, help="pictures and logs (default: a temporary folder)")
    options = parser.parse_args()
    if options.build_clients:
        options.build_clients.mkdir(parents=True, exist_ok=True)
        build_clients(options.build_clients)
        return 0
    out = (options.out or Path(tempfile.mkdtemp(prefix="arbiter-wine-"))).absolute()
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir(parents=True)
    clients = options.clients.absolute() if options.clients else out
    if not options.clients:
        build_clients(out)
    failed = []
    count = len(CLIENTS) * sum(len(widths) for widths in WINDOWS.values())
    with session.XServer(out / "screen") as server:
        for windows in WINDOWS:
            failed += run_windows(windows, clients, options.arbiter, out, server.display)
    print(f"wine: pictures: {out}")
    print(f"{count - len(failed)} passed, {len(failed)} failed, 0 skipped")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
