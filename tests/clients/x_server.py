"""Runs an X server for a test."""
import os
import subprocess
import sys


class XServer:
    """An Xvfb on a display number that it chooses. Without -noreset nobody could connect in the gap between two
    clients."""

    def __init__(self, screen="640x480x24", options=()):
        self.screen, self.options = screen, options

    def __enter__(self):
        reader, writer = os.pipe()
        self.process = subprocess.Popen(
            ["Xvfb", "-displayfd", str(writer), "-noreset", "-nolisten", "tcp", "-screen", "0",
             self.screen, "+extension", "GLX", *self.options],
            pass_fds=[writer], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(writer)
        with os.fdopen(reader) as stream:
            number = stream.readline().strip()
        if not number:
            sys.exit("Xvfb does not start")
        return ":" + number

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()
