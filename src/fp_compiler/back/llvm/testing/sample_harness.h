#pragma once
#include <memory>
#include <optional>
#include <string>

#include "fp_compiler/back/llvm/code/code.h"
#include "fp_compiler/back/llvm/engine/linked.h"

/// Compiles functions that only call sample(), for its tests and its benchmark.
namespace arbiter::fp::llvm_back::testing {

/// The function's arguments. Arrays have the length of all chunks together.
struct SampleCall {
  const abi::TextureView *view = nullptr;
  const float *coordinate[3] = {};
  const float *bias = nullptr;
  float dx[3] = {}, dy[3] = {}; ///< for Lanes::Row
  const std::uint8_t *texels = nullptr;
  float *result[4] = {};
  std::uint32_t *packed = nullptr;
};

/// Compile-time options beside the sampler.
struct SampleOptions {
  abi::Lanes lanes = abi::Lanes::Row;
  bool bias = false;
  bool lod = false;         ///< SampleCall::bias holds TXL's levels of detail
  bool derivatives = false; ///< for Lanes::Row
  bool mask = false;        ///< only lanes whose first coordinate is not NaN are needed
  bool texels = false;      ///< reads SampleCall::texels consecutively
  unsigned needed = 0xF;
  bool onlyPacked = false; ///< stores only `packed`
};

class SampleFunction {
public:
  /// Returns the function, or null, with a reason, if it does not compile.
  static std::unique_ptr<SampleFunction> make(const Cpu &cpu, const abi::SamplerKey &key,
                                              const SampleOptions &options, std::string &reason);
  /// \param chunks number of vectors of pixels
  void operator()(const SampleCall &call, std::uint32_t chunks) const {
    reinterpret_cast<void (*)(const SampleCall *, std::uint32_t)>(m_linked->entry())(&call, chunks);
  }
  [[nodiscard]] bool hasPacked() const { return m_packed; }
  /// Returns the assembly text, for people to read.
  static std::string assembly(const Cpu &cpu, const abi::SamplerKey &key,
                              const SampleOptions &options);

private:
  std::unique_ptr<Linked> m_linked;
  bool m_packed = false;
};

} // namespace arbiter::fp::llvm_back::testing
