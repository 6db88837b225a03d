#include "state/core/texture_names.h"

namespace arbiter::state {

TextureNames textureNames(fp::ir::TexTarget target) {
  using fp::ir::TexTarget;
  switch (target) {
  case TexTarget::Tex1D:
  case TexTarget::Shadow1D:
    return {GL_TEXTURE_1D, GL_TEXTURE_1D};
  case TexTarget::Tex2D:
  case TexTarget::Shadow2D:
    return {GL_TEXTURE_2D, GL_TEXTURE_2D};
  case TexTarget::Tex3D:
    return {GL_TEXTURE_3D, GL_TEXTURE_3D};
  case TexTarget::Cube:
    return {GL_TEXTURE_CUBE_MAP, GL_TEXTURE_CUBE_MAP_POSITIVE_X};
  case TexTarget::Rect:
  case TexTarget::ShadowRect:
    return {GL_TEXTURE_RECTANGLE, GL_TEXTURE_RECTANGLE};
  }
  return {};
}

} // namespace arbiter::state
