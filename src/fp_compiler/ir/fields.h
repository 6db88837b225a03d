#pragma once
#include "fp_compiler/ir/ir.h"
#include "util/cache/archive.h"

/// Serialises programs: lists the members of the structures of ir.h for an archive
/// (util/cache/archive.h). The bytes are valid for one build on one machine. The program cache and
/// the JIT's library use them.
namespace arbiter::fp {

// Members are bound by position, so a new member does not compile until it has a name in its
// structure's list and is written too. The names are arbitrary. The functions are in their types'
// namespaces, so that the archive finds them.

#define FP_FIELDS(Type, ...)                                                                       \
  template <typename Archive> void fields(Archive &archive, Type &value) {                         \
    auto &[__VA_ARGS__] = value;                                                                   \
    archive(__VA_ARGS__);                                                                          \
  }

FP_FIELDS(Span, begin, end)

namespace ir {
FP_FIELDS(Operand, file, index, swizzle, negate, relative, address, offset, span)
FP_FIELDS(Destination, file, index, mask, saturate, span)
FP_FIELDS(Instruction, op, dst, src, unit, target, span)
FP_FIELDS(Attribute, kind, index)
FP_FIELDS(Output, kind, index)
FP_FIELDS(StateRef, item, back, index, modifier, row)
FP_FIELDS(Parameter, kind, constant, index, state)
FP_FIELDS(Temporary, name)
FP_FIELDS(Options, fog, precision, shadow, drawBuffers, upperLeft, centerInteger, invariant, sum,
          nv, native)
FP_FIELDS(ParameterArray, name, rows)
FP_FIELDS(Program, language, options, temporaries, attributes, parameters, outputs, addresses,
          arrays, code)
} // namespace ir

} // namespace arbiter::fp
