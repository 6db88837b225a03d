#!/usr/bin/env python3
"""Tests hostile or mistaken clients of control: who may listen, the errors, and senseless messages.

usage: hostile_test.py ARBITER TICKER PAINTER [unittest arguments]
The environment's HOSTILE_MESSAGES is the number of messages, 400 if it is not set.
"""
import contextlib
import json
import os
import random
import re
import shutil
import signal
import subprocess
import sys

import controlled
from controlled import ARBITER, PATIENCE, RED, TICKER, WRONG, Controlled, Raw

MESSAGES = int(os.environ.get('HOSTILE_MESSAGES', '400'))


class Hostile(Controlled):
    def test_nothing_listens_unless_it_is_asked_for(self):
        with self.running(TICKER, options=()) as output:
            self.assertTrue(output.waits_for('0 255 0'))
            self.assertFalse((self.folder / 'arbiter').exists())
            self.assertIn('no process listens', self.ctl('programs', code=1).stderr)

    def test_errors_say_what_to_do(self):
        self.assertIn('no process listens; start one', self.ctl('list', code=1).stderr)
        self.assertIn('arbiter run --control', self.ctl('--pid', '1', 'programs', code=1).stderr)
        with self.running(TICKER) as output, self.running(TICKER) as other:
            for each in (output, other):
                self.assertTrue(each.waits_for('0 255 0'))
            pids = [output.process.pid, other.process.pid]
            listed = self.ctl('list').stdout
            self.assertEqual(sorted(int(n) for n in re.findall(r'^ *(\d+) +layer +\S*ticker',
                                                               listed, re.M)), sorted(pids))
            self.assertIn('--pid', self.ctl('programs', code=1).stderr)
            self.ctl('--pid', pids[0], 'programs')
            self.assertIn('did you mean programs?',
                          self.ctl('--pid', pids[0], 'program', code=1).stderr)
            self.assertIn('there is no program', self.ctl('--pid', pids[0], 'get', 'no.fp',
                                                          code=1).stderr)
            output.process.send_signal(signal.SIGSTOP)
            stopped = subprocess.run([ARBITER, 'ctl', '--timeout', '0.2', '--pid', str(pids[0]),
                                      'programs'], env=self.environment, capture_output=True,
                                     text=True, timeout=PATIENCE)
            self.assertIn('is it stopped?', stopped.stderr)
        environment = {**self.environment}
        del environment['XDG_RUNTIME_DIR']
        result = subprocess.run([ARBITER, 'run', '--control', '--', 'true'], env=environment,
                                capture_output=True, text=True, timeout=PATIENCE)
        self.assertEqual(result.returncode, 125)
        self.assertIn('XDG_RUNTIME_DIR', result.stderr)
        result = subprocess.run([ARBITER, 'ctl', 'dance'], env=environment, capture_output=True, text=True,
                                timeout=PATIENCE)
        self.assertEqual((result.returncode, result.stderr),
                         (1, 'arbiter ctl: no action dance (arbiter ctl --help)\n'))
        result = subprocess.run([ARBITER, 'ctl', 'programs'], env=environment, capture_output=True, text=True,
                                timeout=PATIENCE)
        remedy = result.stderr.partition('for the program and for this alike: ')[2]
        self.assertTrue(remedy.startswith('export XDG_RUNTIME_DIR=/'), result.stderr)
        # After following the advice, the command has its folder.
        folder = remedy.split(';')[0].split('=')[1].strip()
        there = os.path.isdir(folder)
        done = subprocess.run(['sh', '-ec', f'{remedy}\n"$0" ctl programs', ARBITER], env=environment,
                              capture_output=True, text=True, timeout=PATIENCE)
        if not there:
            shutil.rmtree(folder)
        self.assertIn('no process listens', done.stderr)

    METHODS = ('hello', 'ping', 'program.list', 'program.get', 'program.set', 'program.reset', 'program.enable',
               'param.list', 'param.set', 'param.reset', 'texture.list', 'texture.get', 'texture.set',
               'texture.reset', 'frame.want', 'frame.release', 'frame.measure', 'pixel.pick', 'pixel.hold',
               'pixel.draw', 'pixel.texture', 'pixel.release', 'stats', 'none')
    VALUES = (None, -1, 0, 1, 1e308, 2 ** 64, '', 'x' * 1000, [], {}, [[1]], True, '../../etc/passwd',
              {'width': 1 << 30, 'height': 1, 'rgba': 'AAAA'}, [1e39, 0, 0, 0],
              'program.local[4294967296]', '\u0000')
    NAMES = ('id', 'text', 'revision', 'enabled', 'name', 'value', 'target', 'size', 'image', 'every', 'width',
             'height', 'slot', 'serial', 'x', 'y', 'draw', 'fragment', 'targets', 'clear', 'unit', 'framebuffer')
    BATCH = 40  # below the number that may wait

    def hostile(self, rng, number):
        """Returns a line that is answered, whatever it is: a request of any shape, or invalid bytes."""
        if rng.random() < 0.05:
            return bytes(rng.choice(b'{}[]":,0\\ \x00\xff') for _ in range(rng.randrange(1, 40))) + b'!\n'
        params = {name: rng.choice(self.VALUES) for name in self.NAMES if rng.random() < 0.4}
        return json.dumps({'jsonrpc': '2.0', 'id': number, 'method': rng.choice(self.METHODS),
                           'params': params}).encode() + b'\n'

    def test_hostile_messages_change_nothing(self):
        rng = random.Random(5)
        with self.running(TICKER) as output:
            self.assertTrue(output.waits_for('0 255 0'))
            path = self.socket_of(output)
            sent = 0
            while sent < MESSAGES:
                with Raw(path) as raw:
                    for _ in range(min(5000, MESSAGES - sent) // self.BATCH + 1):
                        raw.send(b''.join(self.hostile(rng, n) for n in range(self.BATCH)))
                        sent += self.BATCH
                        answers = 0
                        while answers < self.BATCH:
                            line = raw.line()
                            self.assertIsNotNone(line, f'the connection ended after {sent} messages')
                            answers += 'method' not in line
                        output.drain()
            print(sent, 'hostile messages', file=sys.stderr)
            with Raw(path) as raw:
                raw.send(b'not json\n[]\n{"jsonrpc":"2.0","id":1}\n' + b'[' * 40 + b']' * 40 + b'\n')
                codes = [raw.line()['error']['code'] for _ in range(4)]
                self.assertEqual(codes, [-32700, -32600, -32600, -32600])
                self.assertIsNone(raw.line(), 'what nests too deep ends the connection')
            with Raw(path) as raw, contextlib.suppress(OSError):
                raw.send(b'x' * (5 << 20))
            self.assertFalse(output.waits_for('255 0 0', 0.3))
            self.assertTrue(self.effective())
            self.assertIsNone(output.process.poll())

    def test_revisions_and_writers(self):
        with self.running(TICKER) as output:
            self.assertTrue(output.waits_for('0 255 0'))
            path, program = self.socket_of(output), self.effective()
            with Raw(path) as one, Raw(path) as two:
                self.assertEqual(one.call('hello')['result']['pid'], output.process.pid)
                self.assertTrue(one.call('program.set', id=program, text=RED,
                                         revision=5)['result']['ok'])
                old = one.call('program.set', id=program, text=RED, revision=5)['error']
                self.assertEqual((old['code'], old['data']['revision']), (-32003, 5))
                other = two.call('program.set', id=program, text=RED, revision=6)['error']
                self.assertEqual((other['code'], other['data']['pid']), (-32002, os.getpid()))
                wrong = one.call('program.set', id=program, text=WRONG, revision=7)['result']
                self.assertFalse(wrong['ok'])
                self.assertEqual((wrong['diagnostics'][0]['line'],
                                  wrong['diagnostics'][0]['column']), (2, 19))
                self.assertTrue(output.waits_for('255 0 0'))
                one.call('program.enable', id=program, enabled=False)
                self.assertEqual([row['enabled'] for row in self.programs()
                                  if row['id'] == program], [False])
            self.assertTrue(output.waits_for('0 255 0'))
            with Raw(path) as raw:  # TICKER loads its text repeatedly
                self.assertGreaterEqual(raw.call('ping')['result']['idle'], 0)
                line = raw.line()
                while line.get('method') != 'program.loaded':
                    line = raw.line()
                self.assertEqual(line['params'], {'id': program})

    def test_the_socket_goes_with_the_process(self):
        with self.running(TICKER, 'fragment', '30') as output:
            output.process.wait(PATIENCE)
            self.assertEqual(list((self.folder / 'arbiter').iterdir()), [])


if __name__ == '__main__':
    controlled.main()
