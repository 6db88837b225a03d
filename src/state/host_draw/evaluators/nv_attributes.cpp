#include "state/host_draw/evaluators/nv_attributes.h"

#include <algorithm>

#include "host/host_table.h"
#include "state/core/unit_scope.h"
#include "state/host_draw/draw_context.h"
#include "state/mirror/attribute_aliases.h"
#include "state/primitives/recorder.h"

namespace arbiter::state {

namespace {

constexpr GLuint kFirstTexCoord = 8;

/// Returns the number of components of the conventional attribute if it has fewer than four, else
/// 0.
constexpr int fewerComponents(GLuint index) {
  return index == 2 || index == 4 ? 3 : index == 5 ? 1 : 0;
}

/// Records an attribute.
/// \param both records the generic attribute too; otherwise the conventional one stands for both,
/// on a host whose attributes alias
void record(ImmediateRecorder &recorder, GLuint index, const Vec4 &v, unsigned given, bool both) {
  if (index == 0)
    return recorder.vertex(v[0], v[1], v[2], v[3], given);
  Vec4 conventional = v;
  if (const int common = fewerComponents(index)) {
    conventional = {0.0f, 0.0f, 0.0f, 1.0f};
    std::copy_n(v.begin(), common, conventional.begin());
  }
  if (both)
    recorder.set(kGeneric0 + int(index), v[0], v[1], v[2], v[3], given);
  recorder.set(slotOfRegister(index), conventional[0], conventional[1], conventional[2],
               conventional[3], given);
}

/// True if the host's attributes alias.
bool areOne(const DrawContext &context) { return context.aliases && context.aliases->areOne; }

/// True if a component that the conventional command cannot set differs from its default.
bool isWider(GLuint index, const Vec4 &v) {
  constexpr Vec4 kDefault = {0.0f, 0.0f, 0.0f, 1.0f};
  const int common = fewerComponents(index);
  return common != 0 && !std::equal(v.begin() + common, v.end(), kDefault.begin() + common);
}

/// Makes ARB programs look for such values, from the first one on.
void noteWider(DrawContext &context, GLuint index, const Vec4 &v) {
  if (!context.aliases || context.aliases->widerGiven || !isWider(index, v)) [[likely]]
    return;
  context.aliases->widerGiven = true;
  context.attention |= attention::kProgram;
}

void sendConventional(const host::HostTable &host, GLuint index, const Vec4 &v) {
  switch (index) {
  case 0:
    return host.Vertex4fv(v.data());
  case 2:
    return host.Normal3fv(v.data());
  case 3:
    return host.Color4fv(v.data());
  case 4:
    return host.SecondaryColor3fv(v.data());
  case 5:
    return host.FogCoordfv(v.data());
  default:
    break;
  }
  if (index < kFirstTexCoord)
    host.VertexAttrib4fv(index, v.data());
  else
    host.MultiTexCoord4fv(GL_TEXTURE0 + (index - kFirstTexCoord), v.data());
}

/// Sends an attribute. The generic one comes last, because it counts on hosts whose attributes
/// alias.
void send(const host::HostTable &host, GLuint index, const Vec4 &v, bool both) {
  sendConventional(host, index, v);
  if (both)
    host.VertexAttrib4fv(index, v.data());
}

Vec4 hostsConventional(const host::HostTable &host, GLuint index) {
  Vec4 value = {0.0f, 0.0f, 0.0f, 1.0f};
  switch (index) {
  case 2:
    host.GetFloatv(GL_CURRENT_NORMAL, value.data());
    break;
  case 3:
    host.GetFloatv(GL_CURRENT_COLOR, value.data());
    break;
  case 4:
    host.GetFloatv(GL_CURRENT_SECONDARY_COLOR, value.data());
    value[3] = 1.0f;
    break;
  case 5:
    host.GetFloatv(GL_CURRENT_FOG_COORD, value.data());
    break;
  default:
    if (index < kFirstTexCoord) {
      host.GetVertexAttribfv(index, GL_CURRENT_VERTEX_ATTRIB, value.data());
    } else {
      const UnitScope unit(host, index - kFirstTexCoord);
      host.GetFloatv(GL_CURRENT_TEXTURE_COORDS, value.data());
    }
  }
  return value;
}

/// Returns the value that was set last. The generic value is taken if the common components are
/// equal: then no conventional command came after VertexAttribNV. Programs decide in the same way
/// (state/programs/variants/attribute_forms.h).
const Vec4 &later(GLuint index, const Vec4 &conventional, const Vec4 &generic) {
  const bool same =
      std::equal(generic.begin(), generic.begin() + fewerComponents(index), conventional.begin());
  return same ? generic : conventional;
}

/// Returns the host's value of a register.
Vec4 hostsRegister(const host::HostTable &host, GLuint index) {
  const Vec4 conventional = hostsConventional(host, index);
  if (fewerComponents(index) == 0)
    return conventional;
  Vec4 generic = {0.0f, 0.0f, 0.0f, 1.0f};
  host.GetVertexAttribfv(index, GL_CURRENT_VERTEX_ATTRIB, generic.data());
  return later(index, conventional, generic);
}

template <typename T>
bool getAliased(const ContextHot &hot, const host::HostTable &host, GLuint index, T *values) {
  if (hot.insideBeginEnd || !values || static_cast<const DrawContext &>(hot).aliases->ofGlsl)
    return false;
  const Vec4 value = hostsRegister(host, index);
  std::transform(value.begin(), value.end(), values, rounded<T>);
  return true;
}

} // namespace

void setNvAttribute(DrawContext &context, GLuint index, const Vec4 &value) {
  const bool wider = fewerComponents(index) != 0;
  noteWider(context, index, value);
  if (context.recorder)
    return record(*context.recorder, index, value, 4, wider && !areOne(context));
  send(*context.host, index, value, wider);
}

void setAliasedAttribute(ContextHot &hot, GLuint index, const Vec4 &value, unsigned given) {
  auto &context = static_cast<DrawContext &>(hot);
  if (context.aliases->ofGlsl) {
    if (!hot.recorder)
      return hot.host->VertexAttrib4fv(index, value.data());
    return hot.recorder->set(kGeneric0 + int(index), value[0], value[1], value[2], value[3], given);
  }
  noteWider(context, index, value);
  if (hot.recorder)
    return record(*hot.recorder, index, value, given, !areOne(context));
  send(*hot.host, index, value, true);
}

Vec4 currentNvAttribute(const DrawContext &context, GLuint index) {
  if (!context.recorder)
    return hostsRegister(*context.host, index);
  const CurrentValues &values = context.recorder->values();
  const Vec4 &conventional = values[std::size_t(slotOfRegister(index))];
  return fewerComponents(index) != 0 && !areOne(context)
             ? later(index, conventional, values[kGeneric0 + index])
             : conventional;
}

bool getAliasedAttribute(const ContextHot &hot, const host::HostTable &host, GLuint index,
                         GLfloat *values) {
  return getAliased(hot, host, index, values);
}
bool getAliasedAttribute(const ContextHot &hot, const host::HostTable &host, GLuint index,
                         GLdouble *values) {
  return getAliased(hot, host, index, values);
}
bool getAliasedAttribute(const ContextHot &hot, const host::HostTable &host, GLuint index,
                         GLint *values) {
  return getAliased(hot, host, index, values);
}

} // namespace arbiter::state
