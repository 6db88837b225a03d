#include "apps/tools/lsp/server.h"

#include <algorithm>
#include <csignal>
#include <unistd.h>

#include "apps/tools/commands.h"
#include "apps/tools/input.h"

namespace arbiter::tools::lsp {

namespace {

// Error codes of JSON-RPC and of the protocol.
constexpr int kParseError = -32700;
constexpr int kInvalidRequest = -32600;
constexpr int kMethodNotFound = -32601;
constexpr int kServerNotInitialized = -32002;
constexpr int kRequestCancelled = -32800;

/// The number of messages read ahead to find cancelled requests.
constexpr std::size_t kMaxWaiting = 256;
/// The longest delay of diagnostics while edits arrive without a pause.
constexpr std::chrono::milliseconds kMaxDelay{20};

bool isId(const Json &id) { return id.is_string() || id.is_number_integer(); }

} // namespace

struct Server::RequestRow {
  const char *method;
  std::variant<Request, DocumentRequest> answer;
};
struct Server::NotificationRow {
  const char *method;
  Notification take;
};

const Server::RequestRow Server::kRequests[] = {
    {"initialize", &Server::initialize},
    {"shutdown", &Server::shutdown},
    {"textDocument/hover", &Server::hoverAt},
    {"textDocument/completion", &Server::completionAt},
    {"textDocument/definition", &Server::definitionAt},
    {"textDocument/references", &Server::referencesAt},
    {"textDocument/documentHighlight", &Server::highlightsAt},
    {"textDocument/prepareRename", &Server::prepareRenameAt},
    {"textDocument/rename", &Server::renameAt},
    {"textDocument/documentSymbol", &Server::symbolsOf},
    {"textDocument/inlayHint", &Server::inlayHintsOf},
    {"textDocument/semanticTokens/full", &Server::semanticTokensOf},
    {"arbiter/trace", &Server::traceOf},
    {"textDocument/codeAction", &Server::codeActionsOf},
    {"codeAction/resolve", &Server::resolveAction},
    {"arbiter/advice", &Server::adviceOf},
    {"arbiter/report", &Server::reportOf},
};

const Server::NotificationRow Server::kNotifications[] = {
    {"textDocument/didOpen", &Server::opened},
    {"textDocument/didChange", &Server::changed},
    {"textDocument/didClose", &Server::closed},
    {"workspace/didChangeConfiguration", &Server::configurationChanged},
};

Server::Server(Transport &transport, ProfileChoice profiles)
    : m_transport(transport), m_startProfiles(profiles), m_profiles(std::move(profiles)) {}

int Server::run() {
  while (m_state != State::Exited && !m_gone) {
    if (m_waiting.empty()) {
      if (!m_transport.pending())
        publishChanged();
      if (!receive())
        break;
      continue; // the message may have been invalid
    }
    while (m_waiting.size() < kMaxWaiting && m_transport.pending())
      if (!receive())
        break;
    const Json message = std::move(m_waiting.front());
    m_waiting.pop_front();
    handle(message);
    if (m_changedSince && std::chrono::steady_clock::now() - *m_changedSince > kMaxDelay)
      publishChanged();
  }
  return m_wasShutDown ? 0 : 1;
}

/// Reads one message into the queue. False at the end of the input.
bool Server::receive() {
  std::string body;
  switch (m_transport.read(body)) {
  case Transport::Read::Message:
    parse(body);
    return true;
  case Transport::Read::BadHeader:
    reply(nullptr, RpcError{kParseError, "a message without a usable Content-Length"});
    return true;
  case Transport::Read::TooLong:
    reply(nullptr, RpcError{kInvalidRequest, "a message of more than 64 MiB"});
    return true;
  case Transport::Read::Closed:
    break;
  }
  return false;
}

void Server::parse(const std::string &body) {
  Json message = Json::parse(body, nullptr, false);
  if (message.is_discarded())
    return reply(nullptr, RpcError{kParseError, "the message is no JSON"});
  const std::string *method = stringAt(message, {"method"});
  if (method && *method == "$/cancelRequest") {
    const Json *id = member(message, {"params", "id"});
    const bool waits =
        id && isId(*id) && std::any_of(m_waiting.begin(), m_waiting.end(), [&](const Json &other) {
          const Json *its = member(other, {"id"});
          return its && *its == *id;
        });
    if (waits)
      m_cancelled.insert(*id);
    return;
  }
  m_waiting.push_back(std::move(message));
}

void Server::handle(const Json &message) {
  const std::string *method = stringAt(message, {"method"});
  const Json *id = member(message, {"id"});
  static const Json kNone = Json::object();
  const Json *params = member(message, {"params"});
  if (!method) {
    const bool response = member(message, {"result"}) || member(message, {"error"});
    if (!response)
      reply(id && isId(*id) ? *id : Json(),
            RpcError{kInvalidRequest, "a message without a method"});
    return;
  }
  if (!id)
    return notify(*method, params ? *params : kNone);
  if (!isId(*id))
    return reply(nullptr, RpcError{kInvalidRequest, "an id that is neither text nor a number"});
  if (m_cancelled.erase(*id) > 0)
    return reply(*id, RpcError{kRequestCancelled, "cancelled"});
  reply(*id, answer(*method, params ? *params : kNone));
}

Server::Reply Server::answer(const std::string &method, const Json &params) {
  const auto row = std::find_if(std::begin(kRequests), std::end(kRequests),
                                [&](const RequestRow &r) { return method == r.method; });
  const bool initializes = method == "initialize";
  if (m_state == State::New && !initializes)
    return RpcError{kServerNotInitialized, "initialize comes first"};
  if (m_state == State::ShutDown)
    return RpcError{kInvalidRequest, "the server is shut down"};
  if (m_state == State::Running && initializes)
    return RpcError{kInvalidRequest, "initialize came before"};
  if (row == std::end(kRequests))
    return RpcError{kMethodNotFound, "no method " + method.substr(0, 100)};
  if (const Request *const request = std::get_if<Request>(&row->answer))
    return (this->**request)(params);
  Document *const document = find(params);
  if (!document)
    return noDocument();
  return (this->*std::get<DocumentRequest>(row->answer))(*document, params);
}

void Server::notify(const std::string &method, const Json &params) {
  if (method == "exit") {
    m_state = State::Exited;
    return;
  }
  if (m_state != State::Running)
    return;
  for (const NotificationRow &row : kNotifications)
    if (method == row.method)
      return (this->*row.take)(params);
}

void Server::reply(const Json &id, const Reply &result) {
  Json message = {{"jsonrpc", "2.0"}, {"id", id}};
  if (result)
    message["result"] = result.value();
  else
    message["error"] = {{"code", result.error().code}, {"message", result.error().message}};
  send(message);
}

void Server::sendNotification(const char *method, Json params) {
  send({{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}});
}

void Server::send(const Json &message) {
  // A text cut within a character is not UTF-8; dump() would throw without `replace`.
  m_gone = !m_transport.write(message.dump(-1, ' ', false, Json::error_handler_t::replace));
}

void Server::publishChanged() {
  m_changedSince.reset();
  for (auto &[uri, document] : m_documents)
    if (document.changed)
      publish(document);
}

} // namespace arbiter::tools::lsp

namespace arbiter::tools {

int serve(const LspArguments &arguments) {
  auto profiles = ProfileChoice::make(arguments.profile);
  if (!profiles) {
    complain(profiles.error().message);
    return kExitUsage;
  }
  std::signal(SIGPIPE, SIG_IGN); // write() then reports a client that has gone
  lsp::Transport transport(STDIN_FILENO, STDOUT_FILENO);
  const int code = lsp::Server(transport, std::move(profiles).value()).run();
  if (code != kExitOk)
    complain("the input ended without shutdown and exit");
  return code;
}

} // namespace arbiter::tools
