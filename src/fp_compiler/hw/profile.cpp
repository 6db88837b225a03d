#include "fp_compiler/hw/profile.h"

#include "fp_compiler/hw/builtin.h"

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

/// Limits that both targets go by.
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
    for (const RowInfo &info : kRows) {
      const BuiltinRow &row = from.rows[std::size_t(info.row)];
      profile.set(info.row, row.value, row.source);
    }
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
  static constexpr std::string_view kTables[] = {"api",        "native",        "state",
                                                 "vertex_api", "vertex_native", "vertex_state"};
  return kTables;
}
std::span<const IdentityKey> identityKeys() { return kIdentityKeys; }

std::uint32_t Profile::value(Row row) const {
  return member(const_cast<Profile &>(*this), row); // read only
}

void Profile::set(Row row, std::uint32_t value, std::string source) {
  member(*this, row) = value;
  for (std::uint32_t Limits::*const shared : kShared)
    vertex.*shared = fragment.*shared;
  sources[std::size_t(row)] = std::move(source);
}

std::vector<std::string_view> builtinNames() {
  std::vector<std::string_view> names;
  for (const BuiltinProfile &profile : builtinTable())
    names.emplace_back(profile.name);
  return names;
}

const Profile *findBuiltin(std::string_view name) {
  for (const Profile &profile : builtins())
    if (profile.name == name)
      return &profile;
  return nullptr;
}

} // namespace arbiter::fp::hw
