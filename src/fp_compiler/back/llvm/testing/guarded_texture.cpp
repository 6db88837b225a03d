#include "fp_compiler/back/llvm/testing/guarded_texture.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <new>

#include <sys/mman.h>
#include <unistd.h>

namespace arbiter::fp::llvm_back::testing {
namespace {

using abi::Layout;

/// Fills in a finite texel. Depth is often one of the ends, so that comparisons find equal values.
void fillTexel(Layout layout, std::uint8_t *texel, std::mt19937 &random) {
  const int bytes = abi::bytesOf(layout);
  const auto real = [&] { return std::uniform_real_distribution<float>(-2, 2)(random); };
  switch (layout) {
  case Layout::F32x1:
  case Layout::F32x2:
  case Layout::F32x4:
    for (int i = 0; i < bytes; i += 4) {
      const float value = real();
      std::memcpy(texel + i, &value, 4);
    }
    return;
  case Layout::Depth32F: {
    const float value = random() % 3 == 0 ? 1.0f : random() % 3 == 0 ? 0.0f : std::abs(real()) / 2;
    std::memcpy(texel, &value, 4);
    return;
  }
  case Layout::F16x1:
  case Layout::F16x2:
  case Layout::F16x4:
    for (int i = 0; i < bytes; i += 2) {
      // This includes some denormals. The maximum is 1.999.
      const auto half = std::uint16_t(random() & 0x8000) | std::uint16_t(random() % 0x4000);
      std::memcpy(texel + i, &half, 2);
    }
    return;
  default:
    break;
  }
  const bool depth = abi::isDepth(layout);
  const unsigned end = random() % 3;
  for (int i = 0; i < bytes; ++i)
    texel[i] = depth && end < 2 ? (end ? 0xFF : 0x00) : std::uint8_t(random());
}

} // namespace

GuardedMemory::GuardedMemory(std::size_t bytes, bool atEnd) {
  const auto page = std::size_t(sysconf(_SC_PAGESIZE));
  const std::size_t inner = (bytes + 2 * kSlack + page - 1) / page * page;
  m_mapped = inner + 2 * page;
  m_mapping = mmap(nullptr, m_mapped, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  auto *const open = static_cast<std::uint8_t *>(m_mapping) + page;
  if (m_mapping == MAP_FAILED || mprotect(open, inner, PROT_READ | PROT_WRITE))
    throw std::bad_alloc();
  m_data = atEnd ? open + inner - kSlack - bytes : open + kSlack;
}

GuardedMemory::~GuardedMemory() { munmap(m_mapping, m_mapped); }

GuardedTexture::GuardedTexture(const abi::SamplerKey &key, std::array<int, 3> size,
                               std::mt19937 &random) {
  const bool cube = key.dimension == abi::Dimension::Cube;
  const auto biggest = unsigned(std::max({size[0], size[1], size[2]}));
  view.levelCount = key.mip == abi::MipFilter::None ? 1 : int(std::bit_width(biggest));
  for (int level = 0; level < view.levelCount; ++level) {
    for (int face = 0; face < (cube ? 6 : 1); ++face)
      addImage(key, size, random);
    for (int &extent : size)
      extent = std::max(extent / 2, 1);
  }
  view.levels = m_levels.data();
  // The contract has the border colour after the format, so that components with the same source
  // are equal.
  float stored[4];
  for (float &component : stored)
    component = std::uniform_real_distribution<float>(0, 1)(random);
  for (std::size_t i = 0; i < 4; ++i) {
    const abi::From from = key.format.swizzle[i];
    view.borderColor[i] = from <= abi::From::C3 ? stored[int(from)] : float(from == abi::From::One);
  }
}

void GuardedTexture::addImage(const abi::SamplerKey &key, std::array<int, 3> size,
                              std::mt19937 &random) {
  const int bytes = abi::bytesOf(key.format.layout);
  if (!bytes) {
    m_levels.emplace_back();
    return;
  }
  const std::size_t texels = std::size_t(size[0]) * std::size_t(size[1]) * std::size_t(size[2]);
  m_memory.push_back(std::make_unique<GuardedMemory>(texels * std::size_t(bytes), random() % 2));
  std::uint8_t *const data = m_memory.back()->data();
  for (std::size_t i = 0; i < texels; ++i)
    fillTexel(key.format.layout, data + i * std::size_t(bytes), random);
  abi::TextureLevel level;
  level.width = size[0];
  level.height = size[1];
  level.depth = size[2];
  level.rowStride = std::int64_t(size[0]) * bytes;
  level.sliceStride = level.rowStride * size[1];
  level.base = data;
  if (random() % 2) { // the last row comes first
    level.base += level.rowStride * (size[1] - 1);
    level.rowStride = -level.rowStride;
  }
  m_levels.push_back(level);
}

} // namespace arbiter::fp::llvm_back::testing
