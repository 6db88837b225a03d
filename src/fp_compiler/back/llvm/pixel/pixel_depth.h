#pragma once
#include <optional>

#include "fp_compiler/back/llvm/pixel/pixel.h"

namespace arbiter::fp::llvm_back {

/// The stencil and depth tests and their writes (4.1.5 and 4.1.6 of OpenGL 1.4, two-sided as in
/// EXT_stencil_two_side).
class DepthStencil {
public:
  DepthStencil(Code &code, const abi::FragmentKey &key, const Places &places, Value *data,
               Interpolator &interpolator)
      : m_code(code), m_key(key.depthStencil), m_places(places), m_data(data),
        m_interpolator(interpolator) {}

  /// True if there is anything to test or write.
  [[nodiscard]] bool active() const { return testsDepth() || testsStencil(); }
  /// Sets the item's first pixel, in the item's block.
  void setPixel(Value *x, Value *y);
  /// \param depth the fragments' depth, not clamped yet
  /// \param mask lanes still alive; null: all covered ones
  /// \return lanes that pass both tests
  [[nodiscard]] Value *test(const PixelPlace &place, Value *depth, Value *mask);
  /// True if a failing fragment has no effect, so that mayPass() can be asked before its program.
  /// The depth test must be enabled, and stencil values must not change.
  [[nodiscard]] bool foresees() const {
    return testsDepth() && !testsStencil() && m_key.depthCompare != abi::Compare::Always;
  }
  /// Returns the covered lanes whose depth currently passes. Writes nothing. Requires: foresees().
  [[nodiscard]] Value *mayPass(const PixelPlace &place, Value *depth);

private:
  [[nodiscard]] bool testsDepth() const {
    return m_key.layout != abi::Layout::None && m_key.depthTest;
  }
  [[nodiscard]] bool testsStencil() const {
    return m_key.layout == abi::Layout::Depth24Stencil8 && m_key.stencilTest;
  }
  /// Returns the buffer's value, one i32 in each lane.
  [[nodiscard]] Value *stored(const PixelPlace &place);
  /// Returns the lanes whose quantised() depth passes against the result of stored().
  [[nodiscard]] Value *passesStored(Value *incoming, Value *old);
  /// Returns fragment depth as the buffer stores it: i32, or floats for Depth32F.
  [[nodiscard]] Value *quantised(Value *depth);
  /// Returns the lanes whose depth passes against the buffer's, both in the form of quantised().
  [[nodiscard]] Value *passes(Value *incoming, Value *stored);
  /// Returns a byte of a pair in FragmentData, selected by each lane's facing.
  [[nodiscard]] Value *ofSide(std::size_t offset);
  /// Returns the result of a stencil operation.
  [[nodiscard]] Value *operated(abi::StencilOp op, Value *stencil);
  /// Returns the result for each lane's facing, selected from the results of both faces.
  template <typename Make> Value *chosen(Make make);

  Code &m_code;
  const abi::DepthStencilKey &m_key;
  const Places &m_places;
  Value *m_data;
  Interpolator &m_interpolator;
  std::optional<PixelMemory> m_memory;
};

} // namespace arbiter::fp::llvm_back
