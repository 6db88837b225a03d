#pragma once
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "fp_compiler/ir/ir.h"
#include "fp_compiler/ir/semantics.h"

namespace arbiter::fp::ir {

/// A texture access after TXP's division.
struct Sample {
  TexTarget target = TexTarget::Tex2D;
  std::uint8_t unit = 0;
  /// s, t, r; r is the reference of a shadow target. Coordinates that the target does not use are
  /// 0.
  Vec4 coordinate = {};
  float bias = 0.0f;        ///< from TXB
  std::optional<float> lod; ///< from TXL, which needs no derivatives
  /// Derivatives from TXD: those of the coordinate along the window's x and y.
  struct Gradient {
    Vec4 x = {}, y = {};
  };
  std::optional<Gradient> gradient;
};

/// One instruction as the interpreter ran it, for a trace.
struct Step {
  std::size_t index = 0; ///< index into Program::code
  /// The operands after swizzle and sign. For a texture access, the whole coordinate operand.
  Operands operands = {};
  std::optional<Sample> sample; ///< for a texture access
  /// The whole destination register after the write. An address register is in x. Zero for KIL.
  Vec4 value = {};
  bool discards = false; ///< true if KIL's condition held
};

/// Everything outside a program that its result depends on. An empty function gives zeros.
struct Inputs {
  /// One vec4 for each of Program::attributes, in that order; missing ones are zero.
  std::span<const Vec4> attributes;
  /// Values of Env, Local and State rows.
  std::function<Vec4(const Parameter &)> parameter;
  std::function<Vec4(const Sample &)> texture;
  /// The fog coordinate, for the fog options.
  float fogCoordinate = 0.0f;
  /// The secondary colour, for Options::colorSum.
  Vec4 secondary = {};
  /// The arithmetic. A vertex program uses Legacy if this is Fp24. The functions and attributes
  /// give unrounded values: the interpreter rounds.
  Numerics numerics = Numerics::Host;
  /// Called with the operands of an arithmetic opcode, and may change them. For error analysis.
  std::function<void(const Instruction &, Operands &)> operands;
  /// Called with each result before _SAT and the write, and may change it.
  std::function<void(const Instruction &, Vec4 &)> result;
  /// Called after each instruction.
  std::function<void(const Step &)> observer;
  /// True if a fragment keeps running after a KIL discards it, as a helper fragment does.
  bool pastKill = false;
};

/// The results of a program for one fragment.
struct Evaluation {
  std::vector<Vec4> outputs;  ///< one for each of Program::outputs; clamped only by a fog option
  std::optional<float> depth; ///< if the program writes result.depth.z; not clamped
  bool killed = false;        ///< then the rest is zero, unless Inputs::pastKill is set
};

/// Runs a program in the reference interpreter (semantics.h).
/// Requires: validate(program) finds nothing.
[[nodiscard]] Evaluation evaluate(const Program &program, const Inputs &inputs);

/// Runs a program for 2x2 pixels of the window, so that DDX and DDY have neighbours. The order is
/// lower left, lower right, upper left, upper right.
[[nodiscard]] std::array<Evaluation, 4> evaluateQuad(const Program &program,
                                                     const std::array<Inputs, 4> &inputs);

} // namespace arbiter::fp::ir
