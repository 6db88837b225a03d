#include "fp_compiler/back/llvm/math/math.h"
#include "fp_compiler/back/llvm/sample/sample_parts.h"

#include <optional>

#include <llvm/IR/Intrinsics.h>

namespace arbiter::fp::llvm_back {
namespace {

/// Returns the texel of an incomplete texture (3.11.6 of ARB_fragment_program): (0, 0, 0, 1).
Vec incomplete(Code &code, unsigned needed) {
  Vec rgba = {};
  for (std::size_t i = 0; i < 4; ++i)
    if (needed >> i & 1)
      rgba[i] = code.splat(i == 3 ? 1.0f : 0.0f);
  return rgba;
}

/// Returns consecutive texels, loaded from `pointer` on.
Texel consecutive(Code &code, const abi::Format &format, Value *pointer, unsigned needed) {
  const unsigned bits = unsigned(abi::bytesOf(format.layout)) * 8;
  Value *const raw = code.ir.CreateAlignedLoad(
      llvm::FixedVectorType::get(code.ir.getIntNTy(bits), unsigned(code.lanes)), pointer,
      llvm::Align(1));
  Texel texel;
  texel.rgba = decode(code, format, raw, needed);
  if (abi::isPlainWord(format))
    texel.packed = raw;
  return texel;
}

/// Writes one lookup: selects the face, the levels and the filter.
class Sampling {
public:
  Sampling(Code &code, const abi::SamplerKey &key, abi::Lanes lanes, Value *view,
           const SampleAt &at, unsigned needed)
      : m_code(code), m_key(key), m_at(at), m_lookup{key, lanes, view, {}} {
    m_lookup.dimensions = dimensionsOf(key.dimension);
    m_lookup.coordinate = at.coordinate;
    m_lookup.needed = needed;
    m_format = key.format;
    if (key.dimension == abi::Dimension::Cube) {
      m_cube.emplace(code, at.coordinate);
      m_lookup.coordinate = m_cube->coordinate();
    }
  }
  void setShadow(Value *reference, int borderDepth) {
    m_lookup.reference = reference;
    m_lookup.borderDepth = borderDepth;
    m_format.swizzle = {abi::From::C0, abi::From::Zero, abi::From::Zero, abi::From::Zero};
    m_lookup.needed = 1;
  }

  Texel texel() {
    const bool mipmaps = m_key.mip != abi::MipFilter::None;
    if (!mipmaps && m_key.magnify == m_key.minify)
      return atLevel(nullptr, m_key.magnify);
    if (m_key.anisotropic && !m_at.lod) {
      const Derivatives d = derivativesOf(m_code, m_key, m_lookup.lanes, m_at);
      if (d.dx[0])
        return alongFootprint(d);
    }
    return byLevel(levelOfDetail(m_code, m_key, m_lookup.lanes, m_lookup.view, m_at, cube()));
  }

private:
  [[nodiscard]] const CubeFace *cube() const { return m_cube ? &*m_cube : nullptr; }

  Texel alongFootprint(const Derivatives &d) {
    const PixelFootprint footprint = footprintOf(m_code, m_key, m_lookup.view, m_at, d, cube());
    return meanOf(m_code, footprint.count, m_at.mask, [&](Value *place) {
      Vec moved = m_at.coordinate;
      for (std::size_t i = 0; i < 3; ++i)
        if (footprint.axis[i])
          moved[i] = multiplyAdd(m_code, place, footprint.axis[i], moved[i]);
      m_lookup.coordinate = moved;
      if (m_cube) // each sample may be on another face
        m_lookup.coordinate = m_cube.emplace(m_code, moved).coordinate();
      return byLevel(footprint.lambda);
    });
  }

  Texel byLevel(Value *lambda) {
    if (m_key.magnify == m_key.minify)
      return minified(lambda); // the base level has the same weight either way
    // Magnification ends at 0 for all filters, as in software hosts. OpenGL 2.1 (3.8.9) has 0.5 for
    // some filters, and 4.1 (3.9.12) leaves the choice to the implementation.
    Value *const magnified = m_code.ir.CreateFCmpOLE(lambda, m_code.splat(0.0f));
    return magnifiedOrMinified(magnified, lambda);
  }

