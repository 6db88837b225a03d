#include <cstdio>

#include "fp_compiler/hw/profile.h"
#include "tools/commands.h"
#include "tools/input.h"

namespace arbiter::tools {

namespace {

void list() {
  for (const std::string_view name : fp::hw::builtinNames()) {
    const fp::hw::Profile *profile = fp::hw::findBuiltin(name);
    std::printf("%-20s%s%s\n", profile->name.c_str(), profile->description.c_str(),
                name == fp::hw::kDefaultProfile ? " (default)" : "");
  }
}

std::string quoted(std::string_view text) {
  std::string escaped = "\"";
  for (const char c : text)
    escaped += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return escaped + "\"";
}

void printKey(const char *key, const std::string &value, const std::string &source) {
  std::printf("%s = { value = %s, source = %s }\n", key, value.c_str(), quoted(source).c_str());
}

void printTable(const fp::hw::Profile &profile, std::string_view table) {
  std::printf("\n[%.*s]\n", int(table.size()), table.data());
  for (const fp::hw::RowInfo &row : fp::hw::rows())
    if (table == row.table)
      printKey(row.key, std::to_string(profile.value(row.row)),
               profile.sources[std::size_t(row.row)]);
  if (table != fp::hw::kModelTable)
    return;
  for (const fp::hw::ChoiceInfo &choice : fp::hw::choices())
    printKey(choice.key, quoted(choice.names[profile.value(choice.choice)]),
             profile.choiceSources[std::size_t(choice.choice)]);
}

/// As a TOML file that `arbiter check --profile` reads, so that it can be the start of a new one.
void print(const fp::hw::Profile &profile) {
  std::printf("name = %s\ndescription = %s\n", quoted(profile.name).c_str(),
              quoted(profile.description).c_str());
  if (profile.fromHost)
    std::printf("from_host = true\n");
  for (const std::string_view table : fp::hw::tables())
    printTable(profile, table);
  if (!profile.identity.empty())
    std::printf("\n[identity]\n");
  for (const fp::hw::IdentityKey &row : fp::hw::identityKeys()) {
    const fp::hw::Identity::Text &text = profile.identity.*row.member;
    const bool number = std::string_view(row.key) == "year";
    if (!text.value.empty())
      printKey(row.key, number ? text.value : quoted(text.value), text.source);
  }
}

} // namespace

int profiles(const ProfilesArguments &arguments) {
  if (arguments.name.empty()) {
    list();
    return kExitOk;
  }
  const auto profile = fp::hw::loadProfile(arguments.name);
  if (!profile) {
    complain(profile.error().message);
    return kExitUsage;
  }
  print(profile.value());
  return kExitOk;
}

} // namespace arbiter::tools
