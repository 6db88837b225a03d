#include <GL/arbiter.h>
#include <algorithm>

#include "apps/tools/lsp/server.h"

namespace arbiter::tools::lsp {

namespace {

Json capabilities(Encoding encoding) {
  constexpr int kIncremental = 2;
  return {
      {"positionEncoding", encoding == Encoding::Utf8 ? "utf-8" : "utf-16"},
      {"textDocumentSync", {{"openClose", true}, {"change", kIncremental}}},
      {"hoverProvider", true},
      {"completionProvider", {{"triggerCharacters", Json::array({".", "["})}}},
      {"definitionProvider", true},
      {"referencesProvider", true},
      {"documentHighlightProvider", true},
      {"renameProvider", {{"prepareProvider", true}}},
      {"documentSymbolProvider", true},
      {"inlayHintProvider", true},
      {"codeActionProvider",
       {{"codeActionKinds", Json::array({"quickfix", "refactor.rewrite"})},
        {"resolveProvider", true}}},
      {"semanticTokensProvider", {{"legend", semanticLegend()}, {"full", true}}},
  };
}

} // namespace

Server::Reply Server::initialize(const Json &params) {
  const Json *offered = member(params, {"capabilities", "general", "positionEncodings"});
  if (offered && offered->is_array() &&
      std::find(offered->begin(), offered->end(), Json("utf-8")) != offered->end())
    m_encoding = Encoding::Utf8;
  m_refreshesHints = trueAt(params, {"capabilities", "workspace", "inlayHint", "refreshSupport"});
  m_showsDisabled =
      trueAt(params, {"capabilities", "textDocument", "codeAction", "disabledSupport"});
  if (const Json *settings = member(params, {"initializationOptions"}))
    useProfile(*settings);
  m_state = State::Running;
  return Json{{"capabilities", capabilities(m_encoding)},
              {"serverInfo", {{"name", "arbiter"}, {"version", ARBITER_VERSION_TEXT}}}};
}

Server::Reply Server::shutdown(const Json &) {
  m_state = State::ShutDown;
  m_wasShutDown = true;
  return Json();
}

/// Takes {"profile": name or path}, or the same as the member "arbiter". An empty name restores the
/// profile of the start. False if nothing changed.
bool Server::useProfile(const Json &settings) {
  const std::string *name = stringAt(settings, {"arbiter", "profile"});
  if (!name)
    name = stringAt(settings, {"profile"});
  if (!name || *name == m_profiles.asked())
    return false;
  auto profiles = name->empty() ? Result<ProfileChoice, fp::hw::ProfileError>(m_startProfiles)
                                : ProfileChoice::make(*name);
  if (!profiles) {
    constexpr int kError = 1;
    sendNotification("window/showMessage",
                     {{"type", kError}, {"message", "arbiter: " + profiles.error().message}});
    return false;
  }
  for (auto &[uri, document] : m_documents)
    document.forget();
  m_profiles = std::move(profiles).value();
  return true;
}

void Server::configurationChanged(const Json &params) {
  const Json *settings = member(params, {"settings"});
  if (!settings || !useProfile(*settings))
    return;
  for (auto &[uri, document] : m_documents)
    document.changed = true;
  m_changedSince = std::chrono::steady_clock::now();
  if (m_refreshesHints)
    send({{"jsonrpc", "2.0"}, {"id", m_nextId++}, {"method", "workspace/inlayHint/refresh"}});
}

} // namespace arbiter::tools::lsp
