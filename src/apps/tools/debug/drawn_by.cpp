#include "apps/tools/debug/drawn_by.h"

#include <nlohmann/json.hpp>

#include "apps/tools/input.h"

namespace arbiter::tools::debug {

namespace {

using Json = nlohmann::json;

std::uint64_t countOf(const Json &draws, const char *name) {
  const auto found = draws.find(name);
  return found != draws.end() && found->is_number_unsigned() ? found->get<std::uint64_t>() : 0;
}

/// Lists the reasons why the rasterizer left draws to the host.
std::string reasonsOf(const Json &statistics) {
  std::string text;
  const Json given = statistics.value("/software/given_to_host"_json_pointer, Json());
  for (const auto &[reason, count] : given.items())
    text += (text.empty() ? ": " : ", ") + reason;
  return text;
}

} // namespace

std::string DrawnBy::path() const {
  return m_folder.path().empty() ? std::string() : m_folder.path() + "/statistics.json";
}

std::string DrawnBy::note() const {
  if (m_folder.path().empty())
    return {};
  const auto text = readInput(path());
  return text ? drawnByNote(text.value()) : std::string();
}

std::string drawnByNote(const std::string &statistics) {
  const Json json = Json::parse(statistics, nullptr, false);
  const auto draws = json.is_object() ? json.find("draws") : json.end();
  if (!json.is_object() || draws == json.end() || !draws->is_object())
    return {};
  const std::uint64_t own = countOf(*draws, "rasterizer");
  const std::uint64_t hosts = countOf(*draws, "host_glsl") + countOf(*draws, "host_assembly");
  if (hosts == 0)
    return {};
  return "the rasterizer left " + std::to_string(hosts) + " of " + std::to_string(own + hosts) +
         " draws to the host" + reasonsOf(json);
}

} // namespace arbiter::tools::debug
