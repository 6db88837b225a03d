#pragma once
#include "state/mirror/attributes.h"

namespace arbiter::state::software {

/// What is known of the materials of the primitives that are recorded, each part by its bit
/// (primitive_materials.h).
struct MaterialParts {
  void begin(bool mayDifferNow) {
    known = differing = given = 0;
    isUndecided = false;
    mayDiffer = mayDifferNow;
  }

  MaterialMask known = 0;     ///< the recorder has their values
  MaterialMask differing = 0; ///< not the same for all vertices
  MaterialMask given = 0;     ///< the host has those of the recorder
  /// Differing ones that the draw was chosen for. The next one is chosen for the same, until it is
  /// known what differs there.
  MaterialMask chosen = 0;
  bool mayDiffer = false;   ///< no program reads those of before the primitive
  bool isUndecided = false; ///< that came to nothing, and may come to something yet
};

} // namespace arbiter::state::software
