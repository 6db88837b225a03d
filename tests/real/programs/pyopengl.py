"""Clients of ours in Python: small scenes that use programs in the ways that larger ones do.

data/pyopengl has a file each. They draw a fixed number of frames and end.
"""

from pathlib import Path

from cases import DATA, Case, Program

# Name, and the fragment programs that it draws with.
CLIENTS = (("feedback", 2), ("lists", 1), ("buffers", 1), ("framebuffers", 3), ("targets", 4),
           ("mixed", 2), ("windows", 1))


class PyOpenGl(Program):
    def cases(self, work: Path) -> list[Case]:
        # Debian's own python3 is the one that finds Debian's python3-opengl.
        return [Case(f"pyopengl-{name}", ["/usr/bin/python3", str(DATA / "pyopengl" / f"{name}.py")],
                     environment={"PYTHONDONTWRITEBYTECODE": "1"}, recorded=True,
                     least_programs=programs) for name, programs in CLIENTS]


PROGRAM = PyOpenGl("pyopengl", ("python3-opengl", "libglut3.12", "apitrace", "xvfb",
                                "libgl1-mesa-dri"),
                   "seven clients of ours: feedback, lists, buffers, framebuffers, textures, contexts")
