#pragma once
#include <memory>
#include <optional>
#include <string>

#include "fp_compiler/back/llvm/code/code.h"
#include "fp_compiler/back/llvm/engine/linked.h"

/// Machine code of nothing but sample(), for its tests and its benchmark.
namespace arbiter::fp::llvm_back::testing {

/// What the function is called with. Arrays are as long as all chunks together.
struct SampleCall {
  const abi::TextureView *view = nullptr;
  const float *coordinate[3] = {};
  const float *bias = nullptr;
  float dx[3] = {}, dy[3] = {}; ///< of Lanes::Row
  const std::uint8_t *texels = nullptr;
  float *result[4] = {};
  std::uint32_t *packed = nullptr;
};

/// What is known when the code is made, beside the sampler.
struct SampleOptions {
  abi::Lanes lanes = abi::Lanes::Row;
  bool bias = false;
  bool lod = false;         ///< SampleCall::bias has levels of detail, TXL's
  bool derivatives = false; ///< of Lanes::Row
  bool mask = false;        ///< only lanes whose first coordinate is not NaN count
  bool texels = false;      ///< SampleCall::texels is read, consecutively
  unsigned needed = 0xF;
  bool onlyPacked = false; ///< stores nothing but `packed`
};

class SampleFunction {
public:
  /// Null, with a reason, if it does not compile.
  static std::unique_ptr<SampleFunction> make(const Cpu &cpu, const abi::SamplerKey &key,
                                              const SampleOptions &options, std::string &reason);
  /// \param chunks of as many pixels as the processor has lanes
  void operator()(const SampleCall &call, std::uint32_t chunks) const {
    reinterpret_cast<void (*)(const SampleCall *, std::uint32_t)>(m_linked->entry())(&call, chunks);
  }
  [[nodiscard]] bool hasPacked() const { return m_packed; }
  /// The code as text, for a person.
  static std::string assembly(const Cpu &cpu, const abi::SamplerKey &key,
                              const SampleOptions &options);

private:
  std::unique_ptr<Linked> m_linked;
  bool m_packed = false;
};

} // namespace arbiter::fp::llvm_back::testing
