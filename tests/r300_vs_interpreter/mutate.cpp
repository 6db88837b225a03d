#include "mutate.h"

#include <algorithm>
#include <utility>

#include "fp_compiler/hw/r300/check/reads.h"

namespace arbiter::r300 {

using namespace fp::hw::r300;

namespace {
/// Makes a mistake in one half of a pair; returns false if it would change nothing.
template <typename Half> bool mutateHalf(Half &half, std::size_t arguments, int kind, int choice) {
  using Op = decltype(half.op);
  using Select = decltype(half.arguments[0].select);
  if (half.op == Op::None)
    return false;
  if (kind == 0) {
    half.modifier = half.modifier == Modifier::One ? Modifier::X2 : Modifier::One;
    return true;
  }
  if (arguments == 0)
    return false;
  auto &argument = half.arguments[std::size_t(choice) % arguments];
  switch (kind) {
  case 1:
    argument.negate = !argument.negate;
    return argument.select != Select::Zero;
  case 2: // what a compiler that runs out of addresses does
    argument.source = std::uint8_t((argument.source + 1) % 3);
    return argument.select < Select::Zero;
  case 3:
    argument.select = argument.select == Select(0) ? Select(1) : Select(0);
    return true;
  case 4:
    std::swap(half.sources[0], half.sources[1]);
    return !(half.sources[0] == half.sources[1]);
  default:
    return false;
  }
}

bool readsResultOf(const Pair &second, const Pair &first) {
  const std::vector<Read> reads = readsOf(second);
  return std::any_of(reads.begin(), reads.end(), [&](const Read &read) {
    const Source &source =
        read.alphaAddress ? second.alpha.sources[read.number] : second.rgb.sources[read.number];
    const auto writes = [&](const auto &half) {
      return (half.mask >> read.component & 1) && half.temporary == source.index;
    };
    return source.bank == Source::Bank::Temporary && (writes(first.rgb) || writes(first.alpha));
  });
}
} // namespace

std::string mutate(Code &code, fp::testing::Random &random) {
  const int kind = random.below(8);
  const auto at = std::size_t(random.below(int(code.pairs.size())));
  Pair &pair = code.pairs[at];
  const std::string where = "pair " + std::to_string(at);
  if (kind < 5) {
    constexpr const char *kNames[] = {"modifier", "sign", "source", "select", "addresses"};
    const int choice = random.below(3);
    const bool done =
        random.chance(50)
            ? mutateHalf(pair.rgb, argumentCount(pair.rgb.op), kind, choice)
            : mutateHalf(pair.alpha, argumentCount(pair.alpha.op, pair.rgb.op), kind, choice);
    return done ? where + ": " + kNames[kind] : std::string();
  }
  if (kind == 5) { // swaps two pairs
    if (at + 1 >= code.pairs.size() || !readsResultOf(code.pairs[at + 1], pair))
      return {};
    std::swap(code.pairs[at], code.pairs[at + 1]);
    return where + ": changes places with the next";
  }
  if (kind == 6) { // overwrites a register that is still in use
    if (pair.rgb.mask == 0 || code.temporaries < 2)
      return {};
    pair.rgb.temporary = std::uint16_t((pair.rgb.temporary + 1) % code.temporaries);
    return where + ": register";
  }
  if (code.textures.empty())
    return {};
  auto &texture = code.textures[std::size_t(random.below(int(code.textures.size())))];
  texture.source = std::uint16_t((texture.source + 1) % code.temporaries);
  return code.temporaries > 1 ? "TEX: source" : "";
}

} // namespace arbiter::r300
