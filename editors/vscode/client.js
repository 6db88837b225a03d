// JSON-RPC with a language server over its standard input and output. It knows nothing of VS Code.
'use strict';
const { spawn } = require('child_process');

class Client {
  // `take(method, params)` gets the server's notifications; `ended(reason)` is called once, when the
  // server has gone without being asked to.
  constructor(command, args, take, ended) {
    this.take = take;
    this.ended = ended;
    this.nextId = 1;
    this.waiting = new Map();
    this.buffer = Buffer.alloc(0);
    this.stopping = false;
    this.gone = false;
    this.process = spawn(command, args, { stdio: ['pipe', 'pipe', 'inherit'] });
    this.process.on('error', (error) => this.end(error.message));
    this.process.on('exit', (code) => this.end(`exit code ${code}`));
    this.process.stdin.on('error', () => {}); // its exit says more
    this.process.stdout.on('data', (bytes) => this.receive(bytes));
  }

  end(reason) {
    if (this.gone) return;
    this.gone = true;
    for (const { reject } of this.waiting.values()) reject(new Error('the server has gone'));
    this.waiting.clear();
    if (!this.stopping) this.ended(reason);
  }

  receive(bytes) {
    this.buffer = Buffer.concat([this.buffer, bytes]);
    for (;;) {
      const end = this.buffer.indexOf('\r\n\r\n');
      if (end < 0) return;
      const length = /content-length: *(\d+)/i.exec(this.buffer.toString('latin1', 0, end));
      if (!length) return this.end('a message without a length');
      const from = end + 4;
      const to = from + Number(length[1]);
      if (this.buffer.length < to) return;
      const message = JSON.parse(this.buffer.toString('utf8', from, to));
      this.buffer = this.buffer.subarray(to);
      this.handle(message);
    }
  }

  handle(message) {
    if (message.method !== undefined) {
      this.take(message.method, message.params);
      // What the server asks has no answer but that it came.
      if (message.id !== undefined) this.send({ id: message.id, result: null });
      return;
    }
    const asked = this.waiting.get(message.id);
    if (!asked) return;
    this.waiting.delete(message.id);
    if (message.error) asked.reject(new Error(message.error.message));
    else asked.resolve(message.result);
  }

  send(message) {
    if (this.gone) return;
    const body = Buffer.from(JSON.stringify({ jsonrpc: '2.0', ...message }));
    this.process.stdin.write(`Content-Length: ${body.length}\r\n\r\n`);
    this.process.stdin.write(body);
  }

  notify(method, params) {
    this.send({ method, params });
  }

  // A promise of the result. `token` is a CancellationToken, or nothing.
  request(method, params, token) {
    if (this.gone) return Promise.reject(new Error('the server has gone'));
    const id = this.nextId++;
    const answer = new Promise((resolve, reject) => this.waiting.set(id, { resolve, reject }));
    if (token) token.onCancellationRequested(() => this.notify('$/cancelRequest', { id }));
    this.send({ id, method, params });
    return answer;
  }

  async stop() {
    this.stopping = true;
    if (this.gone) return;
    try {
      await this.request('shutdown');
      this.notify('exit');
    } catch {
      this.process.kill();
    }
  }
}

module.exports = { Client };
