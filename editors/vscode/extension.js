// Starts `arbiter lsp` and brings its answers into VS Code. A client of its own, so that the folder
// works as it is copied: vscode-languageclient would need npm, a network and a second copy of what
// these lines say.
'use strict';
const vscode = require('vscode');
const { Client } = require('./client');

const LANGUAGE = 'arbprogram';
const MAX_RESTARTS = 3;

let server = null; // { client, ready, opened: URIs that the server knows }
let restarts = 0;
let diagnostics = null;
let subscriptions = null;
let hasSemanticTokens = false;

const settings = () => vscode.workspace.getConfiguration('arbiter');
const isOurs = (document) => document.languageId === LANGUAGE;
const uriOf = (document) => document.uri.toString();

// --- The protocol's values and VS Code's ---

const position = (p) => new vscode.Position(p.line, p.character);
const range = (r) => new vscode.Range(position(r.start), position(r.end));
const location = (l) => new vscode.Location(vscode.Uri.parse(l.uri), range(l.range));
const markdown = (content) =>
  content && new vscode.MarkdownString(typeof content === 'string' ? content : content.value);
const plainRange = (r) => ({
  start: { line: r.start.line, character: r.start.character },
  end: { line: r.end.line, character: r.end.character },
});
const place = (document, at) => ({
  textDocument: { uri: uriOf(document) },
  position: { line: at.line, character: at.character },
});

function diagnostic(found) {
  // The protocol counts severities from 1, VS Code from 0.
  const made = new vscode.Diagnostic(range(found.range), found.message, found.severity - 1);
  made.code = found.code;
  made.source = found.source;
  made.relatedInformation = (found.relatedInformation || []).map(
    (r) => new vscode.DiagnosticRelatedInformation(location(r.location), r.message));
  return made;
}

function completionItem(found) {
  const made = new vscode.CompletionItem(found.label, found.kind - 1);
  made.detail = found.detail;
  made.documentation = markdown(found.documentation);
  made.filterText = found.filterText;
  made.insertText = found.textEdit.newText;
  made.range = range(found.textEdit.range);
  return made;
}

function symbol(found) {
  return new vscode.DocumentSymbol(found.name, found.detail || '', found.kind - 1,
    range(found.range), range(found.selectionRange));
}

function inlayHint(found) {
  const made = new vscode.InlayHint(position(found.position), found.label);
  made.tooltip = found.tooltip;
  made.paddingLeft = found.paddingLeft;
  return made;
}

// --- The server's life ---

function open(document) {
  if (server.opened.has(uriOf(document))) return;
  server.opened.add(uriOf(document));
  server.client.notify('textDocument/didOpen', {
    textDocument: {
      uri: uriOf(document), languageId: document.languageId, version: document.version,
      text: document.getText(),
    },
  });
}

function take(method, params) {
  if (method === 'textDocument/publishDiagnostics')
    diagnostics.set(vscode.Uri.parse(params.uri), params.diagnostics.map(diagnostic));
  else if (method === 'window/showMessage')
    vscode.window.showWarningMessage(params.message);
}

function start() {
  const command = settings().get('path') || 'arbiter';
  const client = new Client(command, ['lsp'], take, (reason) => gone(command, reason));
  const profile = settings().get('profile');
  const ready = client.request('initialize', {
    processId: process.pid,
    rootUri: null,
    capabilities: {},
    initializationOptions: profile ? { profile } : {},
  }).then((result) => {
    client.notify('initialized', {});
    vscode.workspace.textDocuments.filter(isOurs).forEach(open);
    offerSemanticTokens(result.capabilities.semanticTokensProvider.legend);
  });
  ready.catch(() => {}); // gone() says it
  server = { client, ready, opened: new Set() };
}

// The server's legend is known only once it has answered.
function offerSemanticTokens(legend) {
  if (hasSemanticTokens) return;
  hasSemanticTokens = true;
  subscriptions.push(vscode.languages.registerDocumentSemanticTokensProvider(LANGUAGE, providers,
    new vscode.SemanticTokensLegend(legend.tokenTypes, legend.tokenModifiers)));
}

function gone(command, reason) {
  diagnostics.clear();
  if (++restarts <= MAX_RESTARTS && !reason.includes('ENOENT')) return start();
  vscode.window.showErrorMessage(
    `arbiter: ${command} lsp has ended (${reason}). Is the setting arbiter.path right?`);
}

async function restart() {
  restarts = 0;
  await server.client.stop();
  diagnostics.clear();
  start();
}

// What the server answers; null where it has gone, has refused, or was told to forget it.
async function ask(method, params, token) {
  try {
    await server.ready;
    return await server.client.request(method, params, token);
  } catch {
    return null;
  }
}

