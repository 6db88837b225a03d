#include "state/programs/offered_aliases.h"

#include <memory>

#include "host/host_table.h"
#include "state/core/context_hooks.h"
#include "state/identity/active_profile.h"
#include "state/mirror/attribute_aliases.h"
#include "state/programs/program_context.h"
#include "util/flags.h"

namespace arbiter::state {

namespace {

/// Tests whether the host aliases generic and conventional attributes, by setting a value that the
/// normal does not have. Then it restores the value.
bool attributesAreOne(const host::HostTable &host) {
  constexpr GLuint kNormal = 2;
  Vec4 generic = {0.0f, 0.0f, 0.0f, 1.0f}, normal{};
  host.GetVertexAttribfv(kNormal, GL_CURRENT_VERTEX_ATTRIB, generic.data());
  host.GetFloatv(GL_CURRENT_NORMAL, normal.data());
  const Vec4 other = {normal[0] == 0.5f ? 0.25f : 0.5f, 0.0f, 0.0f, 1.0f};
  host.VertexAttrib4fv(kNormal, other.data());
  host.GetFloatv(GL_CURRENT_NORMAL, normal.data());
  host.VertexAttrib4fv(kNormal, generic.data());
  return normal[0] == other[0];
}

} // namespace

bool attributesMayAlias() {
  switch (settings().attributes) {
  case Attributes::Alias:
    return true;
  case Attributes::Apart:
    return false;
  case Attributes::OfProfile:
    break;
  }
  return activeProfile().aliasedAttributes != 0;
}

void offerAliases(ProgramContext &context) {
  const bool alias = attributesMayAlias();
  if (!context.nv && !alias)
    return;
  context.aliases = std::make_unique<AttributeAliases>();
  context.aliases->areOne = attributesAreOne(*context.host);
  context.attributesAlias =
      alias && (!context.aliases->areOne || context.hooks->mayUseRasterizer(context));
}

} // namespace arbiter::state
