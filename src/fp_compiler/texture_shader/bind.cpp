#include "fp_compiler/texture_shader/bind.h"

namespace arbiter::fp::texture_shader {

void bindValues(ir::Program &program, const Values &values) {
  for (ir::Parameter &parameter : program.parameters)
    if (parameter.kind == ir::ParameterKind::Env && parameter.index < values.size())
      if (const std::optional<ir::Vec4> &value = values[parameter.index])
        parameter = {ir::ParameterKind::Constant, *value, 0, {}};
}

} // namespace arbiter::fp::texture_shader
