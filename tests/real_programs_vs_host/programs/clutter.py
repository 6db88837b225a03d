"""Clutter over Cogl's driver for fixed-function GL, through a client of the project.

Cogl generates a fragment program for an actor's material, and its effects are GLSL in the same context."""

from pathlib import Path

from cases import Case, Program, build_client, shell


class Clutter(Program):
    def cases(self, work: Path) -> list[Case]:
        flags = shell(["pkg-config", "--cflags", "--libs", "clutter-1.0"]).split()
        environment = {"COGL_DRIVER": "gl", "CLUTTER_BACKEND": "x11", "NO_AT_BRIDGE": "1"}
        return [Case("clutter", [str(build_client(work, "clutter.cpp", flags))],
                     environment=environment, recorded=True)]


PROGRAM = Clutter("clutter", ("libclutter-1.0-dev", "pkg-config", "g++", "apitrace", "xvfb",
                              "libgl1-mesa-dri"),
                  "fragment programs that Cogl generates, beside GLSL of its effects")
