#include "state/imaging/color_table.h"

#include "state/imaging/arithmetic.h"
#include "state/imaging/formats.h"

namespace arbiter::state::imaging {

void ColorTable::set(std::size_t first, const std::vector<Rgba> &colors) {
  const Format *const kind = findFormat(format);
  for (std::size_t i = 0; kind && i < colors.size() && first + i < entries.size(); ++i)
    entries[first + i] = rounded(*kind, select(kind->base, clamped(colors[i])));
}

void ColorTable::apply(Pixels &pixels) const {
  if (entries.empty())
    return;
  const Base base = baseOf(format);
  for (Rgba &texel : pixels.texels)
    for (std::size_t c = 0; c < 4; ++c)
      if (acts(base, int(c)))
        texel[c] = entries[indexOf(texel[c], entries.size())][c];
}

} // namespace arbiter::state::imaging
