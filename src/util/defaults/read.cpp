#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>

#include "util/defaults/entry.h"
#include "util/file.h"
#include "util/suggest.h"
#include "util/toml.h"

namespace arbiter::defaults {

namespace {

constexpr std::string_view kProgramTable = "program";
constexpr std::string_view kEntryKeys[] = {"title", "match", "set", "source", "note"};
constexpr std::string_view kMatchKeys[] = {"name", "path", "windows", "xxh128"};
constexpr std::string_view kUnset = "default";
constexpr std::size_t kHashDigits = 32;
constexpr std::size_t kMaxErrors = 100;

struct Reader {
  const std::string &path;
  File &file;

  bool fail(const toml::source_region &where, const std::string &text) {
    if (file.errors.size() < kMaxErrors)
      file.errors.push_back(path + ":" + std::to_string(where.begin.line) + ":" +
                            std::to_string(where.begin.column) + ": " + text);
    return false;
  }

  bool unknown(const toml::key &key, const std::string &where,
               std::span<const std::string_view> known) {
    const std::string_view near = nearest(key.str(), known);
    return fail(key.source(),
                "unknown key \"" + std::string(key.str()) + "\" in " + where +
                    (near.empty() ? "" : "; did you mean " + std::string(near) + "?"));
  }
};

bool isIn(std::string_view name, std::span<const std::string_view> known) {
  return std::find(known.begin(), known.end(), name) != known.end();
}

/// Reads a string, or an array of strings. None may be empty.
bool readStrings(Reader &reader, const std::string &key, const toml::node &node,
                 std::vector<std::string> &strings) {
  const auto add = [&](const toml::node &each) {
    const toml::value<std::string> *const text = each.as_string();
    if (text == nullptr || text->get().empty())
      return reader.fail(each.source(), key + " must be a string, or a list of strings");
    strings.push_back(text->get());
    return true;
  };
  const toml::array *const list = node.as_array();
  if (list == nullptr)
    return add(node);
  if (list->empty())
    return reader.fail(node.source(), key + " is an empty list");
  return std::all_of(list->begin(), list->end(), add);
}

bool readHashes(Reader &reader, const toml::node &node, std::vector<std::string> &hashes) {
  if (!readStrings(reader, "xxh128", node, hashes))
    return false;
  for (std::string &hash : hashes) {
    const bool digits = std::all_of(hash.begin(), hash.end(), [](char c) {
      return std::isxdigit(static_cast<unsigned char>(c)) != 0;
    });
    if (hash.size() != kHashDigits || !digits)
      return reader.fail(node.source(),
                         "xxh128 must have 32 hexadecimal digits (xxh128sum FILE, or "
                         "arbiter defaults -- COMMAND, prints them)");
    for (char &c : hash)
      c = char(std::tolower(static_cast<unsigned char>(c)));
  }
  return true;
}

bool noFolders(Reader &reader, const std::string &key, const toml::node &node,
               const std::vector<std::string> &names) {
  for (const std::string &name : names)
    if (name.find_first_of("/\\") != std::string::npos)
      return reader.fail(node.source(), key + " is a file's name without its folder, not \"" +
                                            name + "\" (path takes folders)");
  return true;
}

bool readMatch(Reader &reader, const toml::node &node, Match &match) {
  const toml::table *const table = node.as_table();
  if (table == nullptr || table->empty())
    return reader.fail(node.source(), "match must be a table with name, path, windows or xxh128");
  for (const auto &[key, child] : *table) {
    const std::string_view name = key.str();
    bool good = true;
    if (name == "name")
      good = readStrings(reader, "name", child, match.names) &&
             noFolders(reader, "name", child, match.names);
    else if (name == "path")
      good = readStrings(reader, "path", child, match.paths);
    else if (name == "windows")
      good = readStrings(reader, "windows", child, match.windows) &&
             noFolders(reader, "windows", child, match.windows);
    else if (name == "xxh128")
      good = readHashes(reader, child, match.hashes);
    else // without this condition the entry would apply to more programs than intended
      good = reader.unknown(key, "match", kMatchKeys);
    if (!good)
      return false;
  }
  return true;
}

/// Returns the layer's warning about the variable's value; empty if it accepts it.
std::string whyNotFollowed(const Value &value) {
  std::vector<std::string> warnings;
  const std::string name = info(value.variable).name;
  static_cast<void>(parseSettings(
      [&](const char *asked) { return name == asked ? value.text.c_str() : nullptr; }, warnings));
  if (warnings.empty())
    return {};
  const std::string &warning = warnings.front();
  const std::size_t begin = name.size() + 2; // "NAME: "
  return warning.substr(begin, warning.rfind("; ignored") - begin);
}

bool readValue(Reader &reader, const Key &key, const toml::node &node, Value &value) {
  value.variable = key.variable;
  value.line = node.source().begin.line;
  if (const toml::value<std::string> *const text = node.as_string())
    value.text = text->get();
  else if (const toml::value<std::int64_t> *const number = node.as_integer())
    value.text = std::to_string(number->get());
  else
    return reader.fail(node.source(), key.name + " must be a string or a whole number");
  if (value.text.empty())
    return reader.fail(node.source(), key.name + " is empty; \"default\" undoes earlier entries");
  if (value.text == kUnset) {
    value.text.clear();
    return true;
  }
  if (const std::string fault = whyNotFollowed(value); !fault.empty())
    return reader.fail(node.source(), key.name + ": " + fault);
  // A value with a slash or the ending .toml is a path, as in the variable
  // (fp_compiler/hw/profile.h).
  const bool isPath = value.text.find('/') != std::string::npos || value.text.ends_with(".toml");
  if (key.variable == Env::Profile && isPath && value.text.front() != '/') {
    const std::size_t slash = reader.path.rfind('/');
    value.text =
        (slash == std::string::npos ? "./" : reader.path.substr(0, slash + 1)) + value.text;
  }
  return true;
}

void readSet(Reader &reader, const toml::node &node, Entry &entry) {
  const toml::table *const table = node.as_table();
  if (table == nullptr) {
    reader.fail(node.source(), "set must be a table of settings");
    return;
  }
  std::vector<std::string_view> known;
  for (const Key &key : keys())
    known.emplace_back(key.name);
  for (const auto &[name, child] : *table) {
    const auto at = std::size_t(std::find(known.begin(), known.end(), name.str()) - known.begin());
    Value value;
    if (at == known.size())
      reader.unknown(name, "set", known);
    else if (readValue(reader, keys()[at], child, value))
      entry.values.push_back(std::move(value));
  }
}

bool readText(Reader &reader, const std::string &key, const toml::table &table, std::string &text) {
  const toml::node *const node = table.get(key);
  if (node == nullptr)
    return true;
  const toml::value<std::string> *const value = node->as_string();
  if (value == nullptr)
    return reader.fail(node->source(), key + " must be a string");
  text = value->get();
  return true;
}

void readEntry(Reader &reader, const toml::node &node) {
  const toml::table *const table = node.as_table();
  if (table == nullptr) {
    reader.fail(node.source(), "program must be a list of tables: [[program]]");
    return;
  }
  Entry entry;
  entry.file = reader.path;
  entry.line = node.source().begin.line;
  for (const auto &[key, child] : *table)
    if (!isIn(key.str(), kEntryKeys))
      reader.unknown(key, "[[program]]", kEntryKeys);
  readText(reader, "note", *table, entry.note);
  if (const toml::node *const source = table->get("source"))
    static_cast<void>(readStrings(reader, "source", *source, entry.sources));
  if (!readText(reader, "title", *table, entry.title))
    return;
  if (entry.title.empty()) {
    reader.fail(node.source(), "a [[program]] without a title");
    return;
  }
  const toml::node *const match = table->get("match");
  if (match == nullptr) {
    reader.fail(node.source(), "\"" + entry.title + "\" has no match: which programs is it for?");
    return;
  }
  if (!readMatch(reader, *match, entry.match))
    return;
  if (const toml::node *const set = table->get("set"))
    readSet(reader, *set, entry);
  else
    reader.fail(node.source(), "\"" + entry.title + "\" has no set: nothing to do");
  if (!entry.values.empty())
    reader.file.entries.push_back(std::move(entry));
}

void readRoot(Reader &reader, const toml::table &root) {
  for (const auto &[key, node] : root) {
    if (key.str() != kProgramTable) {
      reader.unknown(key, "the file", std::span(&kProgramTable, 1));
      continue;
    }
    const toml::array *const list = node.as_array();
    if (list == nullptr)
      reader.fail(node.source(), "program must be a list of tables: [[program]]");
    else
      for (const toml::node &each : *list)
        readEntry(reader, each);
  }
}

/// True if the parser breaks within the text's first `bytes` bytes.
bool breaksWithin(std::string_view text, std::size_t bytes) {
  try {
    static_cast<void>(toml::parse(text.substr(0, bytes)));
    return false;
  } catch (const TomlParserBroken &) {
    return true;
  }
}

/// Finds the line at which the parser breaks, as the parser does not report it.
std::uint32_t brokenLine(std::string_view text) {
  std::vector<std::size_t> ends;
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string_view::npos;)
    ends.push_back(++at);
  ends.push_back(text.size());
  const auto first = std::partition_point(
      ends.begin(), ends.end() - 1, [&](std::size_t end) { return !breaksWithin(text, end); });
  return std::uint32_t(first - ends.begin()) + 1;
}

} // namespace

File parseFile(std::string_view text, const std::string &path) {
  File file;
  Reader reader{path, file};
  try {
    const toml::parse_result parsed = toml::parse(text, path);
    if (parsed)
      readRoot(reader, parsed.table());
    else
      reader.fail(parsed.error().source(), std::string(parsed.error().description()));
  } catch (const TomlParserBroken &) {
    file = {};
    file.errors.push_back(path + ":" + std::to_string(brokenLine(text)) +
                          ": not TOML: a stray bracket or an odd character where a name should be");
  }
  return file;
}

File readFile(const std::string &path) {
  std::string text;
  if (!arbiter::readFile(path.c_str(), kMaxFileBytes, text)) {
    const std::string why = errno == EFBIG    ? "longer than 1 MiB"
                            : errno == EINVAL ? "not a regular file"
                                              : std::strerror(errno);
    return {{}, {path + ": " + why}};
  }
  return parseFile(text, path);
}

} // namespace arbiter::defaults
