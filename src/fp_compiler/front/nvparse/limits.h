#pragma once
#include "fp_compiler/limits.h"
#include "fp_compiler/texture_shader/state.h"

namespace arbiter::fp::nvparse {

/// Returns the limits of nvparse's texts, which are those of the card's register combiners and
/// texture shaders. They are not a program target, so a text within the limits is native.
/// \param fragment the fragment target's, with generalCombiners, perStageConstants and
/// textureShaders
[[nodiscard]] inline Limits limitsOf(Limits fragment) {
  ResourceCounts counts;
  counts.aluInstructions = fragment.generalCombiners;
  counts.texInstructions = fragment.textureUnits;
  counts.instructions = counts.aluInstructions + counts.texInstructions;
  counts.texIndirections = fragment.textureShaders != 0 ? fragment.textureUnits : 1;
  counts.temporaries = 4 + fragment.textureUnits; // both colours, both spares, a unit's each
  // There are two constant colours, two more for each stage, and three rows for each unit.
  counts.parameters = (fragment.generalCombiners != 0 ? 2 : 0) +
                      (fragment.perStageConstants != 0 ? 2 * fragment.generalCombiners : 0) +
                      (fragment.textureShaders != 0 ? 3 * fragment.textureUnits : 0);
  counts.attribs = 3 + fragment.textureUnits; // both colours, fog
  fragment.api = fragment.native = counts;
  fragment.envParameters = std::uint32_t(texture_shader::parameter(0, texture_shader::Row::Bump));
  fragment.localParameters = 0;
  fragment.nativeModel = NativeModel::Documented;
  return fragment;
}

} // namespace arbiter::fp::nvparse
