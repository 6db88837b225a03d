#pragma once
#include <chrono>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>

#include "apps/tools/lsp/answers.h"
#include "apps/tools/lsp/trace.h"
#include "apps/tools/lsp/transport.h"
#include "apps/tools/lsp/uri.h"
#include "apps/tools/profile_choice.h"

namespace arbiter::tools::lsp {

/// An error of JSON-RPC.
struct RpcError {
  int code = 0;
  std::string message;
};
inline constexpr int kInvalidParams = -32602; ///< a code of JSON-RPC
[[nodiscard]] inline RpcError noDocument() {
  return {kInvalidParams, "no open document of this URI"};
}

/// A language server for one client (Language Server Protocol 3.17), on one thread. Requests are
/// answered in order, unless they are cancelled while they wait. Diagnostics are sent when no
/// message waits, so that a burst of edits costs one check.
class Server {
public:
  /// \param profiles from the command line; a client's settings may select another
  Server(Transport &transport, ProfileChoice profiles);

  /// Serves until `exit` or the end of the input.
  /// \returns the exit code: 0 after `shutdown`, else 1.
  [[nodiscard]] int run();

private:
  using Reply = Result<Json, RpcError>;
  using Request = Reply (Server::*)(const Json &params);
  using DocumentRequest = Reply (Server::*)(Document &document, const Json &params);
  using Notification = void (Server::*)(const Json &params);

  // server.cpp: messages
  bool receive();
  void parse(const std::string &body);
  void handle(const Json &message);
  Reply answer(const std::string &method, const Json &params);
  void notify(const std::string &method, const Json &params);
  void reply(const Json &id, const Reply &reply);
  void send(const Json &message);
  void sendNotification(const char *method, Json params);
  void publishChanged();

  // lifecycle.cpp
  Reply initialize(const Json &params);
  Reply shutdown(const Json &params);
  void configurationChanged(const Json &params);
  bool useProfile(const Json &settings);

  // requests.cpp: texts, and requests about them
  void opened(const Json &params);
  void changed(const Json &params);
  void closed(const Json &params);
  void publish(Document &document);
  Document *find(const Json &params);
  [[nodiscard]] static std::optional<fp::Span> rangeOf(const Document &document,
                                                       const Json &params);
  /// Returns the view of the program that contains the byte.
  [[nodiscard]] View viewAt(Document &document, std::uint32_t offset) {
    const fp::hw::Profile &profile = profileOf(document);
    return {document, document.analysis(profile, offset), profile};
  }
  [[nodiscard]] Views viewsOf(Document &document) {
    const fp::hw::Profile &profile = profileOf(document);
    Views views;
    for (const Analysis &analysis : document.analyses(profile))
      views.push_back({document, analysis, profile});
    return views;
  }
  /// Calls `say` for each of the document's programs and joins the results.
  template <typename Say> [[nodiscard]] Json ofEach(Document &document, Say say) {
    Json all = Json::array();
    for (const View &view : viewsOf(document))
      for (Json &each : say(view))
        all.push_back(std::move(each));
    return all;
  }
  [[nodiscard]] const fp::hw::Profile &profileOf(const Document &document) {
    return m_profiles.of(pathOf(document.uri()), document.text());
  }
  /// Calls `handler` with the view and the offset that the parameters name, and returns its reply.
  template <typename Handler> Reply atPosition(const Json &params, Handler handler);
  Reply hoverAt(const Json &params);
  Reply completionAt(const Json &params);
  Reply definitionAt(const Json &params);
  Reply referencesAt(const Json &params);
  Reply highlightsAt(const Json &params);
  Reply prepareRenameAt(const Json &params);
  Reply renameAt(const Json &params);
  Reply symbolsOf(Document &document, const Json &params);
  Reply inlayHintsOf(Document &document, const Json &params);
  Reply semanticTokensOf(Document &document, const Json &params);
  Reply traceOf(Document &document, const Json &params);
  Reply codeActionsOf(Document &document, const Json &params);
  Reply resolveAction(const Json &action);
  Reply adviceOf(Document &document, const Json &params);

  // report.cpp
  Reply reportOf(Document &document, const Json &params);

  struct RequestRow;
  struct NotificationRow;
  static const RequestRow kRequests[];
  static const NotificationRow kNotifications[];

  enum class State : std::uint8_t { New, Running, ShutDown, Exited };

  Transport &m_transport;
  const ProfileChoice m_startProfiles;
  ProfileChoice m_profiles;
  Encoding m_encoding = Encoding::Utf16;
  bool m_refreshesHints = false; ///< true if the client supports workspace/inlayHint/refresh
  bool m_showsDisabled = false;  ///< true if the client shows disabled code actions
  State m_state = State::New;
  bool m_wasShutDown = false;
  bool m_gone = false; ///< true if the client no longer reads
  std::int64_t m_nextId = 1;
  std::deque<Json> m_waiting;
  std::set<Json> m_cancelled; ///< ids of waiting requests
  std::map<std::string, Document> m_documents;
  Traces m_traces;
  std::optional<std::chrono::steady_clock::time_point> m_changedSince;
};

} // namespace arbiter::tools::lsp
