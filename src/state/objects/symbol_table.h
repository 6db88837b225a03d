#pragma once
#include <array>
#include <atomic>
#include <map>
#include <memory>
#include <mutex>
#include <unordered_map>

#include <GL/gl.h>
#include <GL/glext.h>

#include "fp_compiler/vertex_shader/shader.h"
#include "state/objects/program_object.h"

namespace arbiter::state {

/// A name that GenSymbolsEXT or one of the Bind...ParameterEXT gave. Immutable but for its value,
/// which contexts of a share group may set and read without a lock, as a local parameter's.
struct VertexSymbol {
  using DataType = fp::vertex_shader::DataType;

  /// What a value follows that no row of state of the program languages has.
  enum class Follows : std::uint8_t { Nothing, SpotCutoff, ColorMatrix };

  fp::vertex_shader::Symbol meaning; ///< without a constant's value, and without its block
  GLenum storage = GL_LOCAL_EXT;     ///< VARIANT_EXT to LOCAL_EXT
  bool normalized = false;           ///< NORMALIZED_RANGE_EXT
  bool bound = false;                ///< its value is one of GL's
  Follows follows = Follows::Nothing;
  GLuint light = 0;                    ///< of SpotCutoff
  GLuint first = 0, count = 1;         ///< the block of names that it is in
  std::array<LocalParameter, 4> value; ///< the rows of an invariant or a local constant

  [[nodiscard]] DataType type() const { return meaning.type; }
  [[nodiscard]] int rows() const { return fp::vertex_shader::rowCount(meaning.type); }
  /// GenSymbolsEXT made it, for values of this storage type.
  [[nodiscard]] bool isOwn(GLenum ofStorage) const { return !bound && storage == ofStorage; }
};

/// The symbols of a share group, by name. A name stands for the same in all shaders; each shader
/// has locals of its own.
class VertexSymbolTable {
public:
  /// The generic attributes that variants have, in the order in which they are given: on hosts on
  /// which generic and conventional attributes are one, those first that no parameter is bound to.
  static constexpr std::array<std::uint8_t, 15> kAttributes = {6,  7,  1,  5, 4, 15, 14, 13,
                                                               12, 11, 10, 9, 8, 2,  3};
  /// Names that are outputs of shaders (OUTPUT_VERTEX_EXT and on) are no symbols'.
  static constexpr GLuint kFirstName = 0x10000;
  static constexpr GLuint kMostSymbols = 1u << 20;

  /// `count` symbols in a row; the name of the first, or 0 if there are too many.
  [[nodiscard]] GLuint generate(const VertexSymbol &kind, GLuint count);
  /// The name of a parameter of GL's, the same for each key.
  [[nodiscard]] GLuint bind(const VertexSymbol &kind, const std::array<GLenum, 3> &key);
  /// Null if there is none of that name.
  [[nodiscard]] std::shared_ptr<VertexSymbol> find(GLuint name);

  /// Counts changes of invariants' values.
  [[nodiscard]] std::uint64_t version() const { return m_version.load(std::memory_order_acquire); }
  void valueChanged() { m_version.fetch_add(1, std::memory_order_release); }

private:
  [[nodiscard]] GLuint add(const VertexSymbol &kind, GLuint count);

  std::mutex m_mutex;
  std::unordered_map<GLuint, std::shared_ptr<VertexSymbol>> m_symbols;
  std::map<std::array<GLenum, 3>, GLuint> m_bound;
  GLuint m_next = kFirstName;
  std::size_t m_nextAttribute = 0;
  std::atomic<std::uint64_t> m_version{1};
};

} // namespace arbiter::state
