"""OpenSCAD's preview: image-space CSG by OpenCSG with one vertex and one fragment program."""

from pathlib import Path

from cases import DATA, Case, Program


class OpenScad(Program):
    def cases(self, work: Path) -> list[Case]:
        model = DATA / "model.scad"
        command = ["openscad", "-o", "o.png", "--imgsize=400,300", "--autocenter", "--viewall"]
        return [Case("openscad", [*command, str(model)], output="o.png")]


PROGRAM = OpenScad("openscad", ("openscad", "xvfb", "libgl1-mesa-dri"),
                   "difference and intersection, rectangle textures and alpha test")
