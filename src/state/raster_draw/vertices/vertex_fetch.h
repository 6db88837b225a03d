#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <GL/gl.h>

#include "fp_compiler/ir/interface.h"
#include "state/mirror/attributes.h"
#include "state/raster_draw/vertices/vertex_convert.h"

/// Fetches vertices in the form that machine code reads: one array of floats for each component.
/// Defaults (0, 0, 0, 1) are filled in, and fixed-point numbers are converted (OpenGL 1.4, table
/// 2.6).
namespace arbiter::state {

/// Indices as 32 bits, relative to `minimum`. The vertices to fetch are [minimum, maximum].
struct IndexRange {
  const std::uint32_t *indices = nullptr;
  std::uint32_t count = 0;
  std::uint32_t minimum = 0, maximum = 0; ///< baseVertex included
};

/// Positions in a draw's sequence of vertices: [begin, begin + count), after `pivot` if `pivots` is
/// set.
struct SequencePart {
  std::uint32_t begin = 0, count = 0;
  bool pivots = false;
  std::uint32_t pivot = 0;
};

struct IndexBounds {
  std::int64_t minimum = 0, maximum = 0;
};
/// Computes the bounds of `count` indices, at least one. Returns false for a type that DrawElements
/// does not allow.
[[nodiscard]] bool boundsOf(GLenum type, const void *indices, std::uint32_t count,
                            IndexBounds &bounds);

/// Fetches the vertices of a draw. Its memory belongs to a context, and is kept from draw to draw.
class VertexFetcher {
public:
  VertexFetcher();
  ~VertexFetcher();
  VertexFetcher(const VertexFetcher &) = delete;
  VertexFetcher &operator=(const VertexFetcher &) = delete;

  /// Converts indices. Returns false if there is no memory, or if an index plus `baseVertex` is
  /// below zero. `type` is as in DrawElements; `indices` need not be aligned.
  [[nodiscard]] bool decodeIndices(GLenum type, const void *indices, std::uint32_t count,
                                   std::int32_t baseVertex, IndexRange &out);

  /// Converts the indices of a part, which must not be empty. For a `type` of 0, the positions are
  /// the indices.
  [[nodiscard]] bool decodePart(GLenum type, const void *indices, const SequencePart &part,
                                std::int32_t baseVertex, IndexRange &out);

  /// True if indices name few vertices of a wide range, so that compact() pays.
  [[nodiscard]] static bool isSparse(const IndexRange &range);
  /// Copies the vertices of a sparse range together, in the order of the indices. `source` then
  /// refers to the copy, which is valid until the next call, and `range` counts its vertices.
  /// Returns false if there is no memory or a vertex is out of range.
  [[nodiscard]] bool compact(VertexSource &source, SlotMask slots, IndexRange &range);

  /// Fetches vertices [first, first + count) of the slots in a mask: from their arrays, or the
  /// current value for each. Returns false if there is no memory, a type is unknown, or a vertex is
  /// out of range. Constant arrays of current values are kept from draw to draw.
  [[nodiscard]] bool fetch(const VertexSource &source, const CurrentValues &current, SlotMask slots,
                           std::uint32_t first, std::uint32_t count);
  /// Prepares fetch() without reading the arrays; convert() reads them.
  [[nodiscard]] bool open(const VertexSource &source, const CurrentValues &current, SlotMask slots,
                          std::uint32_t first, std::uint32_t count);
  /// Fills vertices [begin, end) after open(). Several threads may call it for different vertices.
  void convert(std::uint32_t begin, std::uint32_t end) const;
  /// Fills a slot with a current value for every vertex of the last fetch(), in place of what was
  /// fetched. Returns false if there is no memory.
  [[nodiscard]] bool fetchCurrent(const std::array<float, 4> &value, int slot);
  /// Returns component c of a fetched slot: `count` floats aligned to 64 bytes. They may be read up
  /// to a multiple of 16.
  [[nodiscard]] const float *component(int slot, int c) const {
    return m_components[std::size_t(slot)][std::size_t(c)];
  }
  /// Returns VertexData::inputs for a program with these attributes, whose slots must have been
  /// fetched. Valid until the next call.
  [[nodiscard]] const float *const *inputs(std::span<const fp::ir::Attribute> attributes);
  /// Returns VertexData::outputs: four arrays for each of `count` outputs, as long as those of
  /// fetch(). Returns null if there is no memory. They are valid as long as outputsVersion() does
  /// not change.
  [[nodiscard]] float *const *outputs(std::size_t count);
  /// Returns a number that changes when outputs() gives different arrays.
  [[nodiscard]] std::uint32_t outputsVersion() const { return m_outputsVersion; }
  /// Returns the edge flags of unfilled polygons as bytes, after a fetch with kEdgeFlag.
  [[nodiscard]] const std::uint8_t *edgeFlags();

private:
  struct Block {
    float *data = nullptr;
    std::size_t floats = 0;
    Block() = default;
    Block(Block &&other) noexcept;
    Block &operator=(Block &&other) noexcept;
    ~Block();
    [[nodiscard]] bool reserve(std::size_t wanted);
  };
  /// An array whose elements all have the same value.
  struct Constant {
    Block block;
    float value = 0;
    std::uint32_t filled = 0;
  };
  [[nodiscard]] bool reserveIndices(std::uint32_t count);
  [[nodiscard]] const float *constant(Constant &constant, float value);
  [[nodiscard]] bool openArray(const VertexSource &source, int slot, std::uint32_t first);

  std::uint32_t m_count = 0, m_padded = 0;
  /// A pending conversion of one of the draw's arrays.
  struct Job {
    Convert convert;
    Conversion conversion;
  };
  std::array<Job, kSlots> m_jobs;
  unsigned m_jobCount = 0;
  std::array<std::array<const float *, 4>, kSlots> m_components{};
  std::array<std::array<Block, 4>, kSlots> m_blocks;
  std::array<std::array<Constant, 4>, kSlots> m_current;
  Constant m_zero, m_one;
  std::vector<const float *> m_inputs;
  std::vector<Block> m_outputBlocks;
  std::vector<float *> m_outputs;
  std::uint32_t m_outputFloats = 0; ///< least length of the arrays in m_outputs
  std::uint32_t m_outputsVersion = 0;
  std::vector<std::uint8_t> m_edgeFlags;
  std::unique_ptr<std::uint32_t[]> m_indices;
  std::size_t m_indexCapacity = 0;
  std::array<Block, kSlots> m_compacted;
};

/// Returns the slots of a program's attributes.
[[nodiscard]] SlotMask slotsOf(std::span<const fp::ir::Attribute> attributes);

} // namespace arbiter::state
