#pragma once
#include <span>

#include "fp_compiler/ir/ir.h"
#include "fp_compiler/limits.h"

/// The resources that every report lists, by name.
namespace arbiter::tools {

/// One row of the table of resources, in the order of fp::ResourceCounts. A target lists its own.
struct ResourceRow {
  const char *name; ///< "alu_instructions", as in a profile
  const char *title;
  std::uint32_t fp::ResourceCounts::*member;
  bool fragment;
  bool vertex;

  [[nodiscard]] bool of(fp::ir::Language language) const {
    return language == fp::ir::Language::ArbVertex ? vertex : fragment;
  }
};

[[nodiscard]] std::span<const ResourceRow> resourceRows();

/// The row of a member.
[[nodiscard]] const ResourceRow &resourceRow(std::uint32_t fp::ResourceCounts::*member);

} // namespace arbiter::tools
