#include "swrast/setup/small_block.h"

namespace arbiter::swrast {

GroupSetUp setUpSmallAvx512(const SmallSetUp &with, const WindowVertex *window,
                            const TriangleGroup &group, SmallTriangle *to) {
  return setUpGroup(with, window, group, to);
}

} // namespace arbiter::swrast
