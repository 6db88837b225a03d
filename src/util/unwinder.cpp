#include "util/unwinder.h"

namespace arbiter {

void prepareUnwinder() {
  struct Nothing {};
  try {
    throw Nothing();
  } catch (const Nothing &) { // the table is made now
  }
}

} // namespace arbiter
