#include <algorithm>
#include <string_view>

#include "apps/tools/options/options.h"
#include "apps/tools/options/verb.h"

/// Reports options that have no effect, because they are probably mistakes.
namespace arbiter::tools {

namespace {

/// `option` has no effect if `beside` was given, or if `beside` has one of `values`.
struct Row {
  const char *verb, *option, *beside;
  std::string_view values = {}; ///< separated by spaces; empty: any value
  const char *unless = nullptr; ///< an option that restores the effect
  std::string_view but = {};    ///< a value of `option` that has an effect for some files; the verb
                                ///< checks it
};
constexpr Row kRows[] = {
    {"check", "--brief", "--json"},
    {"check", "--why", "--json"},
    {"check", "--gauges", "--json"},
    {"check", "--why", "--brief"},
    {"check", "--gauges", "--brief"},
    {"check", "--gauges", "--compare"},
    {"compile", "--profile", "--emit", " tokens "},
    {"compile", "--language", "--emit", " tokens "},
    {"compile", "--optimize", "--emit", " tokens glsl native llvm machine "},
    {"compile", "--numerics", "--emit", " tokens native "},
    {"compile", "--numerics", "--emit", " ir assembly ", "--optimize", "fx9"},
    {"debug", "--line", "--json"},
    {"debug", "--line", "--watch"},
    {"debug", "--break", "--watch", {}, "--json"},
    {"debug", "--watch", "--stage", " vertex "},
    {"debug", "--against", "--stage", " vertex "},
};

using AllSaid = std::vector<Said>;

const Said *find(const AllSaid &all, const char *name) {
  const auto found =
      std::find_if(all.begin(), all.end(), [&](const Said &each) { return each.name == name; });
  return found == all.end() ? nullptr : &*found;
}

bool isGiven(const AllSaid &all, const char *name) {
  const Said *const said = find(all, name);
  return said && said->given;
}

std::string withoutEffect(const AllSaid &all, const Row &row) {
  if (!isGiven(all, row.option) || (row.unless && isGiven(all, row.unless)))
    return {};
  if (!row.but.empty() && find(all, row.option)->value == row.but)
    return {};
  if (row.values.empty())
    return isGiven(all, row.beside) ? std::string(row.option) + " has no effect with " + row.beside
                                    : std::string();
  const std::string value = " " + find(all, row.beside)->value;
  if (row.values.find(value + " ") == std::string_view::npos)
    return {};
  return std::string(row.option) + " has no effect with " + row.beside + value +
         (row.unless ? std::string(" but beside ") + row.unless : std::string());
}

/// Returns a complaint if options of the layer are given while the layer is not loaded.
std::string layerWithoutEffect(const AllSaid &all, const char *without) {
  if (!isGiven(all, without))
    return {};
  for (const Said &said : all)
    if (said.group == kLayerGroup && said.given)
      return said.name + " has no effect with " + without;
  return {};
}

} // namespace

std::string withoutEffect(const CLI::App &verb) {
  const AllSaid all = saidOf(verb);
  const std::string name = nameOf(verb);
  for (const Row &row : kRows)
    if (name == row.verb)
      if (std::string fault = withoutEffect(all, row); !fault.empty())
        return fault;
  if (name == "draw" || name == "render")
    return layerWithoutEffect(all, "--bare");
  if (name == "capture")
    return layerWithoutEffect(all, "--index-only");
  return {};
}

} // namespace arbiter::tools