  Texel magnifiedOrMinified(Value *magnified, Value *lambda) {
    const Texel big = where(magnified, [&] { return atLevel(nullptr, m_key.magnify); });
    const Texel small = where(m_code.ir.CreateNot(magnified), [&] { return minified(lambda); });
    Texel both;
    for (std::size_t i = 0; i < 4; ++i)
      if (big.rgba[i])
        both.rgba[i] = m_code.select(magnified, big.rgba[i], small.rgba[i]);
    if (big.packed && small.packed)
      both.packed = m_code.select(magnified, big.packed, small.packed);
    return both;
  }

  /// Returns the sample if any lane needs it, else zeros. Mostly all lanes of a row or block agree.
  Texel where(Value *wanted, const Sampled &sampled) {
    Texel zeros;
    return either(
        m_code, anyLane(m_code, wanted),
        [&] {
          const Texel texel = sampled();
          for (std::size_t i = 0; i < 4; ++i)
            zeros.rgba[i] = texel.rgba[i] ? m_code.splat(0.0f) : nullptr;
          zeros.packed = texel.packed ? m_code.splat(0) : nullptr;
          return texel;
        },
        [&] { return zeros; });
  }

  Texel minified(Value *lambda) {
    if (m_key.mip == abi::MipFilter::None)
      return atLevel(nullptr, m_key.minify);
    const LevelChoice levels = chooseLevels(m_code, m_key, m_lookup.view, lambda);
    const Texel first = atLevel(levels.first, m_key.minify);
    if (!levels.second)
      return first;
    Value *const between = m_code.ir.CreateFCmpOGT(levels.fraction, m_code.splat(0.0f));
    return either(
        m_code, anyLane(m_code, between),
        [&] {
          const Texel second = atLevel(levels.second, m_key.minify);
          if (filtersBytes(m_lookup))
            return mixBytes(m_code, m_lookup, first.packed, second.packed, levels.fraction);
          Texel mixed;
          for (std::size_t i = 0; i < 4; ++i)
            if (first.rgba[i])
              mixed.rgba[i] = lerp(m_code, first.rgba[i], second.rgba[i], levels.fraction);
          return mixed;
        },
        [&] { return first; });
  }

  /// \param level i32 lanes; null: the base level
  Texel atLevel(Value *level, abi::Filter filter) {
    Value *image = level;
    if (m_cube) {
      image = m_cube->face();
      if (level)
        image = m_code.ir.CreateAdd(image, m_code.ir.CreateMul(level, m_code.splat(6)));
    }
    const auto filtered = [&](Value *which) {
      m_lookup.image = loadImage(m_code, m_format, m_lookup.view, which, m_lookup.dimensions);
      return filter == abi::Filter::Nearest ? filterNearest(m_code, m_lookup)
                                            : filterLinear(m_code, m_lookup);
    };
    if (!image)
      return filtered(m_code.ir.getInt32(0));
    return forEachImage(m_code, image, m_at.mask, filtered);
  }

