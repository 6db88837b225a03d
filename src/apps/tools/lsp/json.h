#pragma once
#include <cstdint>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

/// Reads JSON from a client. Nothing about its shape is assumed: a member may be missing, and no
/// access throws.
namespace arbiter::tools::lsp {

using Json = nlohmann::json;

/// Returns the member at the end of a path of names, or nullptr.
[[nodiscard]] inline const Json *member(const Json &json,
                                        std::initializer_list<const char *> path) {
  const Json *at = &json;
  for (const char *name : path) {
    if (!at->is_object())
      return nullptr;
    const auto found = at->find(name);
    if (found == at->end())
      return nullptr;
    at = &*found;
  }
  return at;
}

[[nodiscard]] inline const std::string *stringAt(const Json &json,
                                                 std::initializer_list<const char *> path) {
  const Json *found = member(json, path);
  return found ? found->get_ptr<const Json::string_t *>() : nullptr;
}

[[nodiscard]] inline std::optional<std::int64_t>
integerAt(const Json &json, std::initializer_list<const char *> path) {
  const Json *found = member(json, path);
  if (!found || !found->is_number_integer())
    return std::nullopt;
  return found->get<std::int64_t>();
}

[[nodiscard]] inline bool trueAt(const Json &json, std::initializer_list<const char *> path) {
  const Json *found = member(json, path);
  return found && found->is_boolean() && found->get<bool>();
}

} // namespace arbiter::tools::lsp
