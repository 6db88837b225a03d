#include "fp_compiler/resources.h"

#include <iterator>

#include "util/json.h"

namespace arbiter::fp {

namespace {

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

void writeCounts(JsonWriter &json, const char *key, const ResourceCounts &counts) {
  json.key(key).beginObject();
  for (const ResourceRow &row : kRows)
    json.key(row.name).value(counts.*row.member);
  json.endObject();
}

} // namespace arbiter::fp
