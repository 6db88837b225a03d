"""Collects control's protocol: requests with their parameters and replies, events, codes of errors, limits.

The sources list the requests. docs/write/control.md lists the parameters, and which of them may be left out. A client
under the layer and a renderer are asked each request, so that types of parameters and replies are those that pass.
"""
import array
import contextlib
import json
import pathlib
import re
import socket
import subprocess
import sys
import time

import known
from reports import COUNTS, SECONDS, SEEN, tree
from sources import ROOT, Broken, text_of
from style import style_of

sys.path.insert(0, str(ROOT / 'tests' / 'clients'))
from x_server import XServer  # noqa: E402

PAGE = 'docs/write/control.md'
TEXT = '!!ARBfp1.0\nPARAM tint = program.env[3];\nMUL result.color, tint, program.local[0];\nEND\n'
PIXEL = {'x': 9, 'y': 9, 'framebuffer': 0}
FEEDBACK = ('!!ARBfp1.0\n#@ size 8 8\n#@ texture 0 = feedback of constant r 0 g 0 b 0, nearest, edge\nTEMP t;\n'
            'TEX t, fragment.texcoord[0], texture[0], 2D;\nADD result.color, t, {0.01, 0, 0, 1};\nEND\n')
# What each request is asked with. ID and IMAGE stand for a program of the client, and for a picture.
ASKED = {
    'layer': {
        'hello': [{'client': 'list'}], 'ping': [{}], 'program.list': [{}], 'program.get': [{'id': 'ID'}],
        'program.set': [{'id': 'ID', 'text': TEXT, 'revision': 1},
                        {'id': 'ID', 'text': '!!ARBfp1.0\nMOV result.color, q;\nEND\n', 'revision': 2}],
        'param.list': [{'id': 'ID'}],
        'param.set': [{'id': 'ID', 'name': 'program.local[0]', 'value': [1, 1, 0, 1]}],
        'param.reset': [{'id': 'ID', 'name': 'program.local[0]'}], 'program.reset': [{'id': 'ID'}],
        'program.enable': [{'id': 'ID', 'enabled': True}], 'texture.list': [{}],
        'texture.get': [{'name': 5, 'target': '2D', 'size': 4}],
        'texture.set': [{'name': 5, 'target': '2D', 'image': 'IMAGE'}], 'texture.reset': [{'name': 5}],
        'frame.want': [{'every': 1, 'width': 64, 'height': 64}], 'frame.release': [{'serial': 1, 'slot': 0}],
        'stats': [{}], 'frame.measure': [{}], 'pixel.pick': [PIXEL],
        'pixel.hold': [{**PIXEL, 'draw': 1, 'fragment': 'ID'}],
        'pixel.draw': [{'text': TEXT, 'targets': 1, 'x': 9, 'y': 9, 'width': 1, 'height': 1, 'clear': [0, 0, 0, 0],
                        'locals': 'AAAAAAAAAAAAAAAAAAAAAA=='}],
        'pixel.texture': [{'unit': 0, 'target': '2D'}], 'pixel.release': [{}],
    },
    'renderer': {
        'hello': [{'client': 'list'}], 'ping': [{}], 'frame.want': [{'every': 1, 'width': 8, 'height': 8}],
        'scene.set': [{'text': SEEN.replace('result', 'q'), 'revision': 1},
                      {'text': SEEN, 'revision': 2, 'name': 'seen.fp', 'files': {'other.fp': TEXT}},
                      {'text': FEEDBACK, 'revision': 3}],
        'scene.steps': [{'steps': 2}], 'scene.pause': [{'paused': True}], 'scene.step': [{'seconds': 0.1}],
        'scene.time': [{'seconds': 1}], 'scene.frame': [{}], 'scene.size': [{'width': 16, 'height': 16}],
        'scene.camera': [{'yaw': 0.1, 'pitch': 0.1, 'distance': 2}], 'scene.bench': [{'frames': 2}],
        'scene.param': [{'stage': 'fragment', 'kind': 'local', 'index': 0, 'value': [1, 0, 0, 1], 'pass': 0}],
        'frame.release': [{'serial': 1, 'slot': 0}],
    }}
# The order matters: a document is set before it is asked for, and feedback is the last one.
REFUSED = -32602
MAPS = {'stats': ('draws', 'software.given_to_host'), 'frame.measure': ('programs',)}
EVENTS = {'program.loaded': {'id': 'text'}, 'busy': {'milliseconds': 'number', 'revision': 'number'},
          'frame.buffer': {}, 'frame': {}}
CODES = {'kNoJson': 'no JSON', 'kNoRequest': 'no request', 'kNoMethod': 'no such method',
         'kWrongParameters': 'wrong parameters', 'kUnknownName': 'there is nothing of that id, name or slot',
         'kOtherWriter': 'another client is the writer', 'kOldRevision': 'the revision is not above the last one',
         'kNotPossible': 'not possible here', 'kTooBusy': 'the receiver has too much to do'}


