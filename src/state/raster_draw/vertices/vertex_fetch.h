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

/// Vertices as machine code reads them: one array of floats for each component, with defaults
/// (0, 0, 0, 1) filled in and fixed-point numbers converted (OpenGL 1.4, table 2.6).
namespace arbiter::state::software {

/// Indices as 32 bits, less `minimum`, so that the vertex range [minimum, maximum] is what must be
/// fetched.
struct IndexRange {
  const std::uint32_t *indices = nullptr;
  std::uint32_t count = 0;
  std::uint32_t minimum = 0, maximum = 0; ///< baseVertex added
};

/// Places in a draw's sequence of vertices: [begin, begin + count), with `pivot` before them where
/// that is set.
struct SequencePart {
  std::uint32_t begin = 0, count = 0;
  bool pivots = false;
  std::uint32_t pivot = 0;
};

struct IndexBounds {
  std::int64_t minimum = 0, maximum = 0;
};
/// Of `count` indices, at least one; false for a type that DrawElements does not have.
[[nodiscard]] bool boundsOf(GLenum type, const void *indices, std::uint32_t count,
                            IndexBounds &bounds);

/// Memory of a context for the vertices of one draw; grows and is kept.
class VertexFetcher {
public:
  VertexFetcher();
  ~VertexFetcher();
  VertexFetcher(const VertexFetcher &) = delete;
  VertexFetcher &operator=(const VertexFetcher &) = delete;

  /// False if there is no memory, or an index plus `baseVertex` is below zero. `type` is that of
  /// DrawElements; `indices` need not be aligned.
  [[nodiscard]] bool decodeIndices(GLenum type, const void *indices, std::uint32_t count,
                                   std::int32_t baseVertex, IndexRange &out);

  /// The same of a part of them, which is not empty; a `type` of 0: the places are the indices.
  [[nodiscard]] bool decodePart(GLenum type, const void *indices, const SequencePart &part,
                                std::int32_t baseVertex, IndexRange &out);

  /// Indices name few vertices of a wide range: compact() pays.
  [[nodiscard]] static bool isSparse(const IndexRange &range);
  /// Of a sparse range: copies its vertices of the slots' arrays together, in the order of the
  /// indices, and makes `range` count them. `source` is then another one, valid until the next
  /// call. False: no memory, or a vertex is not there.
  [[nodiscard]] bool compact(VertexSource &source, SlotMask slots, IndexRange &range);

  /// Fetches vertices [first, first + count) of the slots of a mask: from their arrays, or the
  /// current value for each. False if there is no memory, a type is unknown, or a vertex is not
  /// there. Float arrays of the current value are kept from draw to draw.
  [[nodiscard]] bool fetch(const VertexSource &source, const CurrentValues &current, SlotMask slots,
                           std::uint32_t first, std::uint32_t count);
  /// The same, but nothing is read of the arrays yet: convert() does it.
  [[nodiscard]] bool open(const VertexSource &source, const CurrentValues &current, SlotMask slots,
                          std::uint32_t first, std::uint32_t count);
  /// Fills in [begin, end) of the vertices that open() was called for. Threads may call it at a
  /// time, for vertices of their own.
  void convert(std::uint32_t begin, std::uint32_t end) const;
  /// The current value of a slot for every vertex of the last fetch(), whatever it fetched for it:
  /// component() gives it. False if there is no memory.
  [[nodiscard]] bool fetchCurrent(const std::array<float, 4> &value, int slot);
  /// Component c of a fetched slot: `count` floats, padded to a multiple of 16 that may be read;
  /// aligned to 64 bytes.
  [[nodiscard]] const float *component(int slot, int c) const {
    return m_components[std::size_t(slot)][std::size_t(c)];
  }
  /// VertexData::inputs of a program that reads `attributes`; all of their slots were fetched.
  /// Valid until the next call.
  [[nodiscard]] const float *const *inputs(std::span<const fp::ir::Attribute> attributes);
  /// VertexData::outputs: four arrays for each of `count` outputs, of as many floats as fetch()
  /// made. Null if there is no memory. Valid until the next call that outputsVersion() counts.
  [[nodiscard]] float *const *outputs(std::size_t count);
  /// Moves on when outputs() gives other arrays than before.
  [[nodiscard]] std::uint32_t outputsVersion() const { return m_outputsVersion; }
  /// The edge flags of unfilled polygons as bytes, after a fetch with kEdgeFlag.
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
  /// An array that holds one value throughout.
  struct Constant {
    Block block;
    float value = 0;
    std::uint32_t filled = 0;
  };
  [[nodiscard]] bool reserveIndices(std::uint32_t count);
  [[nodiscard]] const float *constant(Constant &constant, float value);
  [[nodiscard]] bool openArray(const VertexSource &source, int slot, std::uint32_t first);

  std::uint32_t m_count = 0, m_padded = 0;
  /// What is to be done for the arrays of the draw.
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
  std::uint32_t m_outputFloats = 0; ///< that each of m_outputs has at least
  std::uint32_t m_outputsVersion = 0;
  std::vector<std::uint8_t> m_edgeFlags;
  std::unique_ptr<std::uint32_t[]> m_indices;
  std::size_t m_indexCapacity = 0;
  std::array<Block, kSlots> m_compacted;
};

/// The slots that a program's attributes need.
[[nodiscard]] SlotMask slotsOf(std::span<const fp::ir::Attribute> attributes);

} // namespace arbiter::state::software
