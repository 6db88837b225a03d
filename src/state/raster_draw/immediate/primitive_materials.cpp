#include "state/raster_draw/immediate/primitive_materials.h"

#include <algorithm>

#include "host/host_table.h"
#include "state/core/context.h"
#include "state/raster_draw/context_state.h"

namespace arbiter::state::software {

namespace {

/// Those of the context's own recorder; null where it records nothing.
PrimitiveMaterials *materialsOf(ContextHot &hot) {
  const auto &context = static_cast<const Context &>(hot);
  if (!context.software || context.listMode != 0 ||
      context.recorder != &context.software->recorder)
    return nullptr;
  return &context.software->materials;
}

} // namespace

bool setsMaterialAgain(ContextHot &hot, GLenum face, GLenum pname, const GLfloat *values) {
  using Colors = PrimitiveMaterials::Colors;
  PrimitiveMaterials *const materials = materialsOf(hot);
  const int count = materialValues(pname);
  if (!materials || count == 0 || !values)
    return false;
  StateCommand command{.target = face, .pname = pname};
  std::copy_n(values, count, command.values.begin());
  if (!command.isValid())
    return false;
  if (materials->m_colors == Colors::Unknown) {
    // Behind what stands in for it, which would take the question for the primitive's end.
    const host::HostTable &host = *static_cast<const Context &>(hot).trueHost;
    materials->m_colors =
        host.IsEnabled(GL_COLOR_MATERIAL) ? Colors::AreMaterials : Colors::AreNone;
  }
  return materials->m_colors == Colors::AreNone && !materials->m_known.set(command);
}

void forgetMaterials(ContextHot &hot) {
  if (PrimitiveMaterials *const materials = materialsOf(hot))
    materials->forget();
}

} // namespace arbiter::state::software
