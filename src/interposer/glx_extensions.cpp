#include "interposer/glx_extensions.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <set>
#include <string>
#include <string_view>

#include "util/flags.h"
#include "util/log.h"

namespace arbiter::interposer {

namespace {

/// Stores each text once; it is never freed.
const char *keep(std::string text) {
  static std::mutex s_mutex;
  static auto *const s_texts = new std::set<std::string>;
  const std::lock_guard lock(s_mutex);
  return s_texts->insert(std::move(text)).first->c_str();
}

bool lists(std::string_view names, const std::string &name) {
  return (" " + std::string(names) + " ").find(" " + name + " ") != std::string::npos;
}

} // namespace

const char *switchedExtensions(const char *host) {
  const std::vector<ExtensionSwitch> &switches = settings().extensions;
  if (!host || std::none_of(switches.begin(), switches.end(), [](const ExtensionSwitch &each) {
        return each.name.starts_with("GLX_");
      }))
    return host;
  std::string shown;
  for (std::string_view rest = host; !rest.empty();) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    const std::string_view name = rest.substr(0, end);
    rest.remove_prefix(std::min(end + 1, rest.size()));
    const bool hidden =
        std::any_of(switches.begin(), switches.end(),
                    [&](const ExtensionSwitch &each) { return !each.on && each.name == name; });
    if (!name.empty() && !hidden)
      (shown += name) += ' ';
  }
  static std::atomic<bool> s_said;
  const bool said = s_said.exchange(true);
  for (const ExtensionSwitch &each : switches)
    if (!said && each.on && each.name.starts_with("GLX_") && !lists(host, each.name))
      logError("layer",
               "ARBITER_EXTENSIONS: %s=on: the host does not implement it; it is not announced",
               each.name.c_str());
  return keep(std::move(shown));
}

} // namespace arbiter::interposer
