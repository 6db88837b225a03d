#include "state/raster_draw/fallback.h"

#include <cstring>

namespace arbiter::state {

const char *fallbackName(Fallback reason) {
  switch (reason) {
#define ARBITER_FALLBACK(Enumerator, key, doc)                                                     \
  case Fallback::Enumerator:                                                                       \
    return key;
#include "state/raster_draw/reasons.def"
#undef ARBITER_FALLBACK
  }
  return "";
}

Fallback fallbackNamed(const char *key, Fallback otherwise) {
  if (key)
    for (int i = 0; i < kFallbackCount; ++i)
      if (std::strcmp(key, fallbackName(Fallback(i))) == 0)
        return Fallback(i);
  return otherwise;
}

} // namespace arbiter::state
