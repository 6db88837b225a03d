#pragma once
#include "fp_compiler/ir/fields.h"
#include "fp_compiler/jit.h"

/// Serialises the shape of a prepared program, to pass it through the JIT's library
/// (jit_boundary.h).
namespace arbiter::fp::jit {

FP_FIELDS(FragmentInput, attribute, components)
FP_FIELDS(Sampler, unit, target)
FP_FIELDS(FragmentShape, inputs, samplers, colorOutputs, writesDepth, kills, derivatives,
          needsQuads)
FP_FIELDS(VertexShape, inputs, outputs, samplers)

} // namespace arbiter::fp::jit
