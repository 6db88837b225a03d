#include "fp_compiler/hw/profile.h"

#include <algorithm>
#include <mutex>
#include <set>
#include <string>
#include <utility>

#include "fp_compiler/hw/builtin.h"
#include "fp_compiler/hw/names.h"

namespace arbiter::fp::hw {

namespace {

constexpr RowInfo kRows[] = {
#define PROFILE_ROW(Enumerator, table, key, member, glName, least, most)                           \
  {Row::Enumerator, #table, #key, glName, least, most},
#include "fp_compiler/hw/rows.def"
#undef PROFILE_ROW
};

std::uint32_t &member(Profile &profile, Row row) {
  switch (row) {
#define PROFILE_ROW(Enumerator, table, key, member, glName, least, most)                           \
  case Row::Enumerator:                                                                            \
    return profile.member;
#include "fp_compiler/hw/rows.def"
#undef PROFILE_ROW
  }
  return profile.fragment.api.instructions; // every enumerator has its case
}

/// Splits "a|b|c" at the bars.
std::vector<std::string_view> split(std::string_view names) {
  std::vector<std::string_view> parts;
  for (std::size_t bar; (bar = names.find('|')) != names.npos; names.remove_prefix(bar + 1))
    parts.push_back(names.substr(0, bar));
  parts.push_back(names);
  return parts;
}

/// Limits that apply to both targets.
constexpr std::uint32_t Limits::*kShared[] = {&Limits::textureCoords,
                                              &Limits::textureImageUnits,
                                              &Limits::textureUnits,
                                              &Limits::programMatrices,
                                              &Limits::programMatrixStackDepth,
                                              &Limits::lights,
                                              &Limits::paletteMatrices,
                                              &Limits::vertexUnits,
                                              &Limits::clipPlanes};

constexpr IdentityKey kIdentityKeys[] = {
    {"vendor", &Identity::vendor},         {"renderer", &Identity::renderer},
    {"version", &Identity::version},       {"shading_language_version", &Identity::shadingLanguage},
    {"extensions", &Identity::extensions}, {"year", &Identity::year},
};
static_assert(std::size(kIdentityKeys) == kIdentityKeyCount);

std::vector<Profile> makeBuiltins() {
  std::vector<Profile> profiles;
  for (const BuiltinProfile &from : builtinTable()) {
    Profile &profile = profiles.emplace_back();
    profile.name = from.name;
    profile.description = from.description;
    profile.fromHost = from.fromHost;
    profile.nameCard();
    for (const RowInfo &info : kRows) {
      const BuiltinRow &row = from.rows[std::size_t(info.row)];
      profile.set(info.row, row.value, row.source);
    }
    for (int i = 0; i < kChoiceCount; ++i)
      profile.set(Choice(i), from.choices[i].value, from.choices[i].source);
    for (int i = 0; i < kIdentityKeyCount; ++i)
      profile.identity.*kIdentityKeys[i].member = {from.identity[i].value, from.identity[i].source};
  }
  return profiles;
}

const std::vector<Profile> &builtins() {
  // Never destroyed: an application's last GL calls may come from destructors.
  static const std::vector<Profile> &profiles = *new std::vector<Profile>(makeBuiltins());
  return profiles;
}

} // namespace

std::span<const RowInfo> rows() { return kRows; }

std::span<const std::string_view> tables() {
  static constexpr std::string_view kTables[] = {
      "api", "native", "state", kModelTable, "vertex_api", "vertex_native", "vertex_state"};
  return kTables;
}

std::span<const ChoiceInfo> choices() {
  // Never destroyed: an application's last GL calls may come from destructors.
  static const std::vector<ChoiceInfo> &infos = *new std::vector<ChoiceInfo>{
#define PROFILE_CHOICE(Enumerator, key, member, type, names, doc)                                  \
  {Choice::Enumerator, #key, split(names)},
#include "fp_compiler/hw/choices.def"
#undef PROFILE_CHOICE
  };
  return infos;
}

std::span<const IdentityKey> identityKeys() { return kIdentityKeys; }

namespace {

/// Returns a copy of `name` that is never freed, the same for equal names.
const char *kept(std::string name) {
  static std::mutex &mutex = *new std::mutex;
  static std::set<std::string> &names = *new std::set<std::string>;
  const std::lock_guard lock(mutex);
  return names.insert(std::move(name)).first->c_str();
}

} // namespace

void Profile::nameCard() {
  const std::size_t chip = description.find(" (");
  const bool named = chip != std::string::npos && chip < description.find(':');
  fragment.card = kept(named ? description.substr(0, chip) + " (" + name + ")" : name);
  vertex.card = fragment.card;
}

std::uint32_t Profile::value(Row row) const {
  return member(const_cast<Profile &>(*this), row); // read only
}

void Profile::set(Row row, std::uint32_t value, std::string source) {
  member(*this, row) = value;
  for (std::uint32_t Limits::*const shared : kShared)
    vertex.*shared = fragment.*shared;
  // A vertex program may sample four textures at once, with any unit numbers (NV_vertex_program3).
  // Four units beyond those of fragment programs let it have its own.
  if (vertex.nvOptions >= 2)
    vertex.textureImageUnits = std::min(vertex.textureImageUnits + 4, 32u);
  // Every chip with NV_vertex_program2 also has NV_vertex_program.
  if (vertex.nvOptions >= 1)
    vertex.nvVertexProgram = 1;
  sources[std::size_t(row)] = std::move(source);
}

std::uint32_t Profile::value(Choice choice) const {
  switch (choice) {
#define PROFILE_CHOICE(Enumerator, key, member, type, names, doc)                                  \
  case Choice::Enumerator:                                                                         \
    return std::uint32_t(member);
#include "fp_compiler/hw/choices.def"
#undef PROFILE_CHOICE
  }
  return 0; // every enumerator has its case
}

void Profile::set(Choice choice, std::uint32_t value, std::string source) {
  switch (choice) {
// NOLINTBEGIN(bugprone-macro-parentheses): a member's name cannot stand in parentheses.
#define PROFILE_CHOICE(Enumerator, key, member, type, names, doc)                                  \
  case Choice::Enumerator:                                                                         \
    member = type(value);                                                                          \
    break;
#include "fp_compiler/hw/choices.def"
#undef PROFILE_CHOICE
    // NOLINTEND(bugprone-macro-parentheses)
  }
  choiceSources[std::size_t(choice)] = std::move(source);
}

std::vector<std::string_view> builtinNames() {
  std::vector<std::string_view> names;
  for (const BuiltinProfile &profile : builtinTable())
    names.emplace_back(profile.name);
  return names;
}

const Profile *findBuiltin(std::string_view name) {
  const std::string_view meant = builtinMeant(name);
  for (const Profile &profile : builtins())
    if (profile.name == meant)
      return &profile;
  return nullptr;
}

} // namespace arbiter::fp::hw
