#include "apps/tools/debug/testing/fake_drawer.h"

#include <cmath>

#include "apps/tools/debug/trace/numbers.h"
#include "apps/tools/language.h"
#include "fp_compiler/compiler.h"
#include "fp_compiler/hw/profile.h"

namespace arbiter::tools::debug {

namespace {

fp::CheckResult check(const std::string &text) {
  const auto language = chooseLanguage("auto", text);
  return fp::checkProgram(
      language, text, {limitsOf(*fp::hw::findBuiltin("host"), language), fp::LimitPolicy::Report});
}

fp::ir::Vec4 plainParameter(const fp::ir::Parameter &parameter) {
  return {float(parameter.index), 0.5f, -1.0f, 2.0f};
}

/// Returns whether the fragment is nearer than \p limit, by its own depth if it writes one.
bool isNear(const fp::ir::Program &program, const fp::ir::Evaluation &end, float limit) {
  float depth = 0.5f;
  for (std::size_t o = 0; o < program.outputs.size(); ++o)
    if (program.outputs[o].kind == fp::ir::OutputKind::Depth)
      depth = end.outputs[o][2];
  return depth < limit;
}

} // namespace

fp::ir::Program checked(const std::string &text) { return *check(text).program; }

fp::ir::Vec4 attributeAt(const fp::ir::Attribute &attribute, int x, int y, int width, int height) {
  const float px = float(x) + 0.5f, py = float(y) + 0.5f;
  if (attribute.kind == fp::ir::AttributeKind::Position)
    return {px, py, 0.5f, 1.0f};
  return {px / float(width), py / float(height), 0.0f, 1.0f};
}

fp::ir::Vec4 texelAt(const fp::ir::Sample &sample) {
  const auto &at = sample.coordinate;
  return {std::sin(at[0] * 3) * 0.5f + 0.5f, std::cos(at[1] * 5) * 0.5f + 0.5f,
          at[0] * at[1] + 0.125f * float(sample.unit), 1.0f};
}

Result<std::vector<Drawer::Vec4>, DebugError> FakeDrawer::draw(const std::string &text,
                                                               std::size_t targets,
                                                               const Region &region,
                                                               const std::vector<Vec4> &locals) {
  ++drawn;
  const fp::CheckResult result = check(text.empty() ? m_text : text);
  if (!result.ok())
    return DebugError{result.errorString(text)};
  const fp::ir::Program &program = *result.program;
  std::vector<Vec4> values(targets * std::size_t(region.width * region.height), uncovered());
  std::size_t next = 0;
  for (int y = region.y; y < region.y + region.height; ++y)
    for (int x = region.x; x < region.x + region.width; ++x, ++next) {
      if (covers && !covers(x, y))
        continue;
      std::vector<Vec4> attributes;
      for (const fp::ir::Attribute &attribute : program.attributes)
        attributes.push_back(attributeAt(attribute, x, y, m_width, m_height));
      fp::ir::Inputs inputs;
      inputs.attributes = attributes;
      inputs.parameter = [&](const fp::ir::Parameter &wanted) {
        const bool given =
            wanted.kind == fp::ir::ParameterKind::Local && wanted.index < locals.size();
        return given       ? locals[wanted.index]
               : parameter ? parameter(wanted)
                           : plainParameter(wanted);
      };
      inputs.texture = texelAt;
      inputs.result = wrong;
      const fp::ir::Evaluation end = fp::ir::evaluate(program, inputs);
      const bool discarded = end.killed || !isNear(program, end, limit);
      for (std::size_t o = 0; o < program.outputs.size() && !discarded; ++o)
        if (program.outputs[o].kind == fp::ir::OutputKind::Color)
          values[program.outputs[o].index * std::size_t(region.width * region.height) + next] =
              end.outputs[o];
    }
  return values;
}

Result<std::vector<std::array<std::uint8_t, 4>>, DebugError>
FakeDrawer::picture(const Region &region) {
  const auto values = draw("", 1, region);
  if (!values)
    return values.error();
  std::vector<std::array<std::uint8_t, 4>> pixels;
  for (const Vec4 &value : values.value()) {
    auto &pixel = pixels.emplace_back();
    for (std::size_t c = 0; c < 4; ++c)
      pixel[c] = byteOf(value[c]);
  }
  return pixels;
}

} // namespace arbiter::tools::debug
