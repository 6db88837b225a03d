"""OpenSceneGraph's osgFX, through a client of the project.

Its bump mapping, anisotropic lighting and cartoon shading use vertex and fragment programs in display lists.
"""

from pathlib import Path

from cases import DRAWN, Case, Program, build_client


class OsgFx(Program):
    def cases(self, work: Path) -> list[Case]:
        client = build_client(work, "osgfx.cpp", [
            "-losgFX", "-losgViewer", "-losgGA", "-losgUtil", "-losgDB", "-losg", "-lOpenThreads",
            "-lGL"])
        # The cartoon's program writes s of its texture coordinates but not q, by which fixed function divides. Mesa has
        # 0 there; llvmpipe turns s/0 into the first texel, softpipe and the rasterizer into the last one. (NVIDIA's
        # driver has 1, which the programs rely on: with q written all draw the same.)
        return [Case("osgfx", [str(client)], recorded=True, ways_left_out=DRAWN)]


PROGRAM = OsgFx("osgfx", ("libopenscenegraph-dev", "g++", "apitrace", "xvfb", "libgl1-mesa-dri"),
                "bump mapping, anisotropic lighting and cartoon shading of osgFX")
