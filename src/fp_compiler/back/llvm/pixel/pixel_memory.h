#pragma once
#include "fp_compiler/back/llvm/pixel/interpolate.h"

/// Pixels of the lanes in a buffer. No byte outside of the item's pixels is read or written.
namespace arbiter::fp::llvm_back {

/// Which pixels the lanes are, while a loop is written.
struct PixelPlace {
  abi::Lanes lanes = abi::Lanes::Row;
  Value *column = nullptr;    ///< Row: of lane 0 in the item, i32
  Value *remaining = nullptr; ///< Row: pixels of the item from lane 0 on, i32
  /// Lanes that are pixels of the item; of Row those below `remaining`.
  Value *covered = nullptr;
  Value *dx = nullptr, *dy = nullptr; ///< Packed: lanes' pixels from the item's first one, i32
};

/// A colour or depth buffer.
class PixelMemory {
public:
  /// In the item's block: where the item's first pixel lies.
  /// \param target offset of the abi::Target in abi::FragmentData
  PixelMemory(Code &code, const Places &places, Value *data, std::size_t target, int pixelBytes,
              Value *x, Value *y);

  /// `parts` elements of \p type a pixel, those of a pixel next to each other: a vector of
  /// lanes * parts. Lanes that are no pixels of the item hold zeros.
  [[nodiscard]] Value *load(const PixelPlace &place, llvm::Type *type, int parts);
  /// \param mask lanes to write, or null for all covered ones
  void store(const PixelPlace &place, Value *value, int parts, Value *mask);

  /// Row: asks for the pixels above, which will be written next.
  void prefetch(const PixelPlace &place);

private:
  /// Packed: where each lane's part lies.
  [[nodiscard]] Value *lanePointers(const PixelPlace &place, int part, int bytes);
  /// Part \p part of all lanes; and back again into a vector of all parts.
  [[nodiscard]] Value *strided(Value *vector, int part, int parts);
  [[nodiscard]] Value *interleaved(Value *vector, Value *lanes, int part, int parts);
  [[nodiscard]] Value *rowPointer(const PixelPlace &place, int row);
  /// Each of the mask's lanes `parts` times.
  [[nodiscard]] Value *widened(Value *mask, int parts);
  /// Elements [begin, begin + count) of a vector.
  [[nodiscard]] Value *slice(Value *vector, int begin, int count);
  /// \p a and behind it \p b, which is no longer.
  [[nodiscard]] Value *joined(Value *a, Value *b);

  Code &m_code;
  int m_pixelBytes;
  Value *m_first, *m_stride;
};

} // namespace arbiter::fp::llvm_back
