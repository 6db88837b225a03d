#pragma once
#include "fp_compiler/hw/r300/lower/emitter.h"

/// Lowers the arithmetic opcodes to operations that the chip has.
namespace arbiter::fp::hw::r300 {

class Arithmetic {
public:
  explicit Arithmetic(Emitter &emit) : m_emit(emit) {}

  /// Emits the operations of an opcode.
  /// Requires: \p op is neither Texture nor Kills.
  Value computed(ir::Opcode op, std::uint8_t mask, const std::array<Value, 3> &s,
                 const EmitOptions &options);
  /// Emits a copy. The result can be read from the copy or from what it copies.
  Value copied(std::uint8_t mask, const Value &value, const EmitOptions &options);

private:
  Value with(Value result, int mask, const Value &value, const EmitOptions &options);
  Value turned(std::uint8_t work, std::uint8_t mask, const Value &x, const Value &phase,
               const EmitOptions &options);
  Value lit(std::uint8_t mask, const Value &s, const EmitOptions &options);

  Emitter &m_emit;
};

} // namespace arbiter::fp::hw::r300
