#include "fp_compiler/hw/names.h"

#include <vector>

#include "fp_compiler/hw/profile.h"
#include "util/suggest.h"

namespace arbiter::fp::hw {

std::string meant(std::string_view typed, std::span<const std::string_view> known) {
  const std::string_view near = closest(typed, known);
  return near.empty() ? std::string() : "; did you mean \"" + std::string(near) + "\"?";
}

std::string joined(std::span<const std::string_view> names) {
  std::string text;
  for (const std::string_view name : names)
    text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

std::string unknownProfile(std::string_view name) {
  const std::vector<std::string_view> names = builtinNames();
  return "no profile \"" + std::string(name.substr(0, 64)) + "\"" + meant(name, names) +
         " (built in: " + joined(names) + "; or the path of a TOML file)";
}

} // namespace arbiter::fp::hw
