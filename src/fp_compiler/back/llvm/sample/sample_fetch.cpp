#include "fp_compiler/back/llvm/sample/sample_parts.h"

#include <llvm/IR/IntrinsicsX86.h>

/// Reads texels. A gather is one load for each lane. If the lanes of a row read close to each
/// other, one vector load and a permutation replace it. The words are the same either way.
namespace arbiter::fp::llvm_back {
namespace {

/// Returns a texel's address as a base and an index of a type of its size. Gathers support this
/// form directly.
Value *texelPointer(Code &code, const ImageCode &image, Value *index) {
  llvm::Type *const type = code.ir.getIntNTy(unsigned(abi::bytesOf(image.format.layout)) * 8);
  return code.ir.CreateGEP(type, image.base, index);
}

/// Gathers from each texel, from its word `word` on.
/// \param type i32 or i64
Value *gather(Code &code, const ImageCode &image, Value *index, int word, llvm::Type *type) {
  const int bytes = abi::bytesOf(image.format.layout);
  Value *base = image.base;
  int scale = bytes;
  if (bytes == 16) { // addresses have no scale of 16
    index = code.ir.CreateShl(index, code.splat(1));
    scale = 8;
  }
  if (word > 0)
    base = code.ir.CreateConstGEP1_64(code.ir.getInt32Ty(), base, std::uint64_t(word));
  // For texels under 32 bits this reads some bytes beyond them, which is allowed.
  Value *const pointers = code.ir.CreateGEP(code.ir.getIntNTy(unsigned(scale) * 8), base, index);
  return code.ir.CreateMaskedGather(llvm::FixedVectorType::get(type, unsigned(code.lanes)),
                                    pointers, llvm::Align(1));
}

Value *gatherWord(Code &code, const ImageCode &image, Value *index, int word) {
  return gather(code, image, index, word, code.ir.getInt32Ty());
}

/// Splits 64-bit lanes into lower and upper words.
std::array<Value *, 2> splitWords(Code &code, Value *both) {
  Value *const words = code.ir.CreateBitCast(
      both, llvm::FixedVectorType::get(code.ir.getInt32Ty(), unsigned(code.lanes) * 2));
  llvm::SmallVector<int, 16> low, high;
  for (int lane = 0; lane < code.lanes; ++lane) {
    low.push_back(2 * lane);
    high.push_back(2 * lane + 1);
  }
  return {code.ir.CreateShuffleVector(words, low), code.ir.CreateShuffleVector(words, high)};
}

/// Gathers words `word` and `word` + 1, with half as many loads as two gathers.
void gatherPair(Code &code, const ImageCode &image, Value *index, int word, Words &words) {
  const auto [low, high] = splitWords(code, gather(code, image, index, word, code.ir.getInt64Ty()));
  words[std::size_t(word)] = low;
  words[std::size_t(word) + 1] = high;
}

/// Permutes lanes: lane i of the result is lane index[i] of `values`.
Value *permuted(Code &code, Value *values, Value *index) {
  const auto id = code.cpu.family == Cpu::Family::Avx512
                      ? llvm::Intrinsic::x86_avx512_permvar_si_512
                      : llvm::Intrinsic::x86_avx2_permd;
  return code.ir.CreateIntrinsic(id, {}, {values, index});
}

/// True if a gather is hardly slower than its loads, so that avoiding it does not pay. That is so
/// on Sapphire Rapids and later. The feature identifies them better than a name that a virtual
/// machine invented. Earlier Intel processors have slow gathers since the mitigation of data
/// sampling. AMD's were always slow. For a processor not known as fast, LLVM splits a gather into
/// single loads.
bool gathersQuickly(const Cpu &cpu) {
  return cpu.features.find("+avx512fp16") != std::string::npos;
}

/// Texels of the lanes within `lanes` texels of each other.
struct Window {
  Value *base = nullptr; ///< i32: index of the first texel
  Value *lane = nullptr; ///< offset of the lane's texel in the window
  Value *fits = nullptr; ///< lanes whose texel is in the window
};

/// Returns the window of a row. Its coordinates are mostly monotonic, so the window starts at the
/// first or the last lane's texel.
Window windowOf(Code &code, Value *index) {
  Window window;
  Value *const first = code.ir.CreateExtractElement(index, std::uint64_t(0));
  Value *const last = code.ir.CreateExtractElement(index, std::uint64_t(code.lanes - 1));
  window.base = code.ir.CreateBinaryIntrinsic(llvm::Intrinsic::smin, first, last);
  window.lane = code.ir.CreateSub(index, code.splat(window.base));
  window.fits = code.ir.CreateICmpULT(window.lane, code.splat(code.lanes));
  return window;
}

/// Loads the window's texels, in the lanes' order. Reads `lanes` texels from the first one, at most
/// 60 bytes beyond the last row.
Value *loadWindow(Code &code, const ImageCode &image, Value *base, Value *lane) {
  Value *const pointer = texelPointer(code, image, base);
  Value *const texels = code.ir.CreateAlignedLoad(code.i32, pointer, llvm::Align(1));
  return permuted(code, texels, lane);
}

/// True if the lanes of a row are checked for a common window before a gather.
bool sharesWindows(Code &code, abi::Lanes lanes, const ImageCode &image) {
  const bool permutes =
      code.cpu.family == Cpu::Family::Avx512 || code.cpu.family == Cpu::Family::Avx2;
  return permutes && !gathersQuickly(code.cpu) && lanes == abi::Lanes::Row &&
         abi::bytesOf(image.format.layout) == 4;
}

/// Loads pairs of texels for lanes [4 i, 4 i + 2), or with `second` for the two lanes after those.
/// Shuffles within 128-bit parts can then restore the order.
Value *loadPairs(Code &code, const ImageCode &image, Value *first, bool second) {
  llvm::IRBuilder<> &ir = code.ir;
  Value *pairs =
      llvm::PoisonValue::get(llvm::FixedVectorType::get(ir.getInt64Ty(), unsigned(code.lanes) / 2));
  // Extending all indices at once is faster, because an address needs a 64-bit register and an
  // index may be negative.
  Value *const indices =
      ir.CreateSExt(first, llvm::FixedVectorType::get(ir.getInt64Ty(), unsigned(code.lanes)));
  for (int i = 0; i < code.lanes / 2; ++i) {
    const int lane = i / 2 * 4 + i % 2 + (second ? 2 : 0);
    Value *const index = ir.CreateExtractElement(indices, std::uint64_t(lane));
    Value *const pair = ir.CreateAlignedLoad(
        ir.getInt64Ty(), ir.CreateGEP(ir.getInt32Ty(), image.base, index), llvm::Align(1));
    pairs = ir.CreateInsertElement(pairs, pair, std::uint64_t(i));
  }
  return pairs;
}

/// Loads two neighbouring 32-bit texels with one 64-bit load for each lane.
TexelPair loadNeighbours(Code &code, const ImageCode &image, Value *first) {
  llvm::IRBuilder<> &ir = code.ir;
  std::array<Value *, 2> words;
  for (std::size_t i = 0; i < 2; ++i)
    words[i] = ir.CreateBitCast(loadPairs(code, image, first, i == 1), code.i32);
  llvm::SmallVector<int, 16> firsts, seconds;
  for (int part = 0; part < code.lanes; part += 4)
    for (const int from : {part, code.lanes + part})
      for (const int pair : {from, from + 2}) {
        firsts.push_back(pair);
        seconds.push_back(pair + 1);
      }
  return {ir.CreateShuffleVector(words[0], words[1], firsts),
          ir.CreateShuffleVector(words[0], words[1], seconds)};
}

/// Returns two neighbouring 32-bit texels from one 64-bit load. Reads at most one texel beyond the
/// last.
TexelPair gatherNeighbours(Code &code, const ImageCode &image, Value *first) {
  if (code.cpu.family == Cpu::Family::Avx2 || code.cpu.family == Cpu::Family::Sse41)
    return loadNeighbours(code, image, first);
  const auto [low, high] = splitWords(code, gather(code, image, first, 0, code.ir.getInt64Ty()));
  return {low, high};
}

/// The texel pairs of one row or two, and their conversion for control flow.
using Pairs = std::array<TexelPair, 2>;
Values valuesOf(const Pairs &pairs) {
  return {pairs[0].first, pairs[0].second, pairs[1].first, pairs[1].second};
}
Pairs pairsOf(const Values &values) {
  return {TexelPair{values[0], values[1]}, TexelPair{values[2], values[3]}};
}

/// The positions of two texels in one row or in two.
struct Footprint {
  const AxisTexels &x;
  std::array<Value *, 2> row; ///< the second may be null
  [[nodiscard]] Value *index(Code &code, std::size_t column, std::size_t line) const {
    return code.ir.CreateAdd(x.index[column], row[line]);
  }
};

/// Returns the lanes whose second texel follows the first in memory or has no weight; null: all.
Value *neighbours(Code &code, const ImageCode &image, const AxisTexels &x) {
  if (x.next == AxisTexels::Next::Edge)
    return nullptr;
  if (x.next == AxisTexels::Next::Repeat)
    return code.ir.CreateICmpNE(x.index[0],
                                code.splat(code.ir.CreateSub(image.size[0], code.ir.getInt32(1))));
  return code.ir.CreateICmpEQ(code.ir.CreateAdd(x.index[0], code.splat(1)), x.index[1]);
}

Pairs gatherFootprint(Code &code, const ImageCode &image, const Footprint &footprint) {
  const auto forRows = [&](const std::function<TexelPair(std::size_t)> &pair) {
    return Pairs{pair(0), footprint.row[1] ? pair(1) : TexelPair{}};
  };
  const auto each = [&] {
    return forRows([&](std::size_t line) {
      return TexelPair{gatherWord(code, image, footprint.index(code, 0, line), 0),
                       gatherWord(code, image, footprint.index(code, 1, line), 0)};
    });
  };
  if (gathersQuickly(code.cpu) || abi::bytesOf(image.format.layout) != 4)
    return each();
  const auto both = [&] {
    return forRows([&](std::size_t line) {
      return gatherNeighbours(code, image, footprint.index(code, 0, line));
    });
  };
  Value *const next = neighbours(code, image, footprint.x);
  if (!next)
    return both();
  return pairsOf(eitherOf(
      code, allLanes(code, next), [&] { return valuesOf(both()); },
      [&] { return valuesOf(each()); }));
}

} // namespace

Words fetchTexels(Code &code, abi::Lanes lanes, const ImageCode &image, Value *index,
                  unsigned words) {
  Words result = {};
  if (!words)
    return result;
  if (sharesWindows(code, lanes, image)) {
    const Window window = windowOf(code, index);
    result[0] = eitherOf(
        code, allLanes(code, window.fits),
        [&] { return Values{loadWindow(code, image, window.base, window.lane)}; },
        [&] { return Values{gatherWord(code, image, index, 0)}; })[0];
    return result;
  }
  for (int word = 0; word < 4; word += 2) {
    const unsigned wanted = words >> word & 3;
    const int one = wanted == 2 ? word + 1 : word;
    if (wanted == 3)
      gatherPair(code, image, index, word, result);
    else if (wanted)
      result[std::size_t(one)] = gatherWord(code, image, index, one);
  }
  return result;
}

std::array<TexelPair, 2> fetchFootprint(Code &code, abi::Lanes lanes, const ImageCode &image,
                                        const AxisTexels &x, Value *row0, Value *row1) {
  const Footprint footprint = {x, {row0, row1}};
  if (!sharesWindows(code, lanes, image))
    return gatherFootprint(code, image, footprint);
  std::array<Window, 2> windows;
  Value *fits = neighbours(code, image, x);
  for (std::size_t line = 0; line < 2 && footprint.row[line]; ++line) {
    windows[line] = windowOf(code, footprint.index(code, 0, line));
    fits = fits ? code.ir.CreateAnd(fits, windows[line].fits) : windows[line].fits;
  }
  const auto near = [&] {
    Pairs pairs;
    for (std::size_t line = 0; line < 2 && footprint.row[line]; ++line) {
      // The window of the second texels is one further, so that it ends at most 64 bytes beyond the
      // last row.
      const Window &window = windows[line];
      Value *const secondBase = code.ir.CreateAdd(window.base, code.ir.getInt32(1));
      pairs[line] = {loadWindow(code, image, window.base, window.lane),
                     loadWindow(code, image, secondBase, window.lane)};
    }
    return valuesOf(pairs);
  };
  return pairsOf(eitherOf(code, allLanes(code, fits), near,
                          [&] { return valuesOf(gatherFootprint(code, image, footprint)); }));
}

} // namespace arbiter::fp::llvm_back
