#pragma once
#include "state/programs/vertex_shaders/recorder.h"

namespace arbiter::state {

class Context;

/// Executes EndVertexShaderEXT: defines the bound shader as recorded.
void defineVertexShader(Context &context, const VertexShaderRecorder::Recorded &recorded);

} // namespace arbiter::state