// --- Providers ---

const list = (found, make) => (found || []).map(make);

const providers = {
  provideHover: async (document, at, token) => {
    const found = await ask('textDocument/hover', place(document, at), token);
    return found && new vscode.Hover(markdown(found.contents), range(found.range));
  },
  provideCompletionItems: async (document, at, token) =>
    list(await ask('textDocument/completion', place(document, at), token), completionItem),
  provideDefinition: async (document, at, token) => {
    const found = await ask('textDocument/definition', place(document, at), token);
    return found && location(found);
  },
  provideReferences: async (document, at, context, token) =>
    list(await ask('textDocument/references', {
      ...place(document, at), context: { includeDeclaration: context.includeDeclaration },
    }, token), location),
  provideDocumentHighlights: async (document, at, token) =>
    list(await ask('textDocument/documentHighlight', place(document, at), token),
      (h) => new vscode.DocumentHighlight(range(h.range), h.kind - 1)),
  provideDocumentSymbols: async (document, token) =>
    list(await ask('textDocument/documentSymbol', { textDocument: { uri: uriOf(document) } },
      token), symbol),
  provideInlayHints: async (document, visible, token) =>
    list(await ask('textDocument/inlayHint', {
      textDocument: { uri: uriOf(document) }, range: plainRange(visible),
    }, token), inlayHint),
  provideDocumentSemanticTokens: async (document, token) => {
    const found = await ask('textDocument/semanticTokens/full',
      { textDocument: { uri: uriOf(document) } }, token);
    return found && new vscode.SemanticTokens(new Uint32Array(found.data));
  },
  // A refusal is shown as the error that it is.
  prepareRename: async (document, at, token) => {
    await server.ready;
    const found = await server.client.request('textDocument/prepareRename', place(document, at),
      token);
    return { range: range(found.range), placeholder: found.placeholder };
  },
  provideRenameEdits: async (document, at, newName, token) => {
    await server.ready;
    const found = await server.client.request('textDocument/rename',
      { ...place(document, at), newName }, token);
    const edit = new vscode.WorkspaceEdit();
    for (const [uri, changes] of Object.entries(found.changes))
      for (const change of changes)
        edit.replace(vscode.Uri.parse(uri), range(change.range), change.newText);
    return edit;
  },
};

// --- What VS Code calls ---

function changed(event) {
  // A text that the server does not know yet goes to it as it is then.
  if (!server.opened.has(uriOf(event.document)) || event.contentChanges.length === 0) return;
  server.client.notify('textDocument/didChange', {
    textDocument: { uri: uriOf(event.document), version: event.document.version },
    // VS Code gives ranges of the text before the event, the last of the text first: one after
    // another they mean the same.
    contentChanges: event.contentChanges.map((change) => ({
      range: plainRange(change.range), text: change.text,
    })),
  });
}

function closed(document) {
  if (server.opened.delete(uriOf(document)))
    server.client.notify('textDocument/didClose', { textDocument: { uri: uriOf(document) } });
}

function configured(event) {
  if (event.affectsConfiguration('arbiter.path')) return restart();
  const profile = settings().get('profile');
  if (event.affectsConfiguration('arbiter.profile') && profile)
    return server.ready.then(() => server.client.notify('workspace/didChangeConfiguration',
      { settings: { arbiter: { profile } } }), () => {});
  if (event.affectsConfiguration('arbiter.profile')) return restart(); // back to the default
  return undefined;
}

function activate(context) {
  diagnostics = vscode.languages.createDiagnosticCollection('arbiter');
  subscriptions = context.subscriptions;
  start();
  const { languages, workspace } = vscode;
  context.subscriptions.push(
    diagnostics,
    workspace.onDidOpenTextDocument((document) => {
      if (isOurs(document)) server.ready.then(() => open(document), () => {});
    }),
    workspace.onDidChangeTextDocument(changed),
    workspace.onDidCloseTextDocument(closed),
    workspace.onDidChangeConfiguration(configured),
    vscode.commands.registerCommand('arbiter.restart', restart),
    languages.registerHoverProvider(LANGUAGE, providers),
    languages.registerCompletionItemProvider(LANGUAGE, providers, '.', '['),
    languages.registerDefinitionProvider(LANGUAGE, providers),
    languages.registerReferenceProvider(LANGUAGE, providers),
    languages.registerDocumentHighlightProvider(LANGUAGE, providers),
    languages.registerRenameProvider(LANGUAGE, providers),
    languages.registerDocumentSymbolProvider(LANGUAGE, providers),
    languages.registerInlayHintsProvider(LANGUAGE, providers),
  );
}

function deactivate() {
  return server ? server.client.stop() : undefined;
}

module.exports = { activate, deactivate };
