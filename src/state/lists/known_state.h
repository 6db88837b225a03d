#pragma once
#include <array>
#include <cstdint>

#include <GL/gl.h>

namespace arbiter::state {

/// A Material or BindTexture command.
struct StateCommand {
  GLenum target = 0; ///< the face, or the texture target
  GLenum pname = 0;  ///< Material's parameter; 0: BindTexture
  GLuint texture = 0;
  std::array<GLfloat, 4> values{};

  /// True if the command is no error (OpenGL 2.1, 2.14.2 and 3.8.12).
  [[nodiscard]] bool isValid() const;
};
/// Returns how many values Material takes for that name; 0 for a name that lists do not keep.
[[nodiscard]] int materialValues(GLenum pname);

/// State that a list has set so far, whatever the state was before its call.
class KnownState {
public:
  /// Sets the state. Returns false if it was set to that already.
  [[nodiscard]] bool set(const StateCommand &command);
  /// Forgets everything, as another command may have set it.
  void forget() { m_materials = m_textures = 0; }
  /// Forgets materials, as a colour was given. It sets the material if COLOR_MATERIAL is enabled
  /// (OpenGL 2.1, 2.14.3).
  void forgetMaterials() { m_materials = 0; }

private:
  static constexpr int kMaterials = 5, kTargets = 5;
  [[nodiscard]] bool setMaterial(const StateCommand &command);
  [[nodiscard]] bool setTexture(const StateCommand &command);

  std::uint32_t m_materials = 0, m_textures = 0; ///< known state, one bit each
  std::array<std::array<GLfloat, 4>, std::size_t(2 * kMaterials)> m_values{};
  std::array<GLuint, std::size_t(kTargets)> m_names{};
};

} // namespace arbiter::state
