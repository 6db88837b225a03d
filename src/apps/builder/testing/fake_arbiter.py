#!/usr/bin/env python3
"""A stand-in for `arbiter render` (docs/write/control.md) that draws without GL: a text is a color.

The picture has 4x2 pixels. All have the color that follows "colour " in the text as six digits, except the bottom left
one, which is white. "wrong" in the text is refused, "crash" ends the process by a signal, "hang" never answers,
"slow" takes 0.3 s.
"""
import fcntl
import json
import mmap
import os
import re
import signal
import socket
import sys
import time

WIDTH, HEIGHT = 4, 2
STRIDE = WIDTH * 4
SLOT = mmap.PAGESIZE  # the slot size of such small pictures
F_ADD_SEALS, SEALS = 1033, 0x2 | 0x4  # the seals against shrinking and growing


class Renderer:
    def __init__(self, descriptor):
        self.socket = socket.socket(fileno=descriptor)
        self.memory = os.memfd_create('frames', os.MFD_ALLOW_SEALING)
        os.ftruncate(self.memory, SLOT * 3)
        fcntl.fcntl(self.memory, F_ADD_SEALS, SEALS)
        self.number = 0
        self.revision = 0
        self.colour = (0, 0, 0)
        self.told = False

    def send(self, message, descriptors=()):
        data = (json.dumps({'jsonrpc': '2.0', **message}) + '\n').encode()
        if descriptors:
            socket.send_fds(self.socket, [data], list(descriptors))
        else:
            self.socket.sendall(data)

    def event(self, method, params, descriptors=()):
        self.send({'method': method, 'params': params}, descriptors)

    def draw(self):
        if not self.told:
            self.event('frame.buffer', {'width': WIDTH, 'height': HEIGHT, 'stride': STRIDE, 'slots': 3,
                                        'slot_bytes': SLOT, 'serial': 1}, [self.memory])
            self.told = True
        slot = self.number % 3
        pixel = bytes(self.colour) + b'\xff'
        os.pwrite(self.memory, b'\xff' * 4 + pixel * (WIDTH * HEIGHT - 1), slot * SLOT)
        self.number += 1
        self.event('frame', {'serial': 1, 'slot': slot, 'number': self.number, 'width': WIDTH,
                             'height': HEIGHT, 'revision': self.revision, 'time': 0, 'milliseconds': 1})

    def set_scene(self, params):
        text = params['text']
        if 'crash' in text:
            os.kill(os.getpid(), signal.SIGSEGV)
        while 'hang' in text:
            time.sleep(1)
        if 'slow' in text:
            time.sleep(0.3)
        if params['revision'] <= self.revision:
            raise ValueError('revision')
        self.revision = params['revision']
        if 'wrong' in text:
            at = len(text[:text.index('wrong')].encode())
            return {'ok': False, 'superseded': False, 'revision': self.revision, 'diagnostics': [
                {'severity': 'error', 'message': 'it is wrong', 'hint': 'mend it', 'begin': at,
                 'end': at + 5, 'line': 1, 'column': at + 1}]}
        digits = re.search('colour ([0-9a-f]{6})', text)
        self.colour = tuple(bytes.fromhex(digits.group(1))) if digits else (0, 0, 0)
        if 'started with' in text:  # red: with that profile; green: with those numerics
            self.colour = (255 * ('nv30' in sys.argv), 255 * ('fp24' in sys.argv), 0)
        self.draw()
        return {'ok': True, 'superseded': False, 'revision': self.revision, 'diagnostics': [],
                'milliseconds': 1, 'animated': False}

    def answer(self, method, params):
        if method == 'scene.set':
            return self.set_scene(params)
        if method == 'scene.param':
            red = params['value'][0]
            self.colour = (round(255 * red), 0, 0)
            self.draw()
        if method == 'scene.bench':
            return {'frames': params['frames'], 'milliseconds': 100, 'median': 0.5}
        return {}

    def serve(self):
        for line in self.socket.makefile('rb'):
            message = json.loads(line)
            if 'id' in message:
                self.send({'id': message['id'],
                           'result': self.answer(message['method'], message.get('params', {}))})


def main():
    if sys.argv[1:2] != ['render']:
        return 1
    Renderer(int(sys.argv[sys.argv.index('--fd') + 1])).serve()
    return 0


if __name__ == '__main__':
    sys.exit(main())
