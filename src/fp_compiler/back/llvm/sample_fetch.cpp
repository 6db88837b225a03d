#include "fp_compiler/back/llvm/sample_parts.h"

#include <llvm/IR/IntrinsicsX86.h>

/// Reading texels. A gather is one load a lane, so where the lanes of a row turn out to read close
/// to each other, one vector load and a permutation replace it; the words are the same either way.
namespace arbiter::fp::llvm_back {
namespace {

/// A texel's address as a base and an index of a type of its size, which gathers can take as it is.
Value *texelPointer(Code &code, const ImageCode &image, Value *index) {
  llvm::Type *const type = code.ir.getIntNTy(unsigned(abi::bytesOf(image.format.layout)) * 8);
  return code.ir.CreateGEP(type, image.base, index);
}

/// \param type i32 or i64: what is read of each texel, from its word `word` on
Value *gather(Code &code, const ImageCode &image, Value *index, int word, llvm::Type *type) {
  const int bytes = abi::bytesOf(image.format.layout);
  Value *base = image.base;
  int scale = bytes;
  if (bytes == 16) { // no address has a scale of 16
    index = code.ir.CreateShl(index, code.splat(1));
    scale = 8;
  }
  if (word > 0)
    base = code.ir.CreateConstGEP1_64(code.ir.getInt32Ty(), base, std::uint64_t(word));
  // Of a texel of less than 32 bits this reads some of what follows, which may be read.
  Value *const pointers = code.ir.CreateGEP(code.ir.getIntNTy(unsigned(scale) * 8), base, index);
  return code.ir.CreateMaskedGather(llvm::FixedVectorType::get(type, unsigned(code.lanes)),
                                    pointers, llvm::Align(1));
}

Value *gatherWord(Code &code, const ImageCode &image, Value *index, int word) {
  return gather(code, image, index, word, code.ir.getInt32Ty());
}

/// Words `word` and the next one: half as many loads as two gathers.
void gatherPair(Code &code, const ImageCode &image, Value *index, int word, Words &words) {
  Value *const both = code.ir.CreateBitCast(
      gather(code, image, index, word, code.ir.getInt64Ty()),
      llvm::FixedVectorType::get(code.ir.getInt32Ty(), unsigned(code.lanes) * 2));
  llvm::SmallVector<int, 16> low, high;
  for (int lane = 0; lane < code.lanes; ++lane) {
    low.push_back(2 * lane);
    high.push_back(2 * lane + 1);
  }
  words[std::size_t(word)] = code.ir.CreateShuffleVector(both, low);
  words[std::size_t(word) + 1] = code.ir.CreateShuffleVector(both, high);
}

/// Lane i of the result is lane index[i] of `values`.
Value *permuted(Code &code, Value *values, Value *index) {
  const auto id = code.cpu.family == Cpu::Family::Avx512
                      ? llvm::Intrinsic::x86_avx512_permvar_si_512
                      : llvm::Intrinsic::x86_avx2_permd;
  return code.ir.CreateIntrinsic(id, {}, {values, index});
}

/// Whether lanes are looked at for texels close together before they are gathered. Not where a
/// gather costs hardly more than its loads: of Sapphire Rapids and later, which the feature tells
/// better than a name that a virtual machine made up. Intel's earlier ones are slow since they were
/// mended against data sampling, AMD's always were, and for a processor that it does not know as
/// fast LLVM makes no gather at all.
bool looksForWindows(const Cpu &cpu) {
  return (cpu.family == Cpu::Family::Avx512 || cpu.family == Cpu::Family::Avx2) &&
         cpu.features.find("+avx512fp16") == std::string::npos;
}

/// Where the lanes' texels are within `lanes` texels of each other.
struct Window {
  Value *base = nullptr; ///< i32: index of the first texel
  Value *lane = nullptr; ///< which of the window's texels is the lane's
  Value *fits = nullptr; ///< lanes that have theirs in the window
};

/// Coordinates of a row mostly rise or fall, so the window begins at the first or the last lane's.
Window windowOf(Code &code, Value *index) {
  Window window;
  Value *const first = code.ir.CreateExtractElement(index, std::uint64_t(0));
  Value *const last = code.ir.CreateExtractElement(index, std::uint64_t(code.lanes - 1));
  window.base = code.ir.CreateBinaryIntrinsic(llvm::Intrinsic::smin, first, last);
  window.lane = code.ir.CreateSub(index, code.splat(window.base));
  window.fits = code.ir.CreateICmpULT(window.lane, code.splat(code.lanes));
  return window;
}

/// The window's texels, in the lanes' order. Reads `lanes` texels from the first one: at most 60
/// bytes behind the last row.
Value *loadWindow(Code &code, const ImageCode &image, Value *base, Value *lane) {
  Value *const pointer = texelPointer(code, image, base);
  Value *const texels = code.ir.CreateAlignedLoad(code.i32, pointer, llvm::Align(1));
  return permuted(code, texels, lane);
}

struct Branch {
  llvm::BasicBlock *near, *far, *join;
};
Branch branchOn(Code &code, Value *near) {
  llvm::Function *const function = code.ir.GetInsertBlock()->getParent();
  Branch branch = {llvm::BasicBlock::Create(code.context(), "texels.near", function),
                   llvm::BasicBlock::Create(code.context(), "texels.far", function),
                   llvm::BasicBlock::Create(code.context(), "texels", function)};
  code.ir.CreateCondBr(near, branch.near, branch.far);
  return branch;
}

Value *joined(Code &code, Value *near, llvm::BasicBlock *nearEnd, Value *far,
              llvm::BasicBlock *farEnd) {
  llvm::PHINode *const phi = code.ir.CreatePHI(near->getType(), 2);
  phi->addIncoming(near, nearEnd);
  phi->addIncoming(far, farEnd);
  return phi;
}

} // namespace

Words fetchTexels(Code &code, abi::Lanes lanes, const ImageCode &image, Value *index,
                  unsigned words) {
  Words result = {};
  if (!words)
    return result;
  if (lanes == abi::Lanes::Row && abi::bytesOf(image.format.layout) == 4 &&
      looksForWindows(code.cpu)) {
    const Window window = windowOf(code, index);
    const Branch branch = branchOn(code, allLanes(code, window.fits));
    code.ir.SetInsertPoint(branch.near);
    Value *const near = loadWindow(code, image, window.base, window.lane);
    code.ir.CreateBr(branch.join);
    code.ir.SetInsertPoint(branch.far);
    Value *const far = gatherWord(code, image, index, 0);
    code.ir.CreateBr(branch.join);
    code.ir.SetInsertPoint(branch.join);
    result[0] = joined(code, near, branch.near, far, branch.far);
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

std::array<Value *, 4> fetchFootprint(Code &code, abi::Lanes lanes, const ImageCode &image,
                                      const AxisTexels &x, Value *row0, Value *row1) {
  std::array<Value *, 4> index = {code.ir.CreateAdd(x.index[0], row0),
                                  code.ir.CreateAdd(x.index[1], row0), nullptr, nullptr};
  if (row1) {
    index[2] = code.ir.CreateAdd(x.index[0], row1);
    index[3] = code.ir.CreateAdd(x.index[1], row1);
  }
  const auto gatherAll = [&] {
    std::array<Value *, 4> texels = {};
    for (std::size_t i = 0; i < 4; ++i)
      if (index[i])
        texels[i] = gatherWord(code, image, index[i], 0);
    return texels;
  };
  if (lanes != abi::Lanes::Row || abi::bytesOf(image.format.layout) != 4 ||
      !looksForWindows(code.cpu))
    return gatherAll();

  const Window window = windowOf(code, index[0]);
  const Window upper = row1 ? windowOf(code, index[2]) : Window{};
  Value *fits = window.fits;
  if (row1)
    fits = code.ir.CreateAnd(fits, upper.fits);
  if (!x.neighbours) {
    Value *const next = code.ir.CreateAdd(x.index[0], code.splat(1));
    fits = code.ir.CreateAnd(fits, code.ir.CreateICmpEQ(next, x.index[1]));
  }
  const Branch branch = branchOn(code, allLanes(code, fits));
  code.ir.SetInsertPoint(branch.near);
  // The second texels' window is one texel further: it ends at most 64 bytes behind the last row.
  std::array<Value *, 4> near = {};
  const auto load = [&](const Window &from, std::size_t at) {
    near[at] = loadWindow(code, image, from.base, from.lane);
    Value *const behind = code.ir.CreateAdd(from.base, code.ir.getInt32(1));
    near[at + 1] = loadWindow(code, image, behind, from.lane);
  };
  load(window, 0);
  if (row1)
    load(upper, 2);
  code.ir.CreateBr(branch.join);
  code.ir.SetInsertPoint(branch.far);
  const std::array<Value *, 4> far = gatherAll();
  code.ir.CreateBr(branch.join);
  code.ir.SetInsertPoint(branch.join);
  std::array<Value *, 4> texels = {};
  for (std::size_t i = 0; i < 4; ++i)
    if (near[i])
      texels[i] = joined(code, near[i], branch.near, far[i], branch.far);
  return texels;
}

} // namespace arbiter::fp::llvm_back
