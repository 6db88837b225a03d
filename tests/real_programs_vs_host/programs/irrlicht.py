"""Irrlicht's tutorials 10 and 11: its own ARB programs, and its normal and parallax map materials.

The sources come with the engine's documentation. They are changed in three ways only: the scene's
clock advances by a fixed step a frame instead of real time, the window need not have the focus, and
the last frame stays for a while.
"""

import gzip
import shutil
from pathlib import Path

from cases import Case, PrepareError, Program, shell

SOURCES = Path("/usr/share/doc/libirrlicht-dev")
FRAMES = 12
STEP_MS = 70

_LOOP = (f"device->getTimer()->stop(); device->getTimer()->setTime(0);\n"
         f"\tfor (irr::u32 step = 0; step < {FRAMES} && device->run();"
         f" device->getTimer()->setTime(++step * {STEP_MS}))")
# The last frame stays on the screen long enough to be seen most often.
_SHOT = f"driver->endScene();\n\t\tif (step + 1 == {FRAMES}) device->sleep(1500);"

# The example's folder, and the answers on standard input.
EXAMPLES = (("10.Shaders", "a\nn\n"), ("11.PerPixelLighting", "a\n"))
# Largest and mean difference, in 255ths. Dot products of vertex programs are summed as in fixed function
# (ir/semantics.h), and not as the host sums them, so that a position's last bits differ. Example 11 shifts its
# coordinates by a texture's heights, which makes much of that in a few pixels.
TOLERANCES = {"10": (2, 0.0002), "11": (160, 0.004)}


class Irrlicht(Program):
    def cases(self, work: Path) -> list[Case]:
        if not SOURCES.exists():
            raise PrepareError("libirrlicht-doc is not installed, or without its documentation")
        self._unpack_media(work / "media")
        cases = []
        for folder, answers in EXAMPLES:
            number = folder.split(".")[0]
            binary = work / f"ex{number}"
            if not binary.exists():
                source = work / f"ex{number}.cpp"
                source.write_text(self._patched(folder, work))
                shell(["g++", "-O1", "-w", "-I/usr/include/irrlicht", str(source), "-o",
                       str(binary), "-lIrrlicht"])
            maximum, mean = TOLERANCES[number]
            cases.append(Case(f"irrlicht-{number}", [str(binary)], stdin=answers, size=(640, 480), maximum=maximum,
                              mean=mean, least_programs=8))
        return cases

    @staticmethod
    def _unpack_media(media: Path) -> None:
        if media.exists():
            return
        media.mkdir(parents=True)
        for path in (SOURCES / "media").iterdir():
            if path.suffix == ".gz":
                (media / path.stem).write_bytes(gzip.decompress(path.read_bytes()))
            elif path.is_file():
                shutil.copy(path, media / path.name)

    @staticmethod
    def _patched(folder: str, work: Path) -> str:
        path = SOURCES / "examples" / folder / "main.cpp"
        packed = path.with_suffix(".cpp.gz")
        text = (gzip.decompress(packed.read_bytes()).decode(errors="replace") if packed.exists()
                else path.read_text(errors="replace"))
        changes = (("while(device->run())", _LOOP), ("device->isWindowActive()", "true"),
                   ("driver->endScene();", _SHOT), ('"../../media', f'"{work}/media'))
        for old, new in changes:
            if old not in text:
                raise PrepareError(f"{path}: no '{old}' to change; another version of the example?")
            text = text.replace(old, new)
        return text


PROGRAM = Irrlicht("irrlicht", ("libirrlicht-dev", "libirrlicht-doc", "g++", "xvfb",
                                "libgl1-mesa-dri"),
                   "tutorials 10 and 11: shader materials, normal and parallax maps, fog")
