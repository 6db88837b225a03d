#include "fp_compiler/hw/names.h"

#include <algorithm>

#include "fp_compiler/hw/builtin.h"
#include "util/suggest.h"
#include "util/text/letters.h"

namespace arbiter::fp::hw {

namespace {

constexpr std::size_t kMaxName = 64;

/// A card that people ask for and that has no profile.
struct Absent {
  std::string_view name;
  const char *why;
};
constexpr const char *kOfR200 = "the chip, an R200, has no ARB_fragment_program; its ATI fragment "
                                "shaders have the same limits under every profile";
constexpr Absent kAbsent[] = {
    {"r200", kOfR200},       {"radeon8500", kOfR200},
    {"8500", kOfR200},       {"radeon9000", kOfR200},
    {"radeon9200", kOfR200}, {"all", "only arbiter check takes all cards at once"},
};

/// Returns the name in lower case, without spaces, dashes and underscores: "radeon9700" for "Radeon
/// 9700".
std::string plain(std::string_view typed) {
  std::string name;
  for (const char c : typed.substr(0, kMaxName))
    if (c != ' ' && c != '-' && c != '_')
      name += lowerCase(c);
  return name;
}

/// Returns a plain() name without its maker and with the series in full: "geforce4" for "gf4",
/// "radeon9700" for "r9700", "geforcefx5900" for "nvidiagffx5900".
std::string inFull(std::string name) {
  for (const std::string_view maker : {"ati", "nvidia", "intel"})
    if (name.starts_with(maker))
      name.erase(0, maker.size());
  if (name.starts_with("gf"))
    return "geforce" + name.substr(2);
  // A chip has three digits, as the R300; a card of ATI's four.
  if (name.size() > 4 && name[0] == 'r' && std::all_of(&name[1], &name[5], isDigit))
    return "radeon" + name.substr(1);
  return name;
}

std::string_view builtinCalled(std::string_view name) {
  for (const BuiltinProfile &profile : builtinTable()) {
    if (plain(profile.name) == name)
      return profile.name;
    const std::vector<std::string_view> aliases = aliasesOf(profile.name);
    if (std::find(aliases.begin(), aliases.end(), name) != aliases.end())
      return profile.name;
  }
  return {};
}

} // namespace

std::vector<std::string_view> aliasesOf(std::string_view builtin) {
  std::vector<std::string_view> aliases;
  for (const BuiltinProfile &profile : builtinTable())
    if (profile.name == builtin)
      for (std::string_view rest = profile.aliases; !rest.empty();) {
        const std::size_t end = std::min(rest.find('|'), rest.size());
        aliases.push_back(rest.substr(0, end));
        rest.remove_prefix(std::min(end + 1, rest.size()));
      }
  return aliases;
}

std::string_view builtinMeant(std::string_view typed) {
  const std::string name = plain(typed);
  const std::string_view found = builtinCalled(name);
  return found.empty() ? builtinCalled(inFull(name)) : found;
}

std::string meant(std::string_view typed, std::span<const std::string_view> known) {
  const std::string_view near = nearest(typed, known);
  return near.empty() ? std::string() : "; did you mean \"" + std::string(near) + "\"?";
}

std::string joined(std::span<const std::string_view> names) {
  std::string text;
  for (const std::string_view name : names)
    text += (text.empty() ? "" : ", ") + std::string(name);
  return text;
}

std::string unknownProfile(std::string_view name) {
  const std::string start = "no profile \"" + std::string(name.substr(0, kMaxName)) + "\"";
  const std::string full = inFull(plain(name));
  for (const Absent &absent : kAbsent)
    if (absent.name == plain(name) || absent.name == full)
      return start + ": " + absent.why;
  const std::vector<std::string_view> names = builtinNames();
  std::vector<std::string_view> known = names;
  for (const std::string_view builtin : names)
    for (const std::string_view alias : aliasesOf(builtin))
      known.push_back(alias);
  const std::string near = meant(name, known);
  return start + (near.empty() ? meant(full, known) : near) + " (built in: " + joined(names) +
         "; or the path of a TOML file; arbiter profiles says which cards these are)";
}

} // namespace arbiter::fp::hw
