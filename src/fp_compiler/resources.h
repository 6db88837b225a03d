#pragma once
#include <cstdint>
#include <span>

#include "fp_compiler/ir/ir.h"
#include "fp_compiler/limits.h"

/// Names of the resources that every report lists.
namespace arbiter {
class JsonWriter;
}

namespace arbiter::fp {

/// A row of the table of resources, in the order of ResourceCounts. A target lists those that it
/// has.
struct ResourceRow {
  const char *name; ///< "alu_instructions", as in a profile
  const char *title;
  std::uint32_t ResourceCounts::*member;
  bool fragment;
  bool vertex;

  [[nodiscard]] bool of(ir::Language language) const {
    return language == ir::Language::ArbVertex ? vertex : fragment;
  }
};

[[nodiscard]] std::span<const ResourceRow> resourceRows();

/// Returns the row of a member.
[[nodiscard]] const ResourceRow &resourceRow(std::uint32_t ResourceCounts::*member);

/// Writes the counts as a JSON object with a member for each row.
void writeCounts(JsonWriter &json, const char *key, const ResourceCounts &counts);

} // namespace arbiter::fp
