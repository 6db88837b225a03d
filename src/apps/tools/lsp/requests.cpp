#include "apps/tools/lsp/actions.h"
#include "apps/tools/lsp/server.h"

#include <algorithm>

namespace arbiter::tools::lsp {

namespace {

constexpr int kRequestFailed = -32803;

/// True for an integer that can be a coordinate of a picture.
bool isSmall(const Json &json) {
  return json.is_number_integer() && json.get<std::int64_t>() >= 0 &&
         json.get<std::int64_t>() < 65536;
}

RpcError noPosition() { return {kInvalidParams, "no position"}; }

} // namespace

Document *Server::find(const Json &params) {
  const std::string *uri = stringAt(params, {"textDocument", "uri"});
  const auto found = uri ? m_documents.find(*uri) : m_documents.end();
  return found == m_documents.end() ? nullptr : &found->second;
}

void Server::opened(const Json &params) {
  const std::string *uri = stringAt(params, {"textDocument", "uri"});
  const std::string *text = stringAt(params, {"textDocument", "text"});
  const std::string *language = stringAt(params, {"textDocument", "languageId"});
  if (!uri || !text)
    return;
  m_documents.erase(*uri);
  const auto [entry, isNew] =
      m_documents.try_emplace(*uri, *uri, language ? *language : std::string(), *text, m_encoding);
  entry->second.version = integerAt(params, {"textDocument", "version"}).value_or(0);
  m_changedSince = std::chrono::steady_clock::now();
}

void Server::changed(const Json &params) {
  Document *document = find(params);
  const Json *changes = member(params, {"contentChanges"});
  if (!document || !changes || !changes->is_array())
    return;
  for (const Json &change : *changes) {
    if (document->change(change))
      continue;
    // The server's text now differs from the editor's, so that later answers may be wrong.
    constexpr int kError = 1;
    sendNotification("window/logMessage",
                     {{"type", kError}, {"message", "arbiter: a change that cannot be read"}});
    break;
  }
  document->version = integerAt(params, {"textDocument", "version"}).value_or(document->version);
  document->changed = true;
  if (!m_changedSince)
    m_changedSince = std::chrono::steady_clock::now();
}

void Server::closed(const Json &params) {
  const Document *document = find(params);
  if (!document)
    return;
  const std::string uri = document->uri();
  m_traces.forget(uri);
  m_documents.erase(uri);
  sendNotification("textDocument/publishDiagnostics",
                   {{"uri", uri}, {"diagnostics", Json::array()}});
}

void Server::publish(Document &document) {
  document.changed = false;
  sendNotification("textDocument/publishDiagnostics",
                   {{"uri", document.uri()},
                    {"version", document.version},
                    {"diagnostics", ofEach(document, diagnostics)}});
}

template <typename Handler> Server::Reply Server::atPosition(const Json &params, Handler handler) {
  Document *document = find(params);
  if (!document)
    return noDocument();
  const Json *position = member(params, {"position"});
  const auto offset = position ? document->map().offset(*position) : std::nullopt;
  if (!offset)
    return noPosition();
  return handler(viewAt(*document, *offset), *offset);
}

/// Appends the values of a trace to the description of the word.
Server::Reply Server::hoverAt(const Json &params) {
  return atPosition(params, [&](const View &view, std::uint32_t offset) -> Reply {
    Json found = hover(view, offset);
    const std::string values = m_traces.hover(view.document, offset);
    if (values.empty())
      return found;
    if (found.is_null())
      return Json{{"contents", {{"kind", "markdown"}, {"value", values}}}};
    found["contents"]["value"] = found["contents"]["value"].get<std::string>() + "\n\n" + values;
    return found;
  });
}

Server::Reply Server::completionAt(const Json &params) { return atPosition(params, completion); }

Server::Reply Server::definitionAt(const Json &params) { return atPosition(params, definition); }

Server::Reply Server::highlightsAt(const Json &params) { return atPosition(params, highlights); }

Server::Reply Server::referencesAt(const Json &params) {
  const bool withDeclaration = trueAt(params, {"context", "includeDeclaration"});
  return atPosition(params, [&](const View &view, std::uint32_t offset) {
    return references(view, offset, withDeclaration);
  });
}

Server::Reply Server::prepareRenameAt(const Json &params) {
  return atPosition(params, [](const View &view, std::uint32_t offset) -> Reply {
    auto result = prepareRename(view, offset);
    if (!result)
      return RpcError{kRequestFailed, result.error().message};
    return std::move(result).value();
  });
}

Server::Reply Server::renameAt(const Json &params) {
  const std::string *newName = stringAt(params, {"newName"});
  if (!newName)
    return RpcError{kInvalidParams, "no newName"};
  return atPosition(params, [&](const View &view, std::uint32_t offset) -> Reply {
    auto result = rename(view, offset, *newName);
    if (!result)
      return RpcError{kRequestFailed, result.error().message};
    return std::move(result).value();
  });
}

Server::Reply Server::symbolsOf(Document &document, const Json &) {
  return ofEach(document, documentSymbols);
}

/// Returns the bytes of the parameters' range.
std::optional<fp::Span> Server::rangeOf(const Document &document, const Json &params) {
  const Json *start = member(params, {"range", "start"});
  const Json *end = member(params, {"range", "end"});
  const auto from = start ? document.map().offset(*start) : std::nullopt;
  const auto to = end ? document.map().offset(*end) : std::nullopt;
  if (!from || !to)
    return std::nullopt;
  return fp::Span{*from, *to};
}

Server::Reply Server::inlayHintsOf(Document &document, const Json &params) {
  const std::optional<fp::Span> span = rangeOf(document, params);
  if (!span)
    return noPosition();
  Json hints = ofEach(document, [&](const View &view) { return inlayHints(view, *span); });
  for (Json &value : m_traces.hints(document, *span))
    hints.push_back(std::move(value));
  return hints;
}

/// Answers {textDocument, pixel: [x, y] or null, pass?, frame?, against?: "swrast" or "host"}; null
/// ends the trace.
Server::Reply Server::traceOf(Document &document, const Json &params) {
  const Json *const pixel = member(params, {"pixel"});
  if (pixel && pixel->is_null()) {
    m_traces.forget(document.uri());
    return Json();
  }
  if (!pixel || !pixel->is_array() || pixel->size() != 2 || !isSmall((*pixel)[0]) ||
      !isSmall((*pixel)[1]))
    return RpcError{kInvalidParams, "no pixel: [x, y]"};
  const std::string *const against = stringAt(params, {"against"});
  if (against && *against != "swrast" && *against != "host")
    return RpcError{kInvalidParams, "against is swrast or host"};
  TraceQuestion question;
  question.x = (*pixel)[0].get<int>();
  question.y = (*pixel)[1].get<int>();
  question.pass = int(std::clamp<std::int64_t>(integerAt(params, {"pass"}).value_or(1), 0, 1000));
  question.frame =
      int(std::clamp<std::int64_t>(integerAt(params, {"frame"}).value_or(0), 0, 100000));
  if (against && *against == "host")
    question.backend = debug::Backend::Host;
  question.profile = m_profiles.asked();
  auto trace = m_traces.ask(document, question);
  if (m_refreshesHints)
    send({{"jsonrpc", "2.0"}, {"id", m_nextId++}, {"method", "workspace/inlayHint/refresh"}});
  if (!trace)
    return RpcError{kRequestFailed, trace.error().message};
  return std::move(trace).value();
}

Server::Reply Server::codeActionsOf(Document &document, const Json &params) {
  const std::optional<fp::Span> span = rangeOf(document, params);
  if (!span)
    return noPosition();
  ActionRequest request{*span, {}, m_showsDisabled};
  if (const Json *only = member(params, {"context", "only"}); only && only->is_array())
    for (const Json &kind : *only)
      if (kind.is_string())
        request.only.push_back(kind.get<std::string>());
  return codeActions(viewAt(document, span->begin), document.advice(profileOf(document)), request);
}

/// Adds the edit to an action of this server that has none yet.
Server::Reply Server::resolveAction(const Json &action) {
  const std::string *uri = stringAt(action, {"data", "uri"});
  const auto found = uri ? m_documents.find(*uri) : m_documents.end();
  if (found == m_documents.end())
    return noDocument();
  Json resolved = action;
  resolved["edit"] = everyFix(viewsOf(found->second));
  return resolved;
}

Server::Reply Server::adviceOf(Document &document, const Json &) {
  return adviceList(viewAt(document, 0), document.advice(profileOf(document)));
}

Server::Reply Server::semanticTokensOf(Document &document, const Json &) {
  return semanticTokens(viewsOf(document));
}

} // namespace arbiter::tools::lsp
