#pragma once
#include <cstdint>
#include <span>

#include "fp_compiler/ir/ir.h"
#include "fp_compiler/limits.h"

/// The resources that every report lists, by name.
namespace arbiter {
class JsonWriter;
}

namespace arbiter::fp {

/// One row of the table of resources, in the order of ResourceCounts. A target lists its own.
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

/// The row of a member.
[[nodiscard]] const ResourceRow &resourceRow(std::uint32_t ResourceCounts::*member);

/// An object of all rows, by name: the one form that counts have in JSON.
void writeCounts(JsonWriter &json, const char *key, const ResourceCounts &counts);

} // namespace arbiter::fp
