#include <GL/arbiter.h>
#include <cstdio>

#include "apps/tools/commands.h"
#include "apps/tools/input.h"
#include "fp_compiler/hw/names.h"
#include "fp_compiler/hw/profile.h"
#include "util/json.h"

namespace arbiter::tools {

namespace {

void list() {
  for (const std::string_view name : fp::hw::builtinNames()) {
    const fp::hw::Profile *profile = fp::hw::findBuiltin(name);
    std::printf("%-20s%s%s\n", profile->name.c_str(), profile->description.c_str(),
                name == fp::hw::kDefaultProfile ? " (default)" : "");
    if (const auto aliases = fp::hw::aliasesOf(name); !aliases.empty())
      std::printf("%-20salso %s\n", "", fp::hw::joined(aliases).c_str());
  }
}

void writeHead(JsonWriter &json, const fp::hw::Profile &profile) {
  json.key("name").value(profile.name).key("description").value(profile.description);
  json.key("from_host").value(profile.fromHost);
}

void listAsJson() {
  JsonWriter json;
  json.beginObject().key("schema").value(ARBITER_PROFILES_SCHEMA);
  json.key("default").value(fp::hw::kDefaultProfile).key("profiles").beginArray();
  for (const std::string_view name : fp::hw::builtinNames()) {
    writeHead(json.beginObject(), *fp::hw::findBuiltin(name));
    json.key("aliases").beginArray();
    for (const std::string_view alias : fp::hw::aliasesOf(name))
      json.value(alias);
    json.endArray().endObject();
  }
  std::fputs(json.endArray().endObject().take().c_str(), stdout);
}

/// Prints one object for each table of the profile, with value and source of each key.
void printAsJson(const fp::hw::Profile &profile) {
  JsonWriter json;
  writeHead(json.beginObject().key("schema").value(ARBITER_PROFILES_SCHEMA), profile);
  const auto writeSource = [&](const std::string &source) {
    json.key("source").value(source).endObject();
  };
  for (const std::string_view table : fp::hw::tables()) {
    json.key(table).beginObject();
    for (const fp::hw::RowInfo &row : fp::hw::rows())
      if (table == row.table) {
        json.key(row.key).beginObject().key("value").value(profile.value(row.row));
        writeSource(profile.sources[std::size_t(row.row)]);
      }
    if (table == fp::hw::kModelTable)
      for (const fp::hw::ChoiceInfo &choice : fp::hw::choices()) {
        json.key(choice.key).beginObject().key("value");
        json.value(choice.names[profile.value(choice.choice)]);
        writeSource(profile.choiceSources[std::size_t(choice.choice)]);
      }
    json.endObject();
  }
  json.key("identity").beginObject();
  for (const fp::hw::IdentityKey &row : fp::hw::identityKeys())
    if (const auto &text = profile.identity.*row.member; !text.value.empty()) {
      json.key(row.key).beginObject().key("value").value(text.value);
      writeSource(text.source);
    }
  std::fputs(json.endObject().endObject().take().c_str(), stdout);
}

std::string inQuotes(std::string_view text) {
  std::string escaped = "\"";
  for (const char c : text)
    escaped += c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
  return escaped + "\"";
}

void printKey(const char *key, const std::string &value, const std::string &source) {
  std::printf("%s = { value = %s, source = %s }\n", key, value.c_str(), inQuotes(source).c_str());
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
    printKey(choice.key, inQuotes(choice.names[profile.value(choice.choice)]),
             profile.choiceSources[std::size_t(choice.choice)]);
}

/// Prints the profile as a TOML file that `arbiter check --profile` reads, as a start for a new
/// one.
void print(const fp::hw::Profile &profile) {
  std::printf("name = %s\ndescription = %s\n", inQuotes(profile.name).c_str(),
              inQuotes(profile.description).c_str());
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
      printKey(row.key, number ? text.value : inQuotes(text.value), text.source);
  }
}

} // namespace

int profiles(const ProfilesArguments &arguments) {
  if (arguments.name.empty()) {
    arguments.json ? listAsJson() : list();
    return kExitOk;
  }
  const auto profile = fp::hw::loadProfile(arguments.name);
  if (!profile) {
    complain(profile.error().message);
    return kExitUsage;
  }
  arguments.json ? printAsJson(profile.value()) : print(profile.value());
  return kExitOk;
}

} // namespace arbiter::tools
