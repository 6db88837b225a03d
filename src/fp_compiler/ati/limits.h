#pragma once
#include "fp_compiler/ati/shader.h"
#include "fp_compiler/limits.h"

namespace arbiter::fp::ati {

/// Returns the limits of ATI fragment shaders. Their language fixes all (ATI_text_fragment_shader
/// 3.10.1) except the number of units. Native limits are the same, because the language matches the
/// hardware.
[[nodiscard]] inline Limits limitsOf(Limits fragment) {
  ResourceCounts counts;
  counts.aluInstructions = kMaxPasses * kMaxPairs; // instruction pairs
  counts.texInstructions = kMaxPasses * kRegisters;
  counts.instructions = counts.aluInstructions + counts.texInstructions;
  counts.texIndirections = kMaxPasses;
  counts.temporaries = kRegisters;
  counts.parameters = kConstants;
  counts.attribs = kRegisters + 2; // t0 to t5, and the colours
  fragment.api = fragment.native = counts;
  fragment.envParameters = fragment.localParameters = kConstants;
  fragment.nativeModel = NativeModel::Documented;
  return fragment;
}

} // namespace arbiter::fp::ati
