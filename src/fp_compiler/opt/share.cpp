#include <algorithm>
#include <unordered_map>

#include "fp_compiler/ir/reads.h"
#include "fp_compiler/opt/opt.h"
#include "fp_compiler/opt/values.h"

namespace arbiter::fp::opt {

namespace {
/// What an operand component reads: register, array row, version of the temporary or address.
using Read = std::array<std::uint32_t, 3>;

/// Everything that a result depends on. Instructions with equal keys compute the same value.
struct Key {
  std::uint32_t head = 0; ///< opcode, _SAT, mask, unit, target
  std::array<Read, 12> reads = {};
  bool operator==(const Key &) const = default;
};

struct KeyHash {
  std::size_t operator()(const Key &key) const {
    std::size_t hash = key.head;
    for (const Read &read : key.reads)
      for (const std::uint32_t word : read)
        hash = (hash ^ word) * 0x9E3779B97F4A7C15u;
    return hash;
  }
};

/// A register that holds a value. It is valid while the components keep their versions.
struct Holder {
  std::uint16_t temporary = 0;
  std::uint8_t mask = 0;
  std::array<std::uint32_t, 4> versions = {};
};

class Sharing {
public:
  explicit Sharing(ir::Program &program) : m_program(program), m_versions(program) {}

  bool run() {
    bool changed = false;
    for (Instruction &instruction : m_program.code)
      changed |= visit(instruction);
    return changed;
  }

private:
  Key keyOf(const Instruction &instruction) const {
    const ir::OpInfo &row = ir::info(instruction.op);
    // A scalar result does not depend on the write mask.
    const std::uint32_t mask = row.has(ir::Replicates) ? 0u : instruction.dst.mask;
    const bool texture = row.has(ir::Texture);
    Key key;
    key.head = std::uint32_t(instruction.op) | std::uint32_t(instruction.dst.saturate) << 8 |
               mask << 9 | (texture ? std::uint32_t(instruction.unit) << 13 : 0u) |
               (texture ? std::uint32_t(instruction.target) << 21 : 0u);
    for (int s = 0; s < row.operandCount(); ++s)
      for (int i = 0; i < 4; ++i)
        key.reads[std::size_t(s) * 4 + std::size_t(i)] = readOf(instruction, s, i);
    if (row.has(ir::Commutative) && secondIsFirst(key))
      std::swap_ranges(key.reads.begin(), key.reads.begin() + 4, key.reads.begin() + 4);
    return key;
  }

  static bool secondIsFirst(const Key &key) {
    return std::lexicographical_compare(key.reads.begin() + 4, key.reads.begin() + 8,
                                        key.reads.begin(), key.reads.begin() + 4);
  }

  Read readOf(const Instruction &instruction, int operand, int position) const {
    if (!(ir::operandMask(instruction, operand) >> position & 1))
      return {};
    const ir::Operand &source = instruction.src[std::size_t(operand)];
    const Select select = source.swizzle[std::size_t(position)];
    const std::uint32_t sign = source.negate >> position & 1u;
    if (select > Select::W)
      return {1u | sign << 1 | std::uint32_t(select) << 2, 0, 0};
    const std::uint32_t head = 1u | sign << 1 | std::uint32_t(select) << 2 |
                               std::uint32_t(source.file) << 5 | std::uint32_t(source.index) << 8;
    if (source.relative)
      return {head | 1u << 31,
              std::uint32_t(source.address) << 16 | std::uint32_t(std::uint16_t(source.offset)),
              m_versions.ofAddress(source.address)};
    return {head, 0, source.file == File::Temporary ? m_versions.at(source.index, int(select)) : 0};
  }

  bool holds(const Holder &holder) const {
    for (int i = 0; i < 4; ++i)
      if ((holder.mask >> i & 1) &&
          m_versions.at(holder.temporary, i) != holder.versions[std::size_t(i)])
        return false;
    return true;
  }

  void copyFrom(Instruction &instruction, const Holder &holder) const {
    const bool replicated = ir::info(instruction.op).has(ir::Replicates);
    ir::Operand source;
    source.file = File::Temporary;
    source.index = holder.temporary;
    source.span = instruction.src[0].span;
    if (replicated) {
      int component = 0;
      while (!(holder.mask >> component & 1))
        ++component;
      source.swizzle.fill(Select(component));
    }
    fillUnused(source, instruction.dst.mask);
    instruction.op = Opcode::Mov;
    instruction.src = {source, {}, {}};
    instruction.dst.saturate = false; // the copied value is already clamped
  }

  bool visit(Instruction &instruction) {
    const ir::OpInfo &row = ir::info(instruction.op);
    const bool candidate =
        !row.has(ir::Kills) && instruction.op != Opcode::Mov && instruction.op != Opcode::Swz;
    if (!candidate) {
      m_versions.write(instruction);
      return false;
    }
    const Key key = keyOf(instruction);
    const auto found = m_holders.find(key);
    if (found != m_holders.end() && holds(found->second)) {
      copyFrom(instruction, found->second);
      m_versions.write(instruction);
      return true;
    }
    m_versions.write(instruction);
    if (instruction.dst.file == File::Temporary) {
      Holder holder{instruction.dst.index, instruction.dst.mask, {}};
      for (int i = 0; i < 4; ++i)
        holder.versions[std::size_t(i)] = m_versions.at(holder.temporary, i);
      m_holders[key] = holder;
    }
    return false;
  }

  ir::Program &m_program;
  Versions m_versions;
  std::unordered_map<Key, Holder, KeyHash> m_holders;
};
} // namespace

bool shareExpressions(ir::Program &program) { return Sharing(program).run(); }

} // namespace arbiter::fp::opt
