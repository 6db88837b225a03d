#pragma once
#include <optional>

#include "fp_compiler/back/llvm/pixel/pixel.h"

namespace arbiter::fp::llvm_back {

/// The stencil and depth tests, and what they write (4.1.5 and 4.1.6 of OpenGL 1.4, two-sided as
/// EXT_stencil_two_side has it).
class DepthStencil {
public:
  DepthStencil(Code &code, const abi::FragmentKey &key, const Places &places, Value *data,
               Interpolator &interpolator)
      : m_code(code), m_key(key.depthStencil), m_places(places), m_data(data),
        m_interpolator(interpolator) {}

  /// Whether there is anything to test or write.
  [[nodiscard]] bool active() const { return testsDepth() || testsStencil(); }
  /// In the item's block: its first pixel.
  void setPixel(Value *x, Value *y);
  /// \param depth the fragments', not clamped yet
  /// \param mask lanes that have come here; null: all covered ones
  /// \return lanes that pass both tests
  [[nodiscard]] Value *test(const PixelPlace &place, Value *depth, Value *mask);
  /// Whether a fragment that will not pass does nothing, and may be told before its program: there
  /// is a test of depths, and stencil values do not change.
  [[nodiscard]] bool foresees() const {
    return testsDepth() && !testsStencil() && m_key.depthCompare != abi::Compare::Always;
  }
  /// Of the covered lanes those whose depth passes now. Nothing is written. Requires: foresees().
  [[nodiscard]] Value *mayPass(const PixelPlace &place, Value *depth);

private:
  [[nodiscard]] bool testsDepth() const {
    return m_key.layout != abi::Layout::None && m_key.depthTest;
  }
  [[nodiscard]] bool testsStencil() const {
    return m_key.layout == abi::Layout::Depth24Stencil8 && m_key.stencilTest;
  }
  /// What the buffer has there, i32 a lane.
  [[nodiscard]] Value *stored(const PixelPlace &place);
  /// The lanes whose depth, as quantised() has it, passes against what stored() gives.
  [[nodiscard]] Value *passesStored(Value *incoming, Value *old);
  /// Fragment depth as the buffer keeps it: i32, or floats of Depth32F.
  [[nodiscard]] Value *quantised(Value *depth);
  /// The lanes whose depth passes against the buffer's, both as quantised() has them.
  [[nodiscard]] Value *passes(Value *incoming, Value *stored);
  /// Of each lane's side: a byte of a pair in FragmentData, in all lanes.
  [[nodiscard]] Value *ofSide(std::size_t offset);
  /// What a face's operations make of a stencil value.
  [[nodiscard]] Value *operated(abi::StencilOp op, Value *stencil);
  /// Of both sides' results that of each lane's.
  template <typename Make> Value *chosen(Make make);

  Code &m_code;
  const abi::DepthStencilKey &m_key;
  const Places &m_places;
  Value *m_data;
  Interpolator &m_interpolator;
  std::optional<PixelMemory> m_memory;
};

} // namespace arbiter::fp::llvm_back
