#include "state/host_draw/evaluators/nv_attributes.h"

#include <algorithm>

#include "host/host_table.h"
#include "state/core/context.h"
#include "state/core/unit_scope.h"
#include "state/raster_draw/immediate/recorder.h"

namespace arbiter::state {

namespace {

constexpr GLuint kFirstTexCoord = 8;

/// Components that the conventional attribute has of its own, where they are fewer than four; else
/// 0.
constexpr int fewerComponents(GLuint index) {
  return index == 2 || index == 4 ? 3 : index == 5 ? 1 : 0;
}

/// The slot of the conventional attribute, or of a generic one that has no other name.
int slotOf(GLuint index) {
  switch (index) {
  case 2:
    return software::kNormal;
  case 3:
    return software::kColor;
  case 4:
    return software::kSecondary;
  case 5:
    return software::kFogCoord;
  default:
    return index < kFirstTexCoord ? software::kGeneric0 + int(index)
                                  : software::kTexCoord0 + int(index - kFirstTexCoord);
  }
}

void record(software::ImmediateRecorder &recorder, GLuint index, const Vec4 &v) {
  if (index == 0)
    return recorder.vertex(v[0], v[1], v[2], v[3]);
  Vec4 conventional = v;
  if (const int common = fewerComponents(index)) {
    conventional = {0.0f, 0.0f, 0.0f, 1.0f};
    std::copy_n(v.begin(), common, conventional.begin());
    recorder.set(software::kGeneric0 + int(index), v[0], v[1], v[2], v[3]);
  }
  recorder.set(slotOf(index), conventional[0], conventional[1], conventional[2], conventional[3]);
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

/// The generic one last: on hosts whose attributes are one it is what counts.
void send(const host::HostTable &host, GLuint index, const Vec4 &v) {
  sendConventional(host, index, v);
  if (fewerComponents(index) != 0)
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

/// What VertexAttribNV has set, if no conventional command came later: the same choice as programs
/// make (state/host_draw/variants/attribute_forms.h).
const Vec4 &later(GLuint index, const Vec4 &conventional, const Vec4 &generic) {
  const bool same =
      std::equal(generic.begin(), generic.begin() + fewerComponents(index), conventional.begin());
  return same ? generic : conventional;
}

} // namespace

void setNvAttribute(Context &context, GLuint index, const Vec4 &value) {
  if (context.recorder)
    return record(*context.recorder, index, value);
  send(*context.host, index, value);
}

Vec4 currentNvAttribute(const Context &context, GLuint index) {
  const bool fewer = fewerComponents(index) != 0;
  if (context.recorder) {
    const software::CurrentValues &values = context.recorder->values();
    const Vec4 &conventional = values[std::size_t(slotOf(index))];
    return fewer ? later(index, conventional, values[software::kGeneric0 + index]) : conventional;
  }
  const Vec4 conventional = hostsConventional(*context.host, index);
  if (!fewer)
    return conventional;
  Vec4 generic = {0.0f, 0.0f, 0.0f, 1.0f};
  context.host->GetVertexAttribfv(index, GL_CURRENT_VERTEX_ATTRIB, generic.data());
  return later(index, conventional, generic);
}

} // namespace arbiter::state
