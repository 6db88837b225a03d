// Drives editors/vscode against the real `arbiter lsp`, with a stand-in for the module that VS Code
// gives its extensions: what is shown, and what the editor's events lead to.
//
// usage: node vscode_test.js EXTENSION_FOLDER ARBITER
'use strict';
const assert = require('assert');
const Module = require('module');
const path = require('path');

const [folder, arbiter] = process.argv.slice(2).map((name) => path.resolve(name));

class Position {
  constructor(line, character) { Object.assign(this, { line, character }); }
}
class Range {
  constructor(start, end) { Object.assign(this, { start, end }); }
}
// A class whose constructor keeps its arguments under these names.
const record = (...names) => class {
  constructor(...values) { names.forEach((name, i) => { this[name] = values[i]; }); }
};

const events = {};
const listen = (name) => (callback) => { events[name] = callback; return { dispose() {} }; };
const registered = {};
const register = (name) => (selector, provider, ...rest) => {
  registered[name] = { selector, provider, rest };
  return { dispose() {} };
};
const configuration = { path: arbiter, profile: '' };
const messages = [];
let shown = new Map();
let shownWaiters = [];

const vscode = {
  Position, Range,
  Location: record('uri', 'range'),
  Diagnostic: record('range', 'message', 'severity'),
  DiagnosticRelatedInformation: record('location', 'message'),
  CompletionItem: record('label', 'kind'),
  DocumentSymbol: record('name', 'detail', 'kind', 'range', 'selectionRange'),
  DocumentHighlight: record('range', 'kind'),
  InlayHint: record('position', 'label'),
  Hover: record('contents', 'range'),
  MarkdownString: record('value'),
  SemanticTokens: record('data'),
  SemanticTokensLegend: record('tokenTypes', 'tokenModifiers'),
  WorkspaceEdit: class {
    constructor() { this.edits = []; }
    replace(uri, range, text) { this.edits.push({ uri, range, text }); }
  },
  Uri: { parse: (text) => ({ toString: () => text }) },
  workspace: {
    textDocuments: [],
    getConfiguration: () => ({ get: (name) => configuration[name] }),
    onDidOpenTextDocument: listen('open'),
    onDidChangeTextDocument: listen('change'),
    onDidCloseTextDocument: listen('close'),
    onDidChangeConfiguration: listen('configuration'),
  },
  window: {
    showErrorMessage: (text) => messages.push(text),
    showWarningMessage: (text) => messages.push(text),
  },
  commands: { registerCommand: (name, run) => { registered[name] = run; return { dispose() {} }; } },
  languages: {
    createDiagnosticCollection: () => ({
      set: (uri, list) => {
        shown.set(uri.toString(), list);
        shownWaiters.splice(0).forEach((wake) => wake());
      },
      clear: () => shown.clear(),
      dispose() {},
    }),
    registerHoverProvider: register('hover'),
    registerCompletionItemProvider: register('completion'),
    registerDefinitionProvider: register('definition'),
    registerReferenceProvider: register('references'),
    registerDocumentHighlightProvider: register('highlights'),
    registerRenameProvider: register('rename'),
    registerDocumentSymbolProvider: register('symbols'),
    registerInlayHintsProvider: register('hints'),
    registerDocumentSemanticTokensProvider: register('tokens'),
  },
};

const load = Module._load;
Module._load = (name, ...rest) => (name === 'vscode' ? vscode : load(name, ...rest));

function made(uri, text) {
  return { languageId: 'arbprogram', uri: vscode.Uri.parse(uri), version: 1, text,
    getText() { return this.text; } };
}
const diagnosticsOf = async (uri, wanted) => {
  const deadline = Date.now() + 20000;
  while (!shown.has(uri) || !wanted(shown.get(uri))) {
    assert(Date.now() < deadline, `no such diagnostics of ${uri}: ${JSON.stringify(shown.get(uri))}`);
    await new Promise((wake) => { shownWaiters.push(wake); setTimeout(wake, 500); });
  }
  return shown.get(uri);
};