  Code &m_code;
  const abi::SamplerKey &m_key;
  const SampleAt &m_at;
  abi::Format m_format;
  std::optional<CubeFace> m_cube;
  Lookup m_lookup;
};

/// Returns a shadow lookup (3.8.14). The comparison's result takes the place of the depth in the
/// format's components.
Texel shadowLookup(Code &code, const abi::SamplerKey &key, abi::Lanes lanes, Value *view,
                   const SampleAt &at, unsigned needed) {
  int depthAt = -1;
  bool wanted = false;
  for (int i = 3; i >= 0; --i)
    if (key.format.swizzle[std::size_t(i)] == abi::From::C0) {
      depthAt = i;
      wanted |= needed >> i & 1;
    }
  Texel texel;
  if (wanted) {
    Sampling sampling(code, key, lanes, view, at, needed);
    // Fixed-point depth is compared with a reference clamped to its range.
    const bool fixed = key.format.layout != abi::Layout::Depth32F;
    sampling.setShadow(fixed ? code.saturate(at.coordinate[2]) : at.coordinate[2], depthAt);
    texel = sampling.texel();
  }
  Vec result = {};
  for (std::size_t i = 0; i < 4; ++i)
    if (needed >> i & 1)
      result[i] = key.format.swizzle[i] == abi::From::C0    ? texel.rgba[0]
                  : key.format.swizzle[i] == abi::From::One ? code.splat(1.0f)
                                                            : code.splat(0.0f);
  return {result};
}

} // namespace

Value *constantField(Code &code, llvm::Type *type, Value *pointer, std::size_t offset) {
  auto *const load = code.ir.CreateLoad(
      type, code.ir.CreateConstInBoundsGEP1_64(code.ir.getInt8Ty(), pointer, offset));
  load->setMetadata(llvm::LLVMContext::MD_invariant_load, llvm::MDNode::get(code.context(), {}));
  return load;
}

Value *anyLane(Code &code, Value *mask) { return code.ir.CreateOrReduce(mask); }
Value *allLanes(Code &code, Value *mask) { return code.ir.CreateAndReduce(mask); }

ImageCode loadImage(Code &code, const abi::Format &format, Value *view, Value *image,
                    int dimensions) {
  llvm::Type *const i32 = code.ir.getInt32Ty(), *const i64 = code.ir.getInt64Ty();
  Value *const levels =
      constantField(code, code.ir.getPtrTy(), view, offsetof(abi::TextureView, levels));
  Value *const at = code.ir.CreateMul(code.ir.CreateZExt(image, i64),
                                      code.ir.getInt64(sizeof(abi::TextureLevel)));
  Value *const level = code.ir.CreateGEP(code.ir.getInt8Ty(), levels, at);
  // Texel sizes are powers of two, and strides are multiples of them.
  const unsigned shift = llvm::Log2_32(unsigned(abi::bytesOf(format.layout)));
  const auto stride = [&](std::size_t offset) {
    return code.ir.CreateTrunc(code.ir.CreateAShr(constantField(code, i64, level, offset), shift),
                               i32);
  };
  ImageCode result;
  result.format = format;
  result.base = constantField(code, code.ir.getPtrTy(), level, offsetof(abi::TextureLevel, base));
  result.size[0] = constantField(code, i32, level, offsetof(abi::TextureLevel, width));
  if (dimensions > 1) {
    result.size[1] = constantField(code, i32, level, offsetof(abi::TextureLevel, height));
    result.stride[0] = stride(offsetof(abi::TextureLevel, rowStride));
  }
  if (dimensions > 2) {
    result.size[2] = constantField(code, i32, level, offsetof(abi::TextureLevel, depth));
    result.stride[1] = stride(offsetof(abi::TextureLevel, sliceStride));
  }
  return result;
}

Texel sample(Code &code, const abi::SamplerKey &key, abi::Lanes lanes, Value *view,
             const SampleAt &at, unsigned needed) {
  if (key.format.layout == abi::Layout::None)
    return {incomplete(code, needed)};
  if (at.texels)
    return consecutive(code, key.format, at.texels, needed);
  if (key.shadow)
    return shadowLookup(code, key, lanes, view, at, needed);
  Texel texel = Sampling(code, key, lanes, view, at, needed).texel();
  // A filter computes only the bytes that are needed.
  const bool isFiltered = key.magnify == abi::Filter::Linear || key.minify == abi::Filter::Linear ||
                          key.mip == abi::MipFilter::Linear;
  if (!abi::isPlainWord(key.format) || (isFiltered && bytesNeeded(key.format, needed) != 3))
    texel.packed = nullptr;
  return texel;
}

} // namespace arbiter::fp::llvm_back
