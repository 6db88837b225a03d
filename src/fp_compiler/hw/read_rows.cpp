#include <algorithm>

#include "fp_compiler/hw/read_toml.h"

namespace arbiter::fp::hw {

namespace {

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

bool readRow(Reader &reader, Profile &profile, const RowInfo &info, const toml::node &node) {
  std::string source;
  const toml::node *value =
      readSourced(reader, std::string(info.table) + "." + info.key, node, source);
  return value != nullptr && readValue(reader, profile, info, *value, std::move(source));
}

bool readChoice(Reader &reader, Profile &profile, const ChoiceInfo &info, const toml::node &node) {
  const std::string name = std::string(kModelTable) + "." + info.key;
  std::string source;
  const toml::node *value = readSourced(reader, name, node, source);
  if (value == nullptr)
    return false;
  if (!value->is_string())
    return reader.fail(value->source(), name + " must be a string");
  const std::string_view text = value->value_or(std::string_view());
  const auto at = std::find(info.names.begin(), info.names.end(), text);
  if (at == info.names.end())
    return reader.fail(value->source(), name + " cannot be \"" + std::string(text.substr(0, 64)) +
                                            "\"" + meant(text, info.names) + " (one of " +
                                            joined(info.names) + ")");
  profile.set(info.choice, std::uint32_t(at - info.names.begin()), std::move(source));
  return true;
}

const RowInfo *rowOf(std::string_view table, std::string_view key) {
  for (const RowInfo &info : rows())
    if (table == info.table && key == info.key)
      return &info;
  return nullptr;
}

const ChoiceInfo *choiceOf(std::string_view table, std::string_view key) {
  for (const ChoiceInfo &info : choices())
    if (table == kModelTable && key == info.key)
      return &info;
  return nullptr;
}

std::vector<std::string_view> keysOf(std::string_view table) {
  std::vector<std::string_view> keys;
  for (const RowInfo &info : rows())
    if (table == info.table)
      keys.emplace_back(info.key);
  if (table == kModelTable)
    for (const ChoiceInfo &info : choices())
      keys.emplace_back(info.key);
  return keys;
}

} // namespace

bool readTable(Reader &reader, Profile &profile, std::string_view name, const toml::table &table,
               std::array<bool, kRowCount> &seen) {
  for (const auto &[key, node] : table) {
    if (const RowInfo *row = rowOf(name, key.str())) {
      if (!readRow(reader, profile, *row, node))
        return false;
      seen[std::size_t(row->row)] = true;
    } else if (const ChoiceInfo *choice = choiceOf(name, key.str())) {
      if (!readChoice(reader, profile, *choice, node))
        return false;
    } else {
      return reader.fail(key.source(), "unknown row \"" + std::string(name) + "." +
                                           std::string(key.str()) + "\"" +
                                           meant(key.str(), keysOf(name)));
    }
  }
  return true;
}

} // namespace arbiter::fp::hw
