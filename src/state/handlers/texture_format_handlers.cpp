// Queries of textures with internal formats of NV_texture_shader, and scales and biases of their
// components.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/errors.h"
#include "state/imaging/imaging_state.h"
#include "state/lists/list_compiler.h"
#include "state/pixel_commands/imaging_commands.h"
#include "state/programs/program_bind.h"
#include "state/programs/texture_shaders/component_formats.h"
#include "state/programs/texture_shaders/component_image.h"
#include "state/programs/texture_shaders/texture_shader_commands.h"
#include "state/programs/texture_shaders/texture_shader_state.h"

namespace arbiter::state {

namespace {

/// Returns the row of ComponentFormat::bits for the name of a size; -1 for other names.
int sizeRow(GLenum pname) {
  switch (pname) {
  case GL_TEXTURE_RED_SIZE:
    return 0;
  case GL_TEXTURE_GREEN_SIZE:
    return 1;
  case GL_TEXTURE_BLUE_SIZE:
    return 2;
  case GL_TEXTURE_ALPHA_SIZE:
    return 3;
  case GL_TEXTURE_LUMINANCE_SIZE:
    return 4;
  case GL_TEXTURE_INTENSITY_SIZE:
    return 5;
  default:
    break;
  }
  const GLenum at = pname - GL_TEXTURE_HI_SIZE_NV;
  return at < 5 ? int(6 + at) : -1;
}

/// Gets a value of a level that the host does not know. Returns false for other names.
bool levelValue(Context &context, GLenum target, GLint level, GLenum pname, GLint &value) {
  if (!context.textureShaders || context.insideBeginEnd)
    return false;
  const int row = sizeRow(pname);
  if (row < 0 && pname != GL_TEXTURE_INTERNAL_FORMAT)
    return false;
  if (row >= 6 && !hasTextureShaders(context))
    return false;
  const GLenum name = componentFormatOf(context, target, level);
  GLint width = 0;
  if (name != 0)
    context.host->GetTexLevelParameteriv(target, level, GL_TEXTURE_WIDTH, &width);
  const ComponentFormat *const own = width != 0 ? componentFormat(name) : nullptr;
  if (!own) {
    // A level of another format has none of these. The host judges target and level.
    if (row < 6)
      return false;
    context.host->GetTexLevelParameteriv(target, level, GL_TEXTURE_WIDTH, &width);
    value = 0;
    return true;
  }
  value = row < 0 ? GLint(name) : own->bits[std::size_t(row)];
  return true;
}

/// Sets a scale or bias of the extension's components. Returns false for other names.
bool transfer(Context &context, GLenum pname, GLfloat param) {
  if (!hasTextureShaders(context) || componentTransfer(pname) < 0) [[likely]]
    return false;
  if (!outsideBeginEnd(context, "PixelTransfer between Begin and End"))
    return true;
  const TextureShaderCommand command = {
      .kind = TextureShaderCommand::Kind::Transfer, .pname = pname, .values = {param}};
  noteProgramApiUse(context);
  if (context.listMode != 0)
    listCompiler(context).record(
        context, {.kind = Command::Kind::TextureShaders, .bytes = bytesOf(command)});
  else
    executeTextureShaderCommand(context, command);
  return true;
}

/// Sets a scale or bias of ARB_imaging. Returns false for other names.
bool imagingScale(Context &context, GLenum pname, GLfloat param) {
  const float *const value =
      context.imaging ? imagingTransfer(context.imaging->settings, pname) : nullptr;
  if (!value)
    return false;
  if (outsideBeginEnd(context, "PixelTransfer between Begin and End") &&
      (*value != param || context.listMode != 0))
    issueImaging(
        context,
        {.kind = ImagingCommand::Kind::Transfer, .pname = pname, .values = {param, 0, 0, 0}});
  return true;
}

} // namespace

namespace handlers {

void GetTexLevelParameteriv(Context &context, GLenum target, GLint level, GLenum pname,
                            GLint *params) {
  GLint value = 0;
  if (params && levelValue(context, target, level, pname, value)) {
    *params = value;
    return;
  }
  context.host->GetTexLevelParameteriv(target, level, pname, params);
}

void GetTexLevelParameterfv(Context &context, GLenum target, GLint level, GLenum pname,
                            GLfloat *params) {
  GLint value = 0;
  if (params && levelValue(context, target, level, pname, value)) {
    *params = GLfloat(value);
    return;
  }
  context.host->GetTexLevelParameterfv(target, level, pname, params);
}

void PixelTransferf(Context &context, GLenum pname, GLfloat param) {
  if (!transfer(context, pname, param) && !imagingScale(context, pname, param))
    context.host->PixelTransferf(pname, param);
}

void PixelTransferi(Context &context, GLenum pname, GLint param) {
  if (!transfer(context, pname, GLfloat(param)) && !imagingScale(context, pname, GLfloat(param)))
    context.host->PixelTransferi(pname, param);
}

} // namespace handlers
} // namespace arbiter::state
