#pragma once
#include <memory>
#include <random>
#include <vector>

#include "fp_compiler/abi.h"

namespace arbiter::fp::llvm_back::testing {

/// Memory between inaccessible pages. Its data begin, or end, exactly `kSlack` bytes from such a
/// page.
class GuardedMemory {
public:
  static constexpr std::size_t kSlack = 64; ///< bytes that abi.h allows to be read
  GuardedMemory(std::size_t bytes, bool atEnd);
  ~GuardedMemory();
  GuardedMemory(const GuardedMemory &) = delete;
  GuardedMemory &operator=(const GuardedMemory &) = delete;
  [[nodiscard]] std::uint8_t *data() const { return m_data; }

private:
  void *m_mapping = nullptr;
  std::size_t m_mapped = 0;
  std::uint8_t *m_data = nullptr;
};

/// A texture with random texels in all levels and faces, each in guarded memory. Some images are
/// upside down.
class GuardedTexture {
public:
  GuardedTexture(const abi::SamplerKey &key, std::array<int, 3> size, std::mt19937 &random);
  abi::TextureView view;

private:
  void addImage(const abi::SamplerKey &key, std::array<int, 3> size, std::mt19937 &random);
  std::vector<std::unique_ptr<GuardedMemory>> m_memory;
  std::vector<abi::TextureLevel> m_levels;
};

} // namespace arbiter::fp::llvm_back::testing
