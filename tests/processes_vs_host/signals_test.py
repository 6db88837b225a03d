#!/usr/bin/env python3
"""Tests heed_signals(): a signal that a runner's caller ignores can end the runner's children again."""
import signal
import subprocess
import sys
import unittest
from pathlib import Path

CLIENTS = Path(__file__).resolve().parent.parent / "clients"
# A runner whose child sends itself the signal.
RUNNER = f"""
import subprocess, sys
sys.path.insert(0, {str(CLIENTS)!r})
from plain_environment import heed_signals
if sys.argv[2] == "heeds":
    heed_signals()
print(subprocess.run(["sh", "-c", f"kill -{{sys.argv[1]}} $$"]).returncode)
"""


def end_of_child(number, heeds):
    """Returns how a runner's child ends by a signal that the runner's caller ignores."""
    done = subprocess.run([sys.executable, "-c", RUNNER, str(int(number)), heeds], capture_output=True, text=True,
                          check=True, preexec_fn=lambda: signal.signal(number, signal.SIG_IGN))
    return int(done.stdout)


class Signals(unittest.TestCase):
    def test_ignored_by_the_caller(self):
        for number in (signal.SIGINT, signal.SIGHUP, signal.SIGQUIT, signal.SIGTERM):
            with self.subTest(number=number):
                self.assertEqual(end_of_child(number, "as it comes"), 0)
                self.assertEqual(end_of_child(number, "heeds"), -number)


if __name__ == "__main__":
    unittest.main()
