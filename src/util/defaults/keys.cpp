#include <cctype>

#include "util/defaults/entry.h"

namespace arbiter::defaults {

namespace {

/// The variables that decide what a program is told and how it is drawn. Others are the user's
/// alone to set: where reports go, who may observe, and what is kept on disk.
constexpr Env kVariables[] = {
    Env::Profile,    Env::Limits,   Env::Identity, Env::ExtensionsMaxYear, Env::ExtensionsMaxLength,
    Env::Extensions, Env::Numerics, Env::Backend,  Env::FixedFunction,     Env::Attributes,
    Env::Threads,
};

std::string keyOf(Env variable) {
  constexpr std::string_view kPrefix = "ARBITER_";
  std::string key = std::string(info(variable).name).substr(kPrefix.size());
  for (char &c : key)
    c = char(std::tolower(static_cast<unsigned char>(c)));
  return key;
}

} // namespace

std::span<const Key> keys() {
  // The list is never destroyed: another thread may ask while the process ends.
  static const auto *const s_keys = [] {
    auto *made = new std::vector<Key>;
    for (const Env variable : kVariables)
      made->push_back({keyOf(variable), variable});
    return made;
  }();
  return *s_keys;
}

} // namespace arbiter::defaults
