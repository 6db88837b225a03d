#include "fp_compiler/back/llvm/pixel.h"

namespace arbiter::fp::llvm_back {

int PixelWriter::componentOf(const abi::Format &format, int k) {
  for (int c = 0; c < 4; ++c)
    if (format.swizzle[std::size_t(c)] == abi::From(k))
      return c;
  return -1;
}

bool PixelWriter::supports(const abi::FragmentKey &key, std::string &reason) {
  for (const abi::ColorTargetKey &target : key.targets) {
    if (target.format.layout != abi::Layout::None && target.format.layout != abi::Layout::U8x4) {
      reason = "colour buffers other than of four bytes";
      return false;
    }
    if (target.blend.enabled) {
      reason = "blending";
      return false;
    }
  }
  if (key.alphaTest != abi::Compare::Always || key.logicOpEnabled ||
      key.depthStencil.layout != abi::Layout::None) {
    reason = "tests and logic operations";
    return false;
  }
  return true;
}

void PixelWriter::setPixel(Value *x, Value *y) {
  for (std::size_t i = 0; i < m_key.targets.size(); ++i)
    m_targets.emplace_back(m_code, m_places, m_data,
                           offsetof(abi::FragmentData, targets) + sizeof(abi::Target) * i,
                           abi::bytesOf(m_key.targets[i].format.layout), x, y);
}

void PixelWriter::write(const PixelPlace &place, FragmentColors &fragment) {
  Value *mask = nullptr;
  if (fragment.alive)
    mask = m_code.ir.CreateAnd(fragment.alive, place.covered);
  for (std::size_t i = 0; i < m_key.targets.size(); ++i)
    if (m_key.targets[i].format.layout != abi::Layout::None && m_key.targets[i].writeMask != 0)
      storePixels(place, pixelsOf(fragment, i), i, mask);
}

Value *PixelWriter::pixelsOf(const FragmentColors &fragment, std::size_t target) {
  const Vec &color = fragment.colors[target];
  Value *const pixels = passedThrough(fragment, color, m_key.targets[target]);
  return pixels ? pixels : packUnorm8(m_code, m_key.targets[target].format, color);
}

void PixelWriter::storePixels(const PixelPlace &place, Value *pixels, std::size_t target,
                              Value *mask) {
  llvm::IRBuilder<> &ir = m_code.ir;
  const abi::ColorTargetKey &key = m_key.targets[target];
  std::uint32_t kept = 0;
  for (int k = 0; k < 4; ++k) {
    const int c = componentOf(key.format, k);
    if (c >= 0 && !(key.writeMask >> c & 1))
      kept |= 0xFFu << (8 * k);
  }
  if (kept != 0) {
    Value *const old = m_targets[target].load(place, ir.getInt32Ty(), 1);
    pixels = ir.CreateOr(ir.CreateAnd(pixels, m_code.splat(int(~kept))),
                         ir.CreateAnd(old, m_code.splat(int(kept))));
  }
  m_targets[target].store(place, pixels, 1, mask);
}

Value *PixelWriter::passedThrough(const FragmentColors &fragment, const Vec &color,
                                  const abi::ColorTargetKey &target) {
  for (const PackedTexel &texel : fragment.texels) {
    // For each byte of the pixel the texel's byte that it is; 4 + 0 where it is 0xFF.
    std::array<int, 4> from = {};
    bool same = texel.packed != nullptr;
    for (int k = 0; same && k < 4; ++k) {
      const int c = componentOf(target.format, k);
      if (c < 0) {
        from[std::size_t(k)] = 4;
        continue;
      }
      same = false;
      for (std::size_t t = 0; t < 4 && !same; ++t) {
        if (!color[std::size_t(c)] || texel.rgba[t] != color[std::size_t(c)])
          continue;
        const abi::From source = texel.swizzle[t];
        same = source != abi::From::Zero;
        from[std::size_t(k)] = source == abi::From::One ? 4 : int(source);
      }
    }
    if (!same)
      continue;
    if (from == std::array{0, 1, 2, 3})
      return texel.packed;
    llvm::IRBuilder<> &ir = m_code.ir;
    const auto bytes = unsigned(4 * m_code.lanes);
    auto *const type = llvm::FixedVectorType::get(ir.getInt8Ty(), bytes);
    std::vector<int> indices;
    for (unsigned i = 0; i < bytes; ++i) {
      const int k = from[i % 4];
      indices.push_back(k == 4 ? int(bytes + i) : int(i / 4 * 4) + k);
    }
    Value *const shuffled = ir.CreateShuffleVector(ir.CreateBitCast(texel.packed, type),
                                                   llvm::Constant::getAllOnesValue(type), indices);
    return ir.CreateBitCast(shuffled, m_code.i32);
  }
  return nullptr;
}

} // namespace arbiter::fp::llvm_back
