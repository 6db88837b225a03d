#pragma once
#include "state/programs/vertex_shaders/recorder.h"

namespace arbiter::state {

struct ProgramContext;

/// Executes EndVertexShaderEXT: defines the bound shader as recorded.
void defineVertexShader(ProgramContext &context, const VertexShaderRecorder::Recorded &recorded);

} // namespace arbiter::state
