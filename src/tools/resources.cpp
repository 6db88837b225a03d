#include "tools/resources.h"

#include <iterator>

namespace arbiter::tools {

namespace {

using fp::ResourceCounts;

constexpr ResourceRow kRows[] = {
    {"instructions", "instructions", &ResourceCounts::instructions, true, true},
    {"alu_instructions", "ALU instructions", &ResourceCounts::aluInstructions, true, false},
    {"tex_instructions", "TEX instructions", &ResourceCounts::texInstructions, true, false},
    {"tex_indirections", "TEX indirections", &ResourceCounts::texIndirections, true, false},
    {"temporaries", "temporaries", &ResourceCounts::temporaries, true, true},
    {"parameters", "parameters", &ResourceCounts::parameters, true, true},
    {"attribs", "attribs", &ResourceCounts::attribs, true, true},
    {"address_registers", "address registers", &ResourceCounts::addressRegisters, false, true},
};
static_assert(sizeof(ResourceCounts) == std::size(kRows) * sizeof(std::uint32_t),
              "every resource has its row");

} // namespace

std::span<const ResourceRow> resourceRows() { return kRows; }

const ResourceRow &resourceRow(std::uint32_t ResourceCounts::*member) {
  for (const ResourceRow &row : kRows)
    if (row.member == member)
      return row;
  return kRows[0];
}

} // namespace arbiter::tools
