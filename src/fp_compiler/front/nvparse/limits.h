#pragma once
#include "fp_compiler/limits.h"
#include "fp_compiler/texture_shader/state.h"

namespace arbiter::fp::nvparse {

/// Limits of nvparse's texts: those of the card's register combiners and texture shaders, which are
/// no program target's; what fits them is native.
/// \param fragment the fragment target's, with generalCombiners, perStageConstants and
///        textureShaders
[[nodiscard]] inline Limits limitsOf(Limits fragment) {
  ResourceCounts counts;
  counts.aluInstructions = fragment.generalCombiners;
  counts.texInstructions = fragment.textureUnits;
  counts.instructions = counts.aluInstructions + counts.texInstructions;
  counts.texIndirections = fragment.textureShaders != 0 ? fragment.textureUnits : 1;
  counts.temporaries = 4 + fragment.textureUnits; // both colours, both spares, a unit's each
  counts.parameters = texture_shader::kParameters;
  counts.attribs = 3 + fragment.textureUnits; // both colours, fog
  fragment.api = fragment.native = counts;
  fragment.envParameters = texture_shader::kParameters;
  fragment.localParameters = 0;
  fragment.nativeModel = NativeModel::Documented;
  return fragment;
}

} // namespace arbiter::fp::nvparse
