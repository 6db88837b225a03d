// Images that are defined by a texture's name or unit (EXT_direct_state_access,
// ARB_direct_state_access). Draws of register combiners depend on whether they hold depths, and
// draws of texture shaders on their consistency.
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/core/depth_images.h"
#include "state/lists/texture_commands.h"

namespace arbiter::state::handlers {

#define DEFINES(Name, Parameters, Arguments)                                                       \
  void Name Parameters {                                                                           \
    noteInternalFormat(context, GLenum(internalformat));                                           \
    context.host->Name Arguments;                                                                  \
    noteTextureCommand(context);                                                                   \
  }

#define DEFINES_BY_NAME(Name, Named)                                                               \
  DEFINES(Name##1DEXT,                                                                             \
          (Context & context, Named object, GLenum target, GLint level, GLint internalformat,      \
           GLsizei width, GLint border, GLenum format, GLenum type, const void *pixels),           \
          (object, target, level, internalformat, width, border, format, type, pixels))            \
  DEFINES(Name##2DEXT,                                                                             \
          (Context & context, Named object, GLenum target, GLint level, GLint internalformat,      \
           GLsizei width, GLsizei height, GLint border, GLenum format, GLenum type,                \
           const void *pixels),                                                                    \
          (object, target, level, internalformat, width, height, border, format, type, pixels))
DEFINES_BY_NAME(TextureImage, GLuint)
DEFINES_BY_NAME(MultiTexImage, GLenum)

DEFINES(TextureStorage1D,
        (Context & context, GLuint texture, GLsizei levels, GLenum internalformat, GLsizei width),
        (texture, levels, internalformat, width))
DEFINES(TextureStorage2D,
        (Context & context, GLuint texture, GLsizei levels, GLenum internalformat, GLsizei width,
         GLsizei height),
        (texture, levels, internalformat, width, height))
DEFINES(TextureStorage1DEXT,
        (Context & context, GLuint texture, GLenum target, GLsizei levels, GLenum internalformat,
         GLsizei width),
        (texture, target, levels, internalformat, width))
DEFINES(TextureStorage2DEXT,
        (Context & context, GLuint texture, GLenum target, GLsizei levels, GLenum internalformat,
         GLsizei width, GLsizei height),
        (texture, target, levels, internalformat, width, height))

} // namespace arbiter::state::handlers