async function main() {
  const extension = require(path.join(folder, 'extension.js'));
  const early = made('file:///early.fp', '!!ARBfp1.0\nTEMP a;\nMOV result.color, b;\nEND\n');
  vscode.workspace.textDocuments.push(early);
  extension.activate({ subscriptions: [] });

  // What was open before the server: its error with range, code and severity.
  const [error] = await diagnosticsOf('file:///early.fp', (list) => list.length === 1);
  assert.strictEqual(error.code, 'undeclared_name');
  assert.strictEqual(error.severity, 0);
  assert.deepStrictEqual(error.range, new Range(new Position(2, 18), new Position(2, 19)));

  // An edit, as VS Code reports it.
  early.text = early.text.replace('b;', 'a;');
  early.version = 2;
  events.change({ document: early, contentChanges: [{ range: error.range, text: 'a' }] });
  const [warning] = await diagnosticsOf('file:///early.fp',
    (list) => list.length === 1 && list[0].code !== 'undeclared_name');
  assert.strictEqual(warning.code, 'unwritten_temporary');
  assert.strictEqual(warning.severity, 1);

  // A text that is opened later, and is one the extension does not know.
  const late = made('file:///late.vp', '!!ARBvp1.0\nMOV result.position, vertex.position;\nEND\n');
  events.open(late);
  assert.deepStrictEqual(await diagnosticsOf('file:///late.vp', () => true), []);
  events.open({ ...made('file:///other.txt', 'x'), languageId: 'plaintext' });

  const { provider } = registered.hover;
  const at = new Position(1, 6); // on a
  const over = await provider.provideHover(early, at);
  assert(over.contents.value.includes('TEMP a;'), over.contents.value);
  const items = await provider.provideCompletionItems(early, new Position(2, 0));
  const move = items.find((item) => item.label === 'MOV');
  assert.strictEqual(move.kind, 2); // Function
  assert.strictEqual(move.insertText, 'MOV');
  assert(move.documentation.value.includes('ARB_fragment_program'));
  assert.deepStrictEqual(registered.completion.rest, ['.', '[']);

  const use = new Position(2, 18);
  const declared = await provider.provideDefinition(early, use);
  assert.deepStrictEqual(declared.range.start, new Position(1, 5));
  const all = await provider.provideReferences(early, use, { includeDeclaration: true });
  assert.strictEqual(all.length, 2);
  const marks = await provider.provideDocumentHighlights(early, use);
  assert.deepStrictEqual(marks.map((mark) => mark.kind), [2, 1]); // Write, Read
  const symbols = await provider.provideDocumentSymbols(early);
  assert.deepStrictEqual(symbols.map((s) => [s.name, s.kind]), [['a', 12]]); // Variable
  const whole = new Range(new Position(0, 0), new Position(9, 0));
  const hints = await provider.provideInlayHints(early, whole);
  assert(hints[0].label.includes('/64 ALU instructions'), hints[0].label);
  const tokens = await registered.tokens.provider.provideDocumentSemanticTokens(early);
  assert(tokens.data instanceof Uint32Array && tokens.data.length % 5 === 0 && tokens.data.length);

  assert.strictEqual((await provider.prepareRename(early, use)).placeholder, 'a');
  const edit = await provider.provideRenameEdits(early, use, 'sum');
  assert.deepStrictEqual(edit.edits.map((e) => e.text), ['sum', 'sum']);
  await assert.rejects(provider.provideRenameEdits(early, use, 'MOV'), /reserved word/);
  assert.strictEqual(await provider.provideHover(early, new Position(0, 3)), null);

  // Another card: the announced limits hold at once.
  const heavy = made('file:///heavy.fp', '!!ARBfp1.0\nTEMP a;\nMOV a, 1.0;\n' + 'MUL a, a, a;\n'.repeat(79) +
    'MOV result.color, a;\nEND\n');
  events.open(heavy);
  await diagnosticsOf('file:///heavy.fp', (list) => list.length > 0);
  configuration.profile = 'nv30';
  events.configuration({ affectsConfiguration: (name) => name === 'arbiter.profile' });
  await diagnosticsOf('file:///heavy.fp', (list) => list.length === 0);

  // A server that ends is started again, and knows what is open.
  shown.clear();
  vscode.workspace.textDocuments = [early, heavy];
  await registered['arbiter.restart']();
  await diagnosticsOf('file:///heavy.fp', (list) => list.length === 0);
  events.close(early);
  await diagnosticsOf('file:///early.fp', (list) => list.length === 0);
  await extension.deactivate();

  // A command that is not there is said once, and nothing hangs.
  assert.deepStrictEqual(messages, []);
  configuration.path = '/nonexistent/arbiter';
  extension.activate({ subscriptions: [] });
  assert.strictEqual(await provider.provideHover(early, at), null);
  while (messages.length === 0) await new Promise((wake) => setTimeout(wake, 10));
  assert(messages[0].includes('arbiter.path'), messages[0]);
  console.log('vscode extension: all as wanted');
}

main().catch((error) => { console.error(error); process.exit(1); });
