#include "fp_compiler/ir/ir.h"

#include <algorithm>

namespace arbiter::fp::ir {

namespace {
constexpr OpInfo kTable[] = {
#define FP_OP(Enumerator, mnemonic, shapes, traits, section, doc)                                  \
  {#Enumerator, mnemonic, shapes, std::uint32_t(traits), section, doc},
#define FP_NV_OP(Enumerator, mnemonic, shapes, traits, section, doc)                               \
  {#Enumerator, mnemonic, shapes, std::uint32_t(traits), section, doc},
#define FP_NV_WORD(Enumerator, mnemonic, shapes, traits, section, doc)                             \
  {#Enumerator, mnemonic, shapes, std::uint32_t(traits), section, doc},
#include "fp_compiler/ir/ops.def"
};
static_assert(std::size(kTable) == kOpcodeRowCount);
} // namespace

const OpInfo &info(Opcode op) { return kTable[std::size_t(op)]; }

bool hasLoops(const Program &program) {
  return program.options.nv != NvOption::None &&
         std::any_of(program.code.begin(), program.code.end(),
                     [](const Instruction &instruction) { return info(instruction.op).has(Flow); });
}

} // namespace arbiter::fp::ir
