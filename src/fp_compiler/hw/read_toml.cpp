#include "fp_compiler/hw/read_toml.h"

namespace arbiter::fp::hw {

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

} // namespace arbiter::fp::hw