class Peer:
    """One end of a connection, which keeps the events that come between answers."""

    def __init__(self, connection):
        self.socket, self.rest, self.last, self.events = connection, b'', 0, []
        self.socket.settimeout(SECONDS)

    def line(self):
        while b'\n' not in self.rest:
            data, extra, _, _ = self.socket.recvmsg(1 << 16, socket.CMSG_SPACE(64))
            if not data:
                raise Broken('the connection of control ended')
            for _, _, sent in extra:
                for descriptor in array.array('i', sent):
                    socket.close(descriptor)
            self.rest += data
        line, _, self.rest = self.rest.partition(b'\n')
        return json.loads(line)

    def ask(self, method, parameters):
        """Returns the whole answer."""
        self.last += 1
        self.socket.sendall(json.dumps({'jsonrpc': '2.0', 'id': self.last, 'method': method,
                                        'params': parameters}).encode() + b'\n')
        while True:
            message = self.line()
            if message.get('id') == self.last:
                return message
            self.events.append(message)


@contextlib.contextmanager
def layered(runs, painter):
    """A connection to a client with a window, under the layer."""
    with XServer() as display:
        process = subprocess.Popen([runs.arbiter, 'run', '--control', '--', str(painter)], stdout=subprocess.DEVNULL,
                                   env=runs.environment(DISPLAY=display))
        try:
            path, end = runs.folder / 'run' / 'arbiter' / f'{process.pid}.sock', time.monotonic() + SECONDS
            while not path.exists():
                if time.monotonic() > end or process.poll() is not None:
                    raise Broken(f'{painter}: does not listen')
                time.sleep(0.02)
            with socket.socket(socket.AF_UNIX) as connection:
                connection.connect(str(path))
                peer = Peer(connection)
                while not peer.ask('program.list', {}).get('result', {}).get('programs'):
                    time.sleep(0.05)
                yield peer
        finally:
            process.kill()
            process.wait()


@contextlib.contextmanager
def rendering(runs):
    """A connection to a renderer."""
    ours, theirs = socket.socketpair()
    process = subprocess.Popen([runs.arbiter, 'render', '--fd', str(theirs.fileno())], pass_fds=[theirs.fileno()],
                               cwd=runs.folder, env=runs.environment())
    theirs.close()
    try:
        with ours:
            yield Peer(ours)
    finally:
        process.kill()
        process.wait()


def filled(value, peer):
    """The parameters of a request, with ID and IMAGE in place."""
    if value == 'ID':
        rows = peer.ask('program.list', {})['result']['programs']
        return next(row['id'] for row in rows if row['target'] == 'fragment')
    if value == 'IMAGE':
        return peer.ask('texture.get', {'name': 5, 'target': '2D', 'size': 512})['result']['image']
    return {name: filled(each, peer) for name, each in value.items()} if isinstance(value, dict) else value


def documented():
    """Returns the parameters of each request, as the page writes them: {request: {name: may be left out}}."""
    found = {}
    for method, body in re.findall(r'`([a-z]+(?:\.[a-z]+)?) \{((?:[^{}]|\{[^{}]*\})*)\}`', text_of(PAGE)):
        plain = re.sub(r'\{[^{}]*\}|\[[^\]]*\]|"[^"]*"', ' ', body)
        names = re.findall(r'(?:^|,)\s*(\w+)(\??)', plain)
        found.setdefault(method, {}).update({name: bool(mark) for name, mark in names})
    return found


def listed():
    """Returns the requests that the sources know, of either server."""
    layer = set(re.findall(r'^    \{"([a-z.]+)", \w+', text_of('src/state/control/methods.cpp'), re.M))
    renderer = set(re.findall(r'\{"([a-z.]+)", &RenderLoop::', text_of('src/apps/tools/render/methods.cpp')))
    common = {'hello', 'ping', 'frame.release'}
    return {'layer': layer | common, 'renderer': renderer | common}


def check_needed(server, peer, method, example, page):
    """Asks without each parameter that has to be given, and without all others: the first is refused."""
    for name in [name for name in example if name in page and not page[name]]:
        answer = peer.ask(method, filled({each: example[each] for each in example if each != name}, peer))
        if answer.get('error', {}).get('code') != REFUSED:
            raise Broken(f'{PAGE}: {method}: {server} takes it without {name}, which the page asks for: {answer}')
    answer = peer.ask(method, filled({name: example[name] for name in example if not page.get(name)}, peer))
    if answer.get('error', {}).get('code') == REFUSED:
        raise Broken(f'{PAGE}: {method}: {server} refuses it without what may be left out: {answer}')


