#include "fp_compiler/hw/r300/lower/pack.h"

namespace arbiter::fp::hw::r300 {

namespace {
class Packer {
public:
  Packer(const Flow &flow, Packed &packed) : m_flow(flow), m_packed(packed) {}

  bool run(const Item *rgb, const Item *alpha) {
    // Place arguments without a choice first: presubtract sources, then arguments that need an RGB
    // and an alpha address.
    bool fits =
        (!rgb || presubtract(*rgb, false)) && (!alpha || alpha == rgb || presubtract(*alpha, true));
    for (const bool tied : {true, false}) {
      if (rgb)
        for (int i = 0; fits && i < argumentsOf(rgb->rgb); ++i)
          fits = rgbArgument(*rgb, std::size_t(i), tied);
      if (alpha && !tied)
        for (int i = 0; fits && i < argumentsOf(alpha->alpha, rgb ? rgb->rgb : RgbOp::None); ++i)
          fits = alphaArgument(*alpha, std::size_t(i));
    }
    return fits;
  }

private:
  [[nodiscard]] std::uint32_t address(const FlowArgument &argument, std::size_t component) const {
    if (argument.bank == FlowArgument::Bank::Row)
      return Packed::kRow | argument.source[0];
    ItemId root = argument.source[component];
    while (m_flow.parent[root] != root)
      root = m_flow.parent[root];
    return root;
  }

  /// Returns the RGB and the alpha address that an RGB argument needs, or kFree.
  std::array<std::uint32_t, 2> addresses(const FlowArgument &argument,
                                         std::uint8_t components) const {
    std::array<std::uint32_t, 2> result = {Packed::kFree, Packed::kFree};
    for (std::size_t c = 0; c < 3; ++c)
      if ((components >> c & 1) && kTaps[argument.select][c] < 4)
        result[kTaps[argument.select][c] == 3] = address(argument, c);
    return result;
  }

  static bool put(std::uint32_t &slot, std::uint32_t wanted) {
    if (wanted == Packed::kFree || slot == wanted)
      return true;
    if (slot != Packed::kFree)
      return false;
    slot = wanted;
    return true;
  }

  bool presubtract(const Item &item, bool alpha) {
    if (item.presubtract == Presubtract::None)
      return true;
    const bool two =
        item.presubtract == Presubtract::S1MinusS0 || item.presubtract == Presubtract::S1PlusS0;
    for (std::size_t i = 0; i < (two ? 2u : 1u); ++i)
      if (alpha ? !put(m_packed.alpha[i], address(item.presubtracted[i], 0))
                : !put(m_packed.rgb[i], addresses(item.presubtracted[i], rgbComponents(item))[0]))
        return false;
    return true;
  }

  bool rgbArgument(const Item &item, std::size_t index, bool tied) {
    const FlowArgument &argument = item.rgbArguments[index];
    if (argument.presubtracted) {
      m_packed.rgbSource[index] = kPresubtracted;
      return true;
    }
    if (argument.bank == FlowArgument::Bank::None)
      return true;
    const auto wanted = addresses(argument, rgbComponents(item));
    if ((wanted[0] != Packed::kFree && wanted[1] != Packed::kFree) != tied)
      return true;
    return choose(wanted, m_packed.rgbSource[index]);
  }

  bool alphaArgument(const Item &item, std::size_t index) {
    const FlowArgument &argument = item.alphaArguments[index];
    if (argument.presubtracted) {
      m_packed.alphaSource[index] = kPresubtracted;
      return true;
    }
    if (argument.bank == FlowArgument::Bank::None)
      return true;
    std::array<std::uint32_t, 2> wanted = {Packed::kFree, Packed::kFree};
    wanted[argument.select == std::uint8_t(AlphaSelect::W)] = address(argument, 0);
    return choose(wanted, m_packed.alphaSource[index]);
  }

  bool choose(const std::array<std::uint32_t, 2> &wanted, std::uint8_t &number) {
    const auto matches = [](std::uint32_t slot, std::uint32_t want, bool orFree) {
      return want == Packed::kFree || slot == want || (orFree && slot == Packed::kFree);
    };
    for (const bool orFree : {false, true})
      for (std::uint8_t i = 0; i < 3; ++i)
        if (matches(m_packed.rgb[i], wanted[0], orFree) &&
            matches(m_packed.alpha[i], wanted[1], orFree)) {
          (void)put(m_packed.rgb[i], wanted[0]);
          (void)put(m_packed.alpha[i], wanted[1]);
          number = i;
          return true;
        }
    return false;
  }

  const Flow &m_flow;
  Packed &m_packed;
};
} // namespace

bool pack(const Flow &flow, const Item *rgb, const Item *alpha, Packed &packed) {
  packed = {};
  return Packer(flow, packed).run(rgb, alpha);
}

bool packsAlone(const Flow &flow, const Item &item) {
  Packed packed;
  return pack(flow, item.kind == Item::Kind::Alpha ? nullptr : &item,
              item.kind == Item::Kind::Rgb ? nullptr : &item, packed);
}

} // namespace arbiter::fp::hw::r300
