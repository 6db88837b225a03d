#include "fp_compiler/hw/profile.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "util/suggest.h"

namespace {
/// Thrown where the TOML parser finds itself in a state that it holds to be impossible.
struct ParserBroken {};
constexpr void require(bool possible) {
  if (!possible)
    throw ParserBroken();
}
} // namespace

// toml++ 3.3 asserts, or in a release build assumes, what bad text can break ("[[["). In a library
// that lives in an application that must be an error, whatever the build type.
#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_ASSERT(expr) ::require(bool(expr))
#define TOML_EXCEPTIONS 0
#define TOML_HEADER_ONLY 1
#define TOML_ENABLE_FORMATTERS 0
#define TOML_INT_CHARCONV 1
#define TOML_FLOAT_CHARCONV 1 // else it brings iostreams and locales into every application
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")

namespace arbiter::fp::hw {

namespace {

/// A profile is a page of text; more is a mistake.
constexpr std::size_t kMaxFileBytes = 256u << 10;

/// Collects the first error, with its place.
struct Reader {
  std::string_view path;
  std::string error;

  bool fail(const toml::source_region &where, const std::string &text) {
    if (error.empty())
      error = std::string(path) + ":" + std::to_string(where.begin.line) + ":" +
              std::to_string(where.begin.column) + ": " + text;
    return false;
  }
};

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

std::string unknownName(std::string_view name) {
  const std::vector<std::string_view> names = builtinNames();
  return "no profile \"" + std::string(name.substr(0, 64)) + "\"" + meant(name, names) +
         " (built in: " + joined(names) + "; or the path of a TOML file)";
}

bool isExtensionName(std::string_view name) {
  return name.starts_with("GL_") && name.size() <= 128 &&
         name.find_first_not_of(
             "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_") ==
             std::string_view::npos;
}

bool readValue(Reader &reader, Profile &profile, const RowInfo &info, const toml::node &node,
               std::string source) {
  const std::string name = std::string(info.table) + "." + info.key;
  const toml::value<std::int64_t> *number = node.as_integer();
  if (number == nullptr)
    return reader.fail(node.source(), name + " must be a whole number");
  const std::int64_t value = number->get();
  if (value < 0 || value > std::int64_t(info.most))
    return reader.fail(node.source(), name + " = " + std::to_string(value) +
                                          " is out of range: 0 to " + std::to_string(info.most));
  profile.set(info.row, std::uint32_t(value), std::move(source));
  return true;
}

/// `key = 96`, or `key = { value = 96, source = "where the number is from" }`: the value and the
/// source, which is the place in the file where none is given. Null after an error.
const toml::node *readSourced(Reader &reader, const std::string &name, const toml::node &node,
                              std::string &source) {
  source = std::string(reader.path) + ":" + std::to_string(node.source().begin.line);
  const toml::table *table = node.as_table();
  if (table == nullptr)
    return &node;
  const toml::node *value = table->get("value");
  if (value == nullptr) {
    reader.fail(node.source(), name + " has no value");
    return nullptr;
  }
  for (const auto &[key, child] : *table) {
    if (key.str() == "source" && !child.is_string()) {
      reader.fail(child.source(), "source must be a string");
      return nullptr;
    }
    if (key.str() != "value" && key.str() != "source") {
      reader.fail(key.source(),
                  "unknown key \"" + std::string(key.str()) + "\": a row has value and source");
      return nullptr;
    }
  }
  if (table->get("source"))
    source = *(*table)["source"].value<std::string_view>();
  return value;
}

bool readRow(Reader &reader, Profile &profile, const RowInfo &info, const toml::node &node) {
  std::string source;
  const toml::node *value =
      readSourced(reader, std::string(info.table) + "." + info.key, node, source);
  return value != nullptr && readValue(reader, profile, info, *value, std::move(source));
}

bool readTable(Reader &reader, Profile &profile, std::string_view name, const toml::table &table,
               std::array<bool, kRowCount> &seen) {
  std::vector<std::string_view> keys;
  for (const RowInfo &info : rows())
    if (name == info.table)
      keys.emplace_back(info.key);
  for (const auto &[key, node] : table) {
    const RowInfo *found = nullptr;
    for (const RowInfo &info : rows())
      if (name == info.table && key.str() == info.key)
        found = &info;
    if (found == nullptr)
      return reader.fail(key.source(), "unknown row \"" + std::string(name) + "." +
                                           std::string(key.str()) + "\"" + meant(key.str(), keys));
    if (!readRow(reader, profile, *found, node))
      return false;
    seen[std::size_t(found->row)] = true;
  }
  return true;
}

/// Why a value of [identity] cannot be one; empty if it can. Names of extensions may be parted by
/// spaces, commas and line ends, as glxinfo prints them; `value` then has one space each.
std::string identityFault(std::string_view key, std::string &value) {
  if (key == "extensions") {
    std::string names;
    for (std::size_t at = 0; at < value.size();) {
      const std::size_t end = std::min(value.find_first_of(" ,\t\r\n", at), value.size());
      const std::string_view name = std::string_view(value).substr(at, end - at);
      at = end + 1;
      if (name.empty())
        continue;
      if (!isExtensionName(name))
        return "no name of an extension: \"" + std::string(name.substr(0, 40)) + "\"";
      names += (names.empty() ? "" : " ") + std::string(name);
    }
    value = std::move(names);
    return "";
  }
  for (const char c : value)
    if (c < 0x20 || c > 0x7E)
      return "must be plain ASCII";
  const auto digit = [&](std::size_t at) {
    return at < value.size() && value[at] >= '0' && value[at] <= '9';
  };
  if ((key == "version" || key == "shading_language_version") &&
      !(digit(0) && value[1] == '.' && digit(2)))
    return "must begin with N.M, a version number";
  return "";
}

bool readIdentity(Reader &reader, Profile &profile, const toml::table &table) {
  std::vector<std::string_view> keys;
  for (const IdentityKey &row : identityKeys())
    keys.emplace_back(row.key);
  for (const auto &[key, node] : table) {
    const std::string name = "identity." + std::string(key.str());
    const auto at = std::find(keys.begin(), keys.end(), key.str());
    if (at == keys.end())
      return reader.fail(key.source(), "unknown row \"" + name + "\"" + meant(key.str(), keys));
    Identity::Text text;
    const toml::node *value = readSourced(reader, name, node, text.source);
    if (value == nullptr)
      return false;
    if (key.str() == "year") {
      const std::int64_t year = value->value_or(std::int64_t(0));
      if (!value->is_integer() || year < 1992 || year > 9999)
        return reader.fail(value->source(), name + " must be a year, 1992 to 9999");
      text.value = std::to_string(year);
    } else {
      if (!value->is_string())
        return reader.fail(value->source(), name + " must be a string");
      text.value = value->value_or(std::string());
      if (const std::string fault = identityFault(key.str(), text.value); !fault.empty())
        return reader.fail(value->source(), name + ": " + fault);
    }
    profile.identity.*identityKeys()[std::size_t(at - keys.begin())].member = std::move(text);
  }
  return true;
}

/// The keys outside of tables: name, description, inherits, from_host.
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
    return reader.fail(node.source(), unknownName(name));
  profile = *base;
  return true;
}

/// A file that tells of fragment programs alone is whole: the default profile has the rest.
bool mayBeAbsent(const RowInfo &info) {
  return std::string_view(info.table).starts_with("vertex_") || info.row == Row::ClipPlanes;
}

bool readProfile(Reader &reader, Profile &profile, const toml::table &root) {
  std::array<bool, kRowCount> seen = {};
  if (const toml::node *base = root.get("inherits")) {
    if (!inherit(reader, profile, *base))
      return false;
    seen.fill(true);
  }
  // The file's own name unless it says otherwise: an inherited one would pass for the original.
  profile.name = reader.path;
  for (const auto &[key, node] : root) {
    const std::string_view name = key.str();
    if (name == "inherits")
      continue;
    if (name == "identity") {
      const toml::table *table = node.as_table();
      if (table == nullptr)
        return reader.fail(node.source(), "identity must be a table");
      if (!readIdentity(reader, profile, *table))
        return false;
    } else if (std::find(tables().begin(), tables().end(), name) != tables().end()) {
      const toml::table *table = node.as_table();
      if (table == nullptr)
        return reader.fail(node.source(), std::string(name) + " must be a table");
      if (!readTable(reader, profile, name, *table, seen))
        return false;
    } else if (name == "name" || name == "description" || name == "from_host") {
      if (!readHead(reader, profile, name, node))
        return false;
    } else {
      std::vector<std::string_view> known = {"name", "description", "inherits", "from_host",
                                             "identity"};
      known.insert(known.end(), tables().begin(), tables().end());
      return reader.fail(key.source(),
                         "unknown key \"" + std::string(name) + "\"" + meant(name, known));
    }
  }
  const Profile &standard = *findBuiltin(kDefaultProfile);
  for (const RowInfo &info : rows()) {
    if (seen[std::size_t(info.row)])
      continue;
    if (mayBeAbsent(info))
      profile.set(info.row, standard.value(info.row),
                  "as " + standard.name + ", for the file does not say");
    else
      return reader.fail(root.source(), "no row " + std::string(info.table) + "." + info.key +
                                            ", and nothing inherited (inherits = \"r300\")");
  }
  return true;
}

/// Reads a regular file whole. \returns false with errno set.
bool readFile(const char *path, std::string &text) {
  const int descriptor = ::open(path, O_RDONLY | O_CLOEXEC | O_NOCTTY | O_NONBLOCK);
  if (descriptor < 0)
    return false;
  struct stat status = {};
  bool good = ::fstat(descriptor, &status) == 0;
  if (good && !S_ISREG(status.st_mode)) {
    errno = EINVAL;
    good = false;
  }
  char buffer[4096];
  ssize_t count = 0;
  while (good && (count = ::read(descriptor, buffer, sizeof buffer)) != 0) {
    if (count < 0 && errno == EINTR)
      continue;
    if (count > 0 && text.size() + std::size_t(count) > kMaxFileBytes)
      errno = EFBIG;
    good = count > 0 && text.size() + std::size_t(count) <= kMaxFileBytes;
    if (good)
      text.append(buffer, std::size_t(count));
  }
  const int failure = errno;
  ::close(descriptor);
  errno = failure;
  return good;
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
  } catch (const ParserBroken &) {
    return ProfileError{std::string(path) + ": not TOML: a stray bracket or an odd character where "
                                            "a name should be"};
  }
}

Result<Profile, ProfileError> loadProfile(std::string_view nameOrPath) {
  try {
    if (const Profile *builtin = findBuiltin(nameOrPath))
      return *builtin;
    if (nameOrPath.find('/') == std::string_view::npos && !nameOrPath.ends_with(".toml"))
      return ProfileError{unknownName(nameOrPath)};
    const std::string path(nameOrPath);
    std::string text;
    if (!readFile(path.c_str(), text))
      return ProfileError{path + ": " + std::strerror(errno)};
    return parseProfile(text, path);
  } catch (...) {
    return ProfileError{"out of memory while a profile was read"};
  }
}

} // namespace arbiter::fp::hw
