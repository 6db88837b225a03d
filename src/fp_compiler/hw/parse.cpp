#include <algorithm>

#include "fp_compiler/hw/read_toml.h"

namespace arbiter::fp::hw {

namespace {

constexpr std::string_view kIdentityTable = "identity";
/// The source of a value that the file does not give.
constexpr std::string_view kUnsaid = "the file does not say";

/// Reads the keys outside of tables: name, description, inherits, from_host.
bool readHead(Reader &reader, Profile &profile, std::string_view key, const toml::node &node) {
  if (key == "from_host") {
    const toml::value<bool> *flag = node.as_boolean();
    if (flag == nullptr)
      return reader.fail(node.source(), "from_host must be true or false");
    profile.fromHost = flag->get();
    return true;
  }
  const toml::value<std::string> *text = node.as_string();
  if (text == nullptr)
    return reader.fail(node.source(), std::string(key) + " must be a string");
  if (key == "name")
    profile.name = text->get();
  else if (key == "description")
    profile.description = text->get();
  return true;
}

bool inherit(Reader &reader, Profile &profile, const toml::node &node) {
  const std::string_view name = node.value_or(std::string_view());
  const Profile *base = findBuiltin(name);
  if (base == nullptr)
    return reader.fail(node.source(), unknownProfile(name));
  profile = *base;
  return true;
}

/// Reads a table such as [api] or [identity]. `identity = false` removes an inherited identity.
bool readNamedTable(Reader &reader, Profile &profile, std::string_view name, const toml::node &node,
                    std::array<bool, kRowCount> &seen) {
  const bool identity = name == kIdentityTable;
  if (identity && node.value_or(true) == false) {
    profile.identity = {};
    return true;
  }
  const toml::table *table = node.as_table();
  if (table == nullptr)
    return reader.fail(node.source(), std::string(name) + " must be a table");
  return identity ? readIdentity(reader, profile, *table)
                  : readTable(reader, profile, name, *table, seen);
}

/// Fills what a file that inherits nothing may leave out. Without [model] the card has documented
/// limits only. Rows of vertex programs come from the default profile.
bool fillAbsent(Reader &reader, Profile &profile, const toml::table &root,
                const std::array<bool, kRowCount> &seen) {
  const Profile &standard = *findBuiltin(kDefaultProfile);
  for (const RowInfo &info : rows()) {
    const std::string_view table = info.table;
    if (seen[std::size_t(info.row)])
      continue;
    if (table == kModelTable)
      profile.set(info.row, 0, std::string(kUnsaid));
    else if (table.starts_with("vertex_") || info.row == Row::ClipPlanes)
      profile.set(info.row, standard.value(info.row),
                  "as " + standard.name + ", for " + std::string(kUnsaid));
    else
      return reader.fail(root.source(), "no row " + std::string(info.table) + "." + info.key +
                                            ", and nothing inherited (inherits = \"r300\")");
  }
  return true;
}

bool readProfile(Reader &reader, Profile &profile, const toml::table &root) {
  std::array<bool, kRowCount> seen = {};
  for (const ChoiceInfo &info : choices())
    profile.set(info.choice, 0, std::string(kUnsaid));
  if (const toml::node *base = root.get("inherits")) {
    if (!inherit(reader, profile, *base))
      return false;
    seen.fill(true);
  }
  std::vector<std::string_view> known = {"name", "description", "inherits", "from_host",
                                         kIdentityTable};
  const std::size_t heads = known.size() - 1;
  known.insert(known.end(), tables().begin(), tables().end());
  // The file's path is the name unless the file gives one: an inherited name would pass for the
  // original.
  profile.name = reader.path;
  for (const auto &[key, node] : root) {
    const std::string_view name = key.str();
    const auto at = std::size_t(std::find(known.begin(), known.end(), name) - known.begin());
    if (at == known.size())
      return reader.fail(key.source(),
                         "unknown key \"" + std::string(name) + "\"" + meant(name, known));
    if (name == "inherits")
      continue;
    if (!(at < heads ? readHead(reader, profile, name, node)
                     : readNamedTable(reader, profile, name, node, seen)))
      return false;
  }
  profile.nameCard();
  return fillAbsent(reader, profile, root, seen);
}

} // namespace

Result<Profile, ProfileError> parseProfile(std::string_view text, std::string_view path) {
  Reader reader{path, {}};
  try {
    const toml::parse_result parsed = toml::parse(text, path);
    if (!parsed) {
      reader.fail(parsed.error().source(), std::string(parsed.error().description()));
      return ProfileError{reader.error};
    }
    Profile profile;
    if (!readProfile(reader, profile, parsed.table()))
      return ProfileError{reader.error};
    return profile;
  } catch (const TomlParserBroken &) {
    return ProfileError{std::string(path) + ": not TOML: a stray bracket or an odd character where "
                                            "a name should be"};
  }
}

} // namespace arbiter::fp::hw
