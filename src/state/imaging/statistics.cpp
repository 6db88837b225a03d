#include "state/imaging/statistics.h"

#include <algorithm>

#include "state/imaging/arithmetic.h"
#include "state/imaging/formats.h"

namespace arbiter::state::imaging {

bool counts(GLenum format, int component) {
  switch (baseOf(format)) {
  case Base::Alpha:
    return component == 3;
  case Base::Luminance:
    return component == 0;
  case Base::LuminanceAlpha:
    return component == 0 || component == 3;
  case Base::Rgb:
    return component != 3;
  default:
    return true;
  }
}

void Histogram::count(const Pixels &pixels) {
  if (bins.empty())
    return;
  for (std::size_t c = 0; c < 4; ++c)
    if (counts(format, int(c)))
      for (const Rgba &texel : pixels.texels)
        ++bins[indexOf(texel[c], bins.size())][c];
}

void Minmax::count(const Pixels &pixels) {
  for (std::size_t c = 0; c < 4; ++c)
    if (counts(format, int(c)))
      for (const Rgba &texel : pixels.texels) {
        least[c] = std::min(least[c], texel[c]);
        most[c] = std::max(most[c], texel[c]);
      }
}

} // namespace arbiter::state::imaging
