#pragma once
#include "fp_compiler/hw/r300/lower/emitter.h"

/// The arithmetic opcodes as operations that the chip has.
namespace arbiter::fp::hw::r300 {

class Arithmetic {
public:
  explicit Arithmetic(Emitter &emit) : m_emit(emit) {}

  /// Requires: \p op is neither Texture nor Kills.
  Value computed(ir::Opcode op, std::uint8_t mask, const std::array<Value, 3> &s, const How &how);
  /// A copy: written, and readable behind.
  Value copied(std::uint8_t mask, const Value &value, const How &how);

private:
  Value with(Value result, int mask, const Value &value, const How &how);
  Value turned(std::uint8_t work, std::uint8_t mask, const Value &x, const Value &phase,
               const How &how);
  Value lit(std::uint8_t mask, const Value &s, const How &how);

  Emitter &m_emit;
};

} // namespace arbiter::fp::hw::r300
