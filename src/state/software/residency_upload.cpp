// Texels that the application gives.
#include "state/feedback.h"
#include "state/program_api.h"
#include "state/share_group.h"
#include "state/software/residency_host.h"

namespace arbiter::state::software {

void texSubImage(Context &context, GLenum target, GLint level, GLint, GLint, GLint, GLsizei,
                 GLsizei, GLsizei, GLenum, GLenum, const void *) {
  WindowImages *const window = windowOf(context);
  const GLenum binding = bindingOf(target);
  if (!window || binding == 0)
    return;
  SharedImages &shared = sharedOf(context);
  const std::lock_guard lock(shared.mutex);
  if (shared.valid == 0)
    return;
  GLint name = 0;
  context.host->GetIntegerv(binding, &name);
  const auto found = shared.textures.find(GLuint(name));
  if (found == shared.textures.end())
    return;
  PixelImage *const image = levelOf(context, *found->second, target, level);
  if (!image || image->newest == Newest::Host)
    return;
  if (image->newest == Newest::Shadow)
    upload(context, *window, *image);
  dropShadow(context, *image);
}

} // namespace arbiter::state::software
