#include <epoxy/gl.h>

#include "fp_compiler/testing/interval.h"
#include "fp_compiler/testing/random.h"
#include "gl_host.h"
#include "scene.h"

namespace arbiter::differential {

using namespace fp::ir;

Vec4 vertexValue(const Attribute &attribute, int x, int y) {
  const bool generic = attribute.kind == AttributeKind::Generic;
  if (attribute.kind == AttributeKind::Position || (generic && attribute.index == 0))
    return {(2.0f * float(x) + 1.0f) / kSide - 1.0f, (2.0f * float(y) + 1.0f) / kSide - 1.0f,
            float((x * 7 + y * 3) % 16) / 16.0f - 0.5f, 1};
  const auto seed = std::uint64_t(attribute.kind) * 64 + attribute.index;
  fp::testing::Random random((seed * kSide + std::uint64_t(y)) * kSide + std::uint64_t(x) + 5);
  Vec4 value;
  for (int i = 0; i < 4; ++i) {
    const fp::testing::Interval range = fp::testing::vertexAttributeRange(attribute, i);
    value[std::size_t(i)] = random.real(range.lo, range.hi);
  }
  switch (attribute.kind) {
  case AttributeKind::FogCoord:
    return {value[0], 0, 0, 1};
  case AttributeKind::Normal:
  case AttributeKind::ColorSecondary: // given as three numbers
    return {value[0], value[1], value[2], 1};
  default:
    return value;
  }
}

namespace {
void drawPointsWith(const std::vector<Attribute> &attributes) {
  glBegin(GL_POINTS);
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const auto value = [&](AttributeKind kind, int index = 0) {
        return vertexValue({kind, std::uint8_t(index)}, x, y);
      };
      glColor4fv(value(AttributeKind::ColorPrimary).data());
      glSecondaryColor3fv(value(AttributeKind::ColorSecondary).data());
      glNormal3fv(value(AttributeKind::Normal).data());
      glFogCoordf(value(AttributeKind::FogCoord)[0]);
      for (int i = 0; i < 8; ++i)
        glMultiTexCoord4fv(GL_TEXTURE0 + GLenum(i), value(AttributeKind::TexCoord, i).data());
      for (const Attribute &attribute : attributes)
        if (attribute.kind == AttributeKind::Generic && attribute.index != 0)
          glVertexAttrib4fvARB(attribute.index,
                               value(AttributeKind::Generic, attribute.index).data());
      glVertex4fv(value(AttributeKind::Position).data());
    }
  glEnd();
}
} // namespace

void drawPoints(const Program &program) { drawPointsWith(program.attributes); }

void drawPoints() {
  std::vector<Attribute> generic;
  for (int i = 1; i < 16; ++i)
    generic.push_back({AttributeKind::Generic, std::uint8_t(i)});
  drawPointsWith(generic);
}

} // namespace arbiter::differential
