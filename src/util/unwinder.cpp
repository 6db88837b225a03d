#include "util/unwinder.h"

namespace arbiter {

void prepareUnwinder() {
  struct Nothing {};
  try {
    throw Nothing();
  } catch (const Nothing &) { // the throw has filled the table
  }
}

} // namespace arbiter
