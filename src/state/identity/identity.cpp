#include "state/identity/identity.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <memory>
#include <mutex>
#include <unordered_set>
#include <utility>
#include <vector>

#include "state/identity/active_profile.h"
#include "state/identity/era_offers.h"
#include "util/flags.h"
#include "util/log.h"

namespace arbiter::state {

namespace {

struct ExtensionYear {
  const char *name;
  std::uint16_t year;
};
constexpr ExtensionYear kYears[] = {
#define EXTENSION_YEAR(name, year) {name, year},
#include "state/identity/extension_years.def"
#undef EXTENSION_YEAR
};

/// Later than every known year, so that unknown extensions count as new.
constexpr std::uint32_t kUnknownYear = 0xFFFF;

/// Returns "1.3.4510 (X4.3.0)" as 13; 0 if there is no version.
int versionNumber(const std::string &text) {
  if (text.size() < 3 || text[1] != '.')
    return 0;
  return (text[0] - '0') * 10 + (text[2] - '0');
}

/// Sorts names by year, and by name within a year.
void sortByYear(std::vector<std::string> &names) {
  const auto year = [](const std::string &name) {
    return extensionYear(name).value_or(kUnknownYear);
  };
  std::sort(names.begin(), names.end(), [&](const std::string &a, const std::string &b) {
    const std::uint32_t yearA = year(a), yearB = year(b);
    return yearA != yearB ? yearA < yearB : a < b;
  });
}

void eraseOthers(std::vector<std::string> &names, const std::string &listed) {
  std::unordered_set<std::string_view> known;
  for (std::size_t at = 0; at < listed.size();) {
    const std::size_t end = std::min(listed.find(' ', at), listed.size());
    known.insert(std::string_view(listed).substr(at, end - at));
    at = end + 1;
  }
  std::erase_if(names, [&](const std::string &name) { return known.count(name) == 0; });
}

void eraseLater(std::vector<std::string> &names, std::uint32_t year) {
  std::erase_if(names, [&](const std::string &name) {
    return extensionYear(name).value_or(kUnknownYear) > year;
  });
}

/// Joins the names, each followed by a space, the last one too: programs search for "GL_name ".
void join(FilteredExtensions &extensions, std::uint32_t maxLength) {
  std::size_t kept = 0;
  for (const std::string &name : extensions.names) {
    if (maxLength != 0 && extensions.joined.size() + name.size() + 1 > maxLength)
      break;
    extensions.joined += name;
    extensions.joined += ' ';
    ++kept;
  }
  extensions.names.resize(kept);
}

void eraseByRules(std::vector<std::string> &names, const IdentityRules &rules) {
  if (rules.card && !rules.card->extensions.value.empty())
    eraseOthers(names, rules.card->extensions.value);
  if (rules.card && !rules.card->year.value.empty())
    eraseLater(names, std::uint32_t(std::atoi(rules.card->year.value.c_str())));
  if (rules.maxYear != 0)
    eraseLater(names, rules.maxYear);
}

/// The last year of the drivers that profiles describe. No program of their time knows a later
/// name.
constexpr std::uint32_t kLastYearOfTheEra = 2006;

/// Shortens the extension string to the length of the host's, newest host names first. Engines that
/// were patched for long strings have buffers of 8192 bytes. GetStringi still has the names, as
/// programs that know them ask by index.
void fitString(FilteredExtensions &extensions, const HostCaps &caps, const IdentityRules &rules) {
  std::vector<std::string> modern;
  for (const std::string &name : extensions.names)
    if (extensionYear(name).value_or(kUnknownYear) > kLastYearOfTheEra && caps.has(name.c_str()) &&
        !(rules.switches && isSwitchedOn(*rules.switches, name)))
      modern.push_back(name);
  sortByYear(modern);
  for (std::string &joined = extensions.joined;
       joined.size() > caps.extensionBytes && !modern.empty(); modern.pop_back()) {
    const std::string name = modern.back() + " ";
    const std::size_t at = joined.starts_with(name) ? 0 : joined.find(" " + name) + 1;
    joined.erase(at, name.size());
  }
}

void nameCard(Identity &identity, const HostCaps &caps, const fp::hw::Identity &card) {
  identity.vendor = card.vendor.value;
  identity.renderer = card.renderer.value;
  const int version = versionNumber(card.version.value);
  const int host = caps.major * 10 + caps.minor;
  if (version == 0 || version > host)
    return;
  identity.version = card.version.value;
  identity.major = version / 10;
  identity.minor = version % 10;
  const auto &names = identity.extensions.names;
  // GL_SHADING_LANGUAGE_VERSION came with this extension, and with OpenGL 2.0.
  identity.hidesShadingLanguage =
      version < 20 &&
      std::find(names.begin(), names.end(), "GL_ARB_shading_language_100") == names.end();
  if (versionNumber(card.shadingLanguage.value) * 10 <= caps.glslVersion)
    identity.shadingLanguage = card.shadingLanguage.value;
}

} // namespace

const Identity &internIdentity(Identity identity) {
  static std::mutex s_mutex;
  // The list is never freed. It is as short as the list of hosts and settings that a process sees.
  static auto *const s_identities = new std::vector<std::unique_ptr<const Identity>>;
  const std::lock_guard lock(s_mutex);
  for (const auto &known : *s_identities)
    if (*known == identity)
      return *known;
  return *s_identities->emplace_back(std::make_unique<const Identity>(std::move(identity)));
}

std::optional<std::uint32_t> extensionYear(std::string_view name) {
  const auto *const row =
      std::lower_bound(std::begin(kYears), std::end(kYears), name,
                       [](const ExtensionYear &a, std::string_view b) { return a.name < b; });
  if (row == std::end(kYears) || row->name != name)
    return std::nullopt;
  return row->year;
}

IdentityRules identityRules() {
  IdentityRules rules;
  // Under the profile `host` programs may use NVIDIA's options. They are announced only if the host
  // does so too: an application would choose them, and they are slower there than what it sends
  // without.
  rules.nvAsHost = activeProfile().fromHost;
  rules.nvFragmentOptions = activeProfile().fragment.nvOptions;
  rules.nvVertexOptions = activeProfile().vertex.nvOptions;
  rules.nvVertexProgram = activeProfile().vertex.nvVertexProgram;
  rules.generalCombiners = activeProfile().combiners.general;
  rules.perStageConstants = activeProfile().combiners.perStageConstants != 0;
  rules.textureShaders = activeProfile().textureShaders;
  rules.maxYear = settings().extensionsMaxYear;
  rules.maxLength = settings().extensionsMaxLength;
  if (!settings().extensions.empty())
    rules.switches = &settings().extensions;
  if (!settings().identityOfProfile)
    return rules;
  const fp::hw::Profile &profile = activeProfile();
  if (!profile.identity.empty())
    rules.card = &profile.identity;
  else
    logWarn("state", "ARBITER_IDENTITY: the profile %s has no [identity]; the host's is kept",
            profile.name.c_str());
  return rules;
}

namespace {

/// An extension of NVIDIA's program languages, with the least steps of the profile's fragment and
/// vertex options that it needs. `program` tells that it needs NV_vertex_program, whose commands
/// these languages share. `clips` tells that it needs a host with clip distances.
struct NvExtension {
  const char *name;
  std::uint32_t fragment, vertex, program;
  bool clips = false;
};
constexpr NvExtension kNvExtensions[] = {
    {"GL_NV_fragment_program", 1, 0, 1},
    {"GL_NV_fragment_program_option", 1, 0, 0},
    {"GL_NV_fragment_program2", 2, 0, 0},
    {"GL_NV_vertex_program", 0, 0, 1},
    {"GL_NV_vertex_program1_1", 0, 0, 1},
    {"GL_NV_vertex_program2", 0, 1, 1, true},
    {"GL_NV_vertex_program2_option", 0, 1, 0, true},
    {"GL_NV_vertex_program3", 0, 2, 0, true},
};

/// Adds the extensions of NVIDIA's languages that the rules and the host allow.
/// \param asHost adds only those that the host announces too
void addNvExtensions(std::vector<std::string> &names, const HostCaps &caps,
                     const IdentityRules &rules, bool asHost) {
  if (!caps.drawsNvOptions())
    return;
  for (const NvExtension &row : kNvExtensions)
    if (rules.nvFragmentOptions >= row.fragment && rules.nvVertexOptions >= row.vertex &&
        rules.nvVertexProgram >= row.program && (!asHost || caps.has(row.name)) &&
        (!row.clips || caps.clipDistances()))
      names.emplace_back(row.name);
}

/// Adds NVIDIA's combiner and texture shader extensions. The layer implements them in every context
/// that offers them, even if the host has them, as with ATI's fragment shaders.
void addStateShaders(std::vector<std::string> &names, const HostCaps &caps,
                     const IdentityRules &rules) {
  const auto announce = [&](const char *name, bool offered) {
    if (offered && std::find(names.begin(), names.end(), name) == names.end())
      names.emplace_back(name);
  };
  announce("GL_NV_register_combiners", rules.generalCombiners != 0);
  announce("GL_NV_register_combiners2", rules.perStageConstants);
  const std::uint32_t shaders = caps.drawsTextureShaders() ? rules.textureShaders : 0;
  announce("GL_NV_texture_shader", shaders >= 1);
  announce("GL_NV_texture_shader2", shaders >= 2);
  announce("GL_NV_texture_shader3", shaders >= 3);
}

/// Returns the extensions that the host and the layer implement in a context.
std::vector<std::string> implemented(const HostCaps &caps, bool offered, const IdentityRules &rules,
                                     bool nvAsHost) {
  std::vector<std::string> names = filterExtensions(caps, offered);
  if (!offered)
    return names;
  addNvExtensions(names, caps, rules, nvAsHost);
  addStateShaders(names, caps, rules);
  for (const char *const name : eraOffers(caps).names)
    names.emplace_back(name);
  return names;
}

/// Adds and hides names as the switches say.
/// \param absent gets switched-on names that nothing implements
void follow(const std::vector<ExtensionSwitch> &switches, const std::vector<std::string> &there,
            std::vector<std::string> &names, std::vector<std::string> &absent) {
  for (const ExtensionSwitch &each : switches) {
    const auto isIn = [&](const std::vector<std::string> &list) {
      return std::find(list.begin(), list.end(), each.name) != list.end();
    };
    if (each.name.starts_with("GLX_"))
      continue; // glXQueryExtensionsString handles it
    if (!each.on)
      std::erase(names, each.name);
    else if (!isIn(there))
      absent.push_back(each.name);
    else if (!isIn(names))
      names.push_back(each.name);
  }
}

} // namespace

Identity makeIdentity(const HostCaps &caps, bool offered, const IdentityRules &rules) {
  Identity identity;
  FilteredExtensions &extensions = identity.extensions;
  extensions.names = implemented(caps, offered, rules, rules.nvAsHost);
  eraseByRules(extensions.names, rules);
  if (rules.switches)
    follow(*rules.switches, implemented(caps, offered, rules, false), extensions.names,
           identity.absent);
  if (rules.cutExtensions())
    sortByYear(extensions.names);
  join(extensions, rules.maxLength);
  if (offered && !rules.cutExtensions() && caps.extensionBytes != 0)
    fitString(extensions, caps, rules);
  if (rules.card)
    nameCard(identity, caps, *rules.card);
  return identity;
}

} // namespace arbiter::state
