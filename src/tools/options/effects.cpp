#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

#include "tools/options/options.h"

/// An option that has no effect is a mistake in the command line: reported, not ignored.
namespace arbiter::tools {

namespace {

/// `option` does nothing where `beside` was given, or has one of `values`.
struct Row {
  const char *verb, *option, *beside;
  std::string_view values = {}; ///< between spaces; empty: any, if it was given
  const char *unless = nullptr; ///< an option that gives it an effect again
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
    {"compile", "--optimise", "--emit", " tokens glsl native llvm machine "},
    {"compile", "--numerics", "--emit", " tokens native "},
    {"compile", "--numerics", "--emit", " ir assembly ", "--optimise"},
    {"debug", "--line", "--json"},
    {"debug", "--watch", "--stage", " vertex "},
    {"debug", "--against", "--stage", " vertex "},
};

bool isGiven(const CLI::Option *option) { return option && option->count() != 0; }

/// The value given, or the default; empty where there is none.
std::string valueOf(const CLI::Option &option) {
  const std::string value =
      option.results().empty() ? option.get_default_str() : option.results().front();
  return " " + value + " ";
}

std::string withoutEffect(const CLI::App &verb, const Row &row) {
  const CLI::Option *const beside = verb.get_option_no_throw(row.beside);
  if (!isGiven(verb.get_option_no_throw(row.option)))
    return {};
  if (row.unless && isGiven(verb.get_option_no_throw(row.unless)))
    return {};
  if (row.values.empty())
    return isGiven(beside) ? std::string(row.option) + " has no effect with " + row.beside
                           : std::string();
  const std::string value = valueOf(*beside);
  if (row.values.find(value) == std::string_view::npos)
    return {};
  return std::string(row.option) + " has no effect with " + row.beside +
         value.substr(0, value.size() - 1) +
         (row.unless ? std::string(" but beside ") + row.unless : std::string());
}

/// Where the layer is not loaded, none of its options has an effect.
std::string layerWithoutEffect(const CLI::App &verb, const char *without) {
  if (!isGiven(verb.get_option_no_throw(without)))
    return {};
  for (const CLI::Option *option : verb.get_options())
    if (option->get_group() == kLayerGroup && isGiven(option))
      return option->get_name() + " has no effect with " + without;
  return {};
}

} // namespace

std::string withoutEffect(const CLI::App &verb) {
  for (const Row &row : kRows)
    if (verb.get_name() == row.verb)
      if (std::string fault = withoutEffect(verb, row); !fault.empty())
        return fault;
  if (verb.get_name() == "draw" || verb.get_name() == "render")
    return layerWithoutEffect(verb, "--bare");
  if (verb.get_name() == "capture")
    return layerWithoutEffect(verb, "--index-only");
  return {};
}

} // namespace arbiter::tools