def ask_all(server, peer):
    """Returns the entries of every request of a server."""
    entries, pages = [], documented()
    if missing := listed()[server] ^ set(ASKED[server]):
        raise Broken(f'docs/interface/protocol.py: {server}: requests that only one side has: {sorted(missing)}')
    for method, examples in ASKED[server].items():
        reply = tree(method, maps=MAPS.get(method, ()), named={place + counts for counts in COUNTS
                                                              for place in ('', 'programs[].')})
        kinds = tree(method, maps={'files'})
        for example in examples:
            answer = peer.ask(method, filled(example, peer))
            if 'result' not in answer:
                raise Broken(f'{server}: {method} {example}: {answer}')
            reply.add(answer['result'])
            check_needed(server, peer, method, example, pages.get(method, {}))
            kinds.add(filled(example, peer) if 'IMAGE' in example.values() else example)
        style_of([reply])
        if method not in pages or set(pages[method]) != {name for example in examples for name in example}:
            raise Broken(f'{PAGE}: {method}: the page has {sorted(pages.get(method, []))}, not {examples}')
        entries.append({'key': f'{server} {method}', 'what': 'request'})
        for name, optional in pages[method].items():
            entry = {'key': f'{server} {method} < {name}', 'type': kinds.type_of(name)}
            if not optional:
                entry['required'] = True
            entries.append(entry)
        for entry in reply.entries(f'{server} {method} >'):
            entries.append(entry)
            last = re.split(r'[.\]}]', entry['key'])[-1].split()[-1]
            if not re.search(r'\b%s\b' % re.escape(last), text_of(PAGE)):
                raise Broken(f'{PAGE}: says nothing of {last}, which {method} answers')
    return entries


def events(peers):
    """Returns the entries of events: what came, and what the page says of those that did not."""
    entries = []
    sources = ''.join(path.read_text() for folder in ('state/control', 'control', 'apps/tools/render')
                      for path in sorted((ROOT / 'src' / folder).glob('*.cpp')))
    for server, peer in peers.items():
        seen = {}
        for message in peer.events:
            seen.setdefault(message['method'], tree(message['method'])).add(message['params'])
        for name, said in EVENTS.items():
            if f'"{name}"' not in sources:
                raise Broken(f'{PAGE}: no source sends {name}')
            if server == 'renderer' and name == 'program.loaded':
                continue
            entries.append({'key': f'{server} {name}', 'what': 'event'})
            kinds = {**(said if name == 'program.loaded' or server == 'renderer' else
                        {each: kind for each, kind in said.items() if each != 'revision'})}
            if name.startswith('frame'):
                if name not in seen:
                    raise Broken(f'{server}: sends no {name}')
                kinds = {place: seen[name].type_of(place) for place in seen[name].kinds if place}
            entries += [{'key': f'{server} {name} > {each}', 'type': kind} for each, kind in sorted(kinds.items())]
    return entries


def constants():
    """Returns the protocol's version, its limits and its codes of errors."""
    source = text_of('src/control/message.h')
    enumerators = re.findall(r'^  (k\w+) = (-\d+),', source, re.M)
    if {name for name, _ in enumerators} != set(CODES):
        raise Broken('src/control/message.h: other codes of errors')
    page = text_of(PAGE)
    protocol = re.search(r'ARBITER_CONTROL_PROTOCOL (\d+)', text_of('include/GL/arbiter.h')).group(1)
    entries = [{'key': 'protocol', 'value': protocol},
               {'key': 'most bytes of a line', 'value': re.search(r'kMaxLineBytes = (.*?);', source).group(1)},
               {'key': 'deepest nesting', 'value': re.search(r'kMaxDepth = (\d+)', source).group(1)}]
    for name, code in enumerators:
        if code not in page:
            raise Broken(f'{PAGE}: says nothing of {code}')
        entries.append({'key': f'error {code}', 'meaning': CODES[name]})
    return entries


def collect(runs, build):
    """Returns the entries of the protocol."""
    painter = pathlib.Path(build) / 'tests' / 'control' / 'control_painter'
    if not painter.exists():
        raise Broken(f'{painter}: is not built')
    entries = constants()
    with layered(runs, painter) as peer, rendering(runs) as other:
        peers = {'layer': peer, 'renderer': other}
        for server, each in peers.items():
            entries += ask_all(server, each)
        end = time.monotonic() + SECONDS
        while not all(any(message['method'] == 'frame' for message in each.events) for each in peers.values()):
            if time.monotonic() > end:
                raise Broken('no frame came')
            for each in peers.values():
                each.ask('ping', {})
            time.sleep(0.02)
        entries += events(peers)
        rows = runs.document('ctl', '--json', 'list')
        shown = tree('ctl list')
        shown.add({'list': rows})
        entries += [{'key': 'ctl --json list', 'type': 'list of object'}, *[
            {'key': f'ctl --json {entry["key"].split(" ", 2)[2]}', 'type': entry['type']}
            for entry in shown.entries('ctl list') if '[]' in entry['key']]]
    return known.complete(entries, known.PROTOCOL)
