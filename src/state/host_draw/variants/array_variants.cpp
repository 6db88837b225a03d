#include "state/host_draw/variants/array_variants.h"

#include "fp_compiler/ir/ir.h"
#include "state/host_draw/variants/clipped_variant.h"
#include "state/programs/program_object.h"
#include "util/flags.h"
#include "util/log.h"

namespace arbiter::state {

namespace {

using fp::ir::Attribute;
using fp::ir::AttributeKind;

/// The number of v[n]; 0 of those that are the position, or generic already.
unsigned numberOf(const Attribute &attribute) {
  switch (attribute.kind) {
  case AttributeKind::Normal:
    return 2;
  case AttributeKind::ColorPrimary:
    return 3;
  case AttributeKind::ColorSecondary:
    return 4;
  case AttributeKind::FogCoord:
    return 5;
  case AttributeKind::TexCoord:
    return 8u + attribute.index;
  default:
    return 0;
  }
}

std::shared_ptr<const fp::ir::Program> withArrays(const fp::ir::Program &program,
                                                  std::uint32_t arrays) {
  auto form = std::make_shared<fp::ir::Program>(program);
  for (Attribute &attribute : form->attributes) {
    const unsigned number = numberOf(attribute);
    if ((arrays >> number & 1u) != 0)
      attribute = {AttributeKind::Generic, std::uint8_t(number)};
  }
  return form;
}

} // namespace

std::shared_ptr<const CompiledProgram> ArrayVariants::of(const CompiledProgram &whole,
                                                         std::uint32_t arrays) const {
  arrays &= kBoth & whole.native.attributes;
  if (arrays == 0)
    return whole.shared_from_this();
  return m_forms.of(arrays, [&] {
    auto form = std::make_shared<CompiledProgram>(whole);
    form->arrays = nullptr; // it would keep itself
    form->program = withArrays(*whole.program, arrays);
    form->glsl = fp::emitGlsl(*form->program, m_host, m_numerics);
    fp::GlslHost clipping = m_host;
    clipping.clipPlanes = true;
    form->clipped = std::make_shared<const ClippedVariant>(clipping, m_numerics, m_distances);
    if (debugFlag(DebugFlag::Glsl))
      logText(LogLevel::Debug, "state", toHex(form->hash), form->glsl.text);
    return form;
  });
}

} // namespace arbiter::state
