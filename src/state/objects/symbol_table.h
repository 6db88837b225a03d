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

/// A symbol of GenSymbolsEXT or a Bind...ParameterEXT. It is immutable except for its value, which
/// contexts of a share group set and read without a lock, as for a local parameter.
struct VertexSymbol {
  using DataType = fp::vertex_shader::DataType;

  /// A GL value that the symbol follows and that is no row of state in program languages.
  enum class Follows : std::uint8_t { Nothing, SpotCutoff, ColorMatrix };

  fp::vertex_shader::Symbol meaning; ///< without a constant's value, and without its block
  GLenum storage = GL_LOCAL_EXT;     ///< VARIANT_EXT to LOCAL_EXT
  bool normalized = false;           ///< NORMALIZED_RANGE_EXT
  bool bound = false;                ///< true if its value is a GL parameter
  Follows follows = Follows::Nothing;
  GLuint light = 0;                    ///< for SpotCutoff
  GLuint first = 0, count = 1;         ///< the block of names that it belongs to
  std::array<LocalParameter, 4> value; ///< the rows of an invariant or a local constant

  [[nodiscard]] DataType type() const { return meaning.type; }
  [[nodiscard]] int rows() const { return fp::vertex_shader::rowCount(meaning.type); }
  /// True if GenSymbolsEXT created it, with this storage type.
  [[nodiscard]] bool isOwn(GLenum ofStorage) const { return !bound && storage == ofStorage; }
};

/// The symbols of a share group, by name. A name means the same in all shaders, but each shader has
/// its own locals.
class VertexSymbolTable {
public:
  /// The generic attributes for variants, in the order in which they are used. It begins with those
  /// that no GL parameter is bound to, for hosts on which generic and conventional attributes
  /// alias.
  static constexpr std::array<std::uint8_t, 15> kAttributes = {6,  7,  1,  5, 4, 15, 14, 13,
                                                               12, 11, 10, 9, 8, 2,  3};
  /// Smaller names are outputs of shaders (OUTPUT_VERTEX_EXT and on).
  static constexpr GLuint kFirstName = 0x10000;
  static constexpr GLuint kMaxSymbols = 1u << 20;

  /// Creates `count` consecutive symbols. Returns the first name, or 0 if there are too many.
  [[nodiscard]] GLuint generate(const VertexSymbol &kind, GLuint count);
  /// Returns the name of a GL parameter, always the same for a key.
  [[nodiscard]] GLuint bind(const VertexSymbol &kind, const std::array<GLenum, 3> &key);
  /// Returns the symbol of that name, or null.
  [[nodiscard]] std::shared_ptr<VertexSymbol> find(GLuint name);

  /// Returns a number that counts changes of invariants' values.
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
