#pragma once
#include "fp_compiler/back/llvm/pixel/interpolate.h"

/// Access to the lanes' pixels in a buffer. No byte outside the item's pixels is read or written.
namespace arbiter::fp::llvm_back {

/// The pixels of the lanes in the current loop.
struct PixelPlace {
  abi::Lanes lanes = abi::Lanes::Row;
  Value *column = nullptr;    ///< Row: column of lane 0 in the item, i32
  Value *remaining = nullptr; ///< Row: pixels of the item from lane 0 on, i32
  /// Lanes that are pixels of the item; for Row those below `remaining`.
  Value *covered = nullptr;
  Value *dx = nullptr, *dy = nullptr; ///< Packed: pixels relative to the item's first one, i32
};

/// A colour or depth buffer.
class PixelMemory {
public:
  /// Computes the address of the item's first pixel, in the item's block.
  /// \param target offset of the abi::Target in abi::FragmentData
  PixelMemory(Code &code, const Places &places, Value *data, std::size_t target, int pixelBytes,
              Value *x, Value *y);

  /// Loads `parts` elements of \p type for each pixel, as a vector of lanes * parts in memory
  /// order. Lanes outside the item hold zeros.
  [[nodiscard]] Value *load(const PixelPlace &place, llvm::Type *type, int parts);
  /// \param mask lanes to write, or null for all covered ones
  void store(const PixelPlace &place, Value *value, int parts, Value *mask);

  /// Row: prefetches the row above, which is written next.
  void prefetch(const PixelPlace &place);

private:
  /// Packed: returns the addresses of one part of each lane's pixel.
  [[nodiscard]] Value *lanePointers(const PixelPlace &place, int part, int bytes);
  /// Extract part \p part of all lanes, and insert it again into a vector of all parts.
  [[nodiscard]] Value *strided(Value *vector, int part, int parts);
  [[nodiscard]] Value *interleaved(Value *vector, Value *lanes, int part, int parts);
  [[nodiscard]] Value *rowPointer(const PixelPlace &place, int row);
  /// Repeats each lane of the mask `parts` times.
  [[nodiscard]] Value *widened(Value *mask, int parts);
  /// Returns elements [begin, begin + count) of a vector.
  [[nodiscard]] Value *slice(Value *vector, int begin, int count);
  /// Concatenates \p a and \p b. \p b must not be longer than \p a.
  [[nodiscard]] Value *joined(Value *a, Value *b);

  Code &m_code;
  int m_pixelBytes;
  Value *m_first, *m_stride;
};

} // namespace arbiter::fp::llvm_back
