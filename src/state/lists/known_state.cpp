#include "state/lists/known_state.h"

#include <algorithm>

#include <GL/glext.h>

#include "util/numbers/same_bits.h"

namespace arbiter::state {

namespace {

constexpr std::array<GLenum, 5> kTargetNames = {GL_TEXTURE_1D, GL_TEXTURE_2D, GL_TEXTURE_3D,
                                                GL_TEXTURE_CUBE_MAP, GL_TEXTURE_RECTANGLE};
/// The names of Material; AMBIENT_AND_DIFFUSE is the first two.
constexpr std::array<GLenum, 5> kMaterialNames = {GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION,
                                                  GL_SHININESS};

/// Returns a bit for each material parameter that the name sets; 0 for other names.
unsigned parametersOf(GLenum pname) {
  if (pname == GL_AMBIENT_AND_DIFFUSE)
    return 3;
  const auto *const found = std::find(kMaterialNames.begin(), kMaterialNames.end(), pname);
  return found == kMaterialNames.end() ? 0 : 1u << (found - kMaterialNames.begin());
}

/// Returns the parameters of the face: the front's bits, then the back's; 0 for other faces.
unsigned facesOf(GLenum face, unsigned parameters) {
  const unsigned back = parameters << kMaterialNames.size();
  switch (face) {
  case GL_FRONT:
    return parameters;
  case GL_BACK:
    return back;
  case GL_FRONT_AND_BACK:
    return parameters | back;
  default:
    return 0;
  }
}

} // namespace

int materialValues(GLenum pname) {
  return parametersOf(pname) == 0 ? 0 : pname == GL_SHININESS ? 1 : 4;
}

bool StateCommand::isValid() const {
  if (pname == 0)
    return std::find(kTargetNames.begin(), kTargetNames.end(), target) != kTargetNames.end();
  const bool inRange = pname != GL_SHININESS || (values[0] >= 0 && values[0] <= 128);
  return inRange && facesOf(target, parametersOf(pname)) != 0;
}

bool KnownState::setMaterial(const StateCommand &command) {
  const unsigned slots = facesOf(command.target, parametersOf(command.pname));
  bool changes = false;
  for (unsigned slot = 0; slot < m_values.size(); ++slot) {
    if ((slots >> slot & 1u) == 0)
      continue;
    changes =
        changes || (m_materials >> slot & 1u) == 0 || !sameBits(m_values[slot], command.values);
    m_values[slot] = command.values;
  }
  m_materials |= slots;
  return changes;
}

bool KnownState::setTexture(const StateCommand &command) {
  const auto *const found = std::find(kTargetNames.begin(), kTargetNames.end(), command.target);
  const auto at = std::size_t(found - kTargetNames.begin());
  const bool changes = (m_textures >> at & 1u) == 0 || m_names[at] != command.texture;
  m_names[at] = command.texture;
  m_textures |= 1u << at;
  return changes;
}

bool KnownState::set(const StateCommand &command) {
  return command.pname == 0 ? setTexture(command) : setMaterial(command);
}

} // namespace arbiter::state
