"""Clients of the project in Python: small scenes that use programs as larger applications do.

data/pyopengl has a file for each. They draw a fixed number of frames and end.
"""

from pathlib import Path

from cases import DATA, Case, Program

# The name, the fragment programs that it draws with, and the invalid ones.
CLIENTS = (("feedback", 2, 0), ("lists", 1, 0), ("buffers", 1, 0), ("framebuffers", 3, 0),
           ("targets", 4, 0), ("mixed", 2, 0), ("windows", 1, 0), ("texts", 47, 13),
           ("parallax", 1, 0))


class PyOpenGl(Program):
    def cases(self, work: Path) -> list[Case]:
        # Debian's own python3 finds Debian's python3-opengl.
        return [Case(f"pyopengl-{name}", ["/usr/bin/python3", str(DATA / "pyopengl" / f"{name}.py")],
                     environment={"PYTHONDONTWRITEBYTECODE": "1"},
                     recorded=True, least_programs=programs, refused=refused)
                for name, programs, refused in CLIENTS]


PROGRAM = PyOpenGl("pyopengl", ("python3-opengl", "freeglut3-dev", "apitrace", "xvfb",
                                "libgl1-mesa-dri"),
                   "nine clients of the project: feedback, lists, buffers, framebuffers, contexts, every opcode")
