"""OpenSceneGraph's osgFX, through a client of the project: bump mapping, anisotropic lighting and cartoon
shading, whose techniques are vertex and fragment programs in display lists.
"""

from pathlib import Path

from cases import Case, Program, build_client


class OsgFx(Program):
    def cases(self, work: Path) -> list[Case]:
        client = build_client(work, "osgfx.cpp", [
            "-losgFX", "-losgViewer", "-losgGA", "-losgUtil", "-losgDB", "-losg", "-lOpenThreads",
            "-lGL"])
        return [Case("osgfx", [str(client)], recorded=True)]


PROGRAM = OsgFx("osgfx", ("libopenscenegraph-dev", "g++", "apitrace", "xvfb", "libgl1-mesa-dri"),
                "bump mapping, anisotropic lighting and cartoon shading of osgFX")
