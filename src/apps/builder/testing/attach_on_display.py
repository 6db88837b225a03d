#!/usr/bin/env python3
"""Tests the window attached to a real client: both on a display of their own, the client under
`arbiter run --control`.

usage: attach_on_display.py ARBITER PAINTER WINDOW_TEST
The environment's ATTACH_SCREENSHOT is a PNG that the window is written to, with a pixel traced.
"""
import os
import pathlib
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[4] / 'tests' / 'clients'))
import x_server  # noqa: E402


def main():
    arbiter, painter, test = map(os.path.abspath, sys.argv[1:4])
    with x_server.XServer('1400x900x24') as display, tempfile.TemporaryDirectory() as folder:
        environment = dict(os.environ, DISPLAY=display, QT_QPA_PLATFORM='xcb', XDG_RUNTIME_DIR=folder,
                           LIBGL_ALWAYS_SOFTWARE='1')
        client = subprocess.Popen([arbiter, 'run', '--control', '--', painter], env=environment,
                                  stdout=subprocess.PIPE)
        try:
            line = client.stdout.readline().decode().strip()
            if line != 'middle 255 255 0':
                print('the client draws', line)
                return 1
            code = subprocess.run([test, '--gtest_filter=AttachWindow.ARealClient*'],
                                  env={**environment, 'ATTACH_TO': str(client.pid)}).returncode
            if client.poll() is not None:
                print('the client ended with', client.returncode)
                return 1
        finally:
            client.kill()
            said = client.communicate()[0].decode().split('\n')
        wrong = [line for line in said if line.startswith(('state', 'error'))]
        if wrong:
            print('the client saw', wrong)
        return code or len(wrong)


if __name__ == '__main__':
    sys.exit(main())
