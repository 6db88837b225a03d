#pragma once
#include "state/mirror/attributes.h"

namespace arbiter::state {

/// Tells what is known of the materials of recorded primitives. Each part has a bit
/// (primitive_materials.h).
struct MaterialParts {
  void begin(bool mayDifferNow) {
    known = differing = given = 0;
    isUndecided = false;
    mayDiffer = mayDifferNow;
  }

  MaterialMask known = 0;     ///< parts whose values the recorder has
  MaterialMask differing = 0; ///< parts that are not the same for all vertices
  MaterialMask given = 0;     ///< parts whose recorded values the host has
  /// The differing parts that the last draw was chosen for. The next primitive is chosen for the
  /// same, until it is known which parts differ in it.
  MaterialMask chosen = 0;
  /// true if no program reads materials, which would be those of before the primitive
  bool mayDiffer = false;
  bool isUndecided = false; ///< true if the last choice failed and must be tried again
};

} // namespace arbiter::state
