"""A test client of `arbiter lsp` over pipes, which sends requests and keeps the server's messages."""
import json
import os
import select
import subprocess
import time

TIMEOUT = 30


class Closed(Exception):
    """Raised when the server has closed the connection."""


class Client:
    def __init__(self, command):
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        bufsize=0)
        self.buffer = b''
        self.next_id = 1
        self.inbox = []  # messages received while waiting for another

    # --- Frames ---

    def send_bytes(self, data):
        self.process.stdin.write(data)

    def send_body(self, body):
        self.send_bytes(b'Content-Length: %d\r\n\r\n%s' % (len(body), body))

    def send(self, message):
        self.send_body(self.encode(message))

    @staticmethod
    def encode(message):
        return json.dumps({'jsonrpc': '2.0', **message}, ensure_ascii=False).encode()

    def more(self, deadline):
        left = deadline - time.monotonic()
        if left <= 0 or not select.select([self.process.stdout], [], [], left)[0]:
            raise TimeoutError('the server says nothing')
        data = os.read(self.process.stdout.fileno(), 1 << 16)
        if not data:
            raise Closed
        self.buffer += data

    def receive(self, timeout=TIMEOUT):
        """Receives the next message."""
        deadline = time.monotonic() + timeout
        while b'\r\n\r\n' not in self.buffer:
            self.more(deadline)
        header, _, rest = self.buffer.partition(b'\r\n\r\n')
        length = int(header.split(b':')[1])
        while len(rest) < length:
            self.buffer = header + b'\r\n\r\n' + rest
            self.more(deadline)
            rest = self.buffer.partition(b'\r\n\r\n')[2]
        self.buffer = rest[length:]
        message = json.loads(rest[:length].decode())
        assert message.get('jsonrpc') == '2.0', message
        return message

    def wait(self, wanted):
        """Returns the first wanted message among those received and those to come."""
        for at, message in enumerate(self.inbox):
            if wanted(message):
                return self.inbox.pop(at)
        while True:
            message = self.receive()
            if wanted(message):
                return message
            self.inbox.append(message)

    # --- Requests and notifications ---

    def notify(self, method, params=None):
        self.send({'method': method, 'params': params if params is not None else {}})

    def ask(self, method, params=None):
        """Sends a request and returns its id."""
        self.next_id += 1
        self.send({'id': self.next_id, 'method': method,
                   'params': params if params is not None else {}})
        return self.next_id

    def response(self, identity):
        return self.wait(lambda m: 'method' not in m and m.get('id') == identity)

    def request(self, method, params=None):
        """Sends a request and returns its result; asserts that it is no error."""
        answer = self.response(self.ask(method, params))
        assert 'error' not in answer, answer
        return answer['result']

    def failure(self, method, params=None):
        answer = self.response(self.ask(method, params))
        assert 'error' in answer, answer
        return answer['error']

    def diagnostics(self, uri):
        message = self.wait(lambda m: m.get('method') == 'textDocument/publishDiagnostics'
                            and m['params']['uri'] == uri)
        return message['params']

    # --- The life of a session ---

    def initialize(self, capabilities=None, options=None):
        params = {'processId': None, 'rootUri': None, 'capabilities': capabilities or {}}
        if options is not None:
            params['initializationOptions'] = options
        result = self.request('initialize', params)
        self.notify('initialized')
        return result

    def open(self, uri, text, language=''):
        self.notify('textDocument/didOpen', {'textDocument': {
            'uri': uri, 'languageId': language, 'version': 1, 'text': text}})
        return self.diagnostics(uri)['diagnostics']

    def change(self, uri, version, *changes):
        self.notify('textDocument/didChange', {
            'textDocument': {'uri': uri, 'version': version}, 'contentChanges': list(changes)})

    def leave(self):
        """Sends shutdown and exit, and returns the exit code."""
        self.request('shutdown')
        self.notify('exit')
        return self.ended()

    def ended(self):
        self.process.stdin.close()
        code = self.process.wait(TIMEOUT)
        self.process.stdout.close()
        return code

    def drop(self):
        """Ends a server that may still be running."""
        if self.process.poll() is None:
            self.process.kill()
            self.process.wait()
        for pipe in (self.process.stdin, self.process.stdout):
            pipe.close()


def place(text, mark, after=0, utf8=False):
    """Returns the position `after` characters behind the start of `mark`, which must occur once in the text."""
    assert text.count(mark) == 1, (mark, text.count(mark))
    before = text[:text.index(mark) + after]
    line = before.count('\n')
    tail = before.rpartition('\n')[2]
    return {'line': line,
            'character': len(tail.encode()) if utf8 else len(tail.encode('utf-16-le')) // 2}
