// Tracks framebuffer attachments, for cases where the name does not tell the object
// (deleted_names.h).
#include "host/handlers.h"
#include "host/host_table.h"
#include "state/context/context.h"
#include "state/share/share_group.h"

namespace arbiter::state::handlers {

namespace {

void noteAttachment(Context &context, GLenum target, GLenum point, DeletedNames::Kind kind,
                    GLuint name) {
  DeletedNames &names = context.group->deletedNames;
  if (names.none() || name == 0 || context.insideBeginEnd)
    return;
  GLint framebuffer = 0;
  context.host->GetIntegerv(target == GL_READ_FRAMEBUFFER ? GL_READ_FRAMEBUFFER_BINDING
                                                          : GL_DRAW_FRAMEBUFFER_BINDING,
                            &framebuffer);
  const auto note = [&](GLenum at) {
    names.attached(context.serial, GLuint(framebuffer), at, kind, name);
  };
  if (point != GL_DEPTH_STENCIL_ATTACHMENT)
    return note(point);
  note(GL_DEPTH_ATTACHMENT);
  note(GL_STENCIL_ATTACHMENT);
}

} // namespace

#define ARBITER_ATTACHES(Name, kind, object, Parameters, Arguments)                                \
  void Name Parameters {                                                                           \
    noteAttachment(context, target, attachment, DeletedNames::Kind::kind, object);                 \
    context.host->Name Arguments;                                                                  \
  }

ARBITER_ATTACHES(FramebufferTexture1D, Texture, texture,
                 (Context & context, GLenum target, GLenum attachment, GLenum textarget,
                  GLuint texture, GLint level),
                 (target, attachment, textarget, texture, level))
ARBITER_ATTACHES(FramebufferTexture2D, Texture, texture,
                 (Context & context, GLenum target, GLenum attachment, GLenum textarget,
                  GLuint texture, GLint level),
                 (target, attachment, textarget, texture, level))
ARBITER_ATTACHES(FramebufferTexture3D, Texture, texture,
                 (Context & context, GLenum target, GLenum attachment, GLenum textarget,
                  GLuint texture, GLint level, GLint zoffset),
                 (target, attachment, textarget, texture, level, zoffset))
ARBITER_ATTACHES(FramebufferTextureLayer, Texture, texture,
                 (Context & context, GLenum target, GLenum attachment, GLuint texture, GLint level,
                  GLint layer),
                 (target, attachment, texture, level, layer))
ARBITER_ATTACHES(FramebufferRenderbuffer, Renderbuffer, renderbuffer,
                 (Context & context, GLenum target, GLenum attachment, GLenum renderbuffertarget,
                  GLuint renderbuffer),
                 (target, attachment, renderbuffertarget, renderbuffer))
#undef ARBITER_ATTACHES

} // namespace arbiter::state::handlers
