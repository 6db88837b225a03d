#pragma once
#include <array>
#include <cstdint>

#include <GL/gl.h>

namespace arbiter::state {

/// Material, or BindTexture.
struct StateCommand {
  GLenum target = 0; ///< the face, or the texture's target
  GLenum pname = 0;  ///< of Material; 0: BindTexture
  GLuint texture = 0;
  std::array<GLfloat, 4> values{};

  /// Not an error (OpenGL 2.1, 2.14.2 and 3.8.12).
  [[nodiscard]] bool isValid() const;
};
/// How many values Material takes for that name; 0: a name that a list does not keep.
[[nodiscard]] int materialValues(GLenum pname);

/// What a list has set so far, whatever was before it was called.
class KnownState {
public:
  /// False: it is set already.
  [[nodiscard]] bool set(const StateCommand &command);
  /// Another command may have set it.
  void forget() { m_materials = m_textures = 0; }
  /// A colour was given, which is the material's where COLOR_MATERIAL is enabled (OpenGL 2.1,
  /// 2.14.3).
  void forgetMaterials() { m_materials = 0; }

private:
  static constexpr int kMaterials = 5, kTargets = 5;
  [[nodiscard]] bool setMaterial(const StateCommand &command);
  [[nodiscard]] bool setTexture(const StateCommand &command);

  std::uint32_t m_materials = 0, m_textures = 0; ///< known ones, one bit each
  std::array<std::array<GLfloat, 4>, std::size_t(2 * kMaterials)> m_values{};
  std::array<GLuint, std::size_t(kTargets)> m_names{};
};

} // namespace arbiter::state
