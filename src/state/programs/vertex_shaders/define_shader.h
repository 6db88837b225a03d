#pragma once
#include "state/programs/vertex_shaders/recorder.h"

namespace arbiter::state {

class Context;

/// EndVertexShaderEXT: the bound shader becomes what was recorded.
void defineVertexShader(Context &context, const VertexShaderRecorder::Recorded &recorded);

} // namespace arbiter::state
