#pragma once
#include "state/programs/nv/evaluation.h"

/// Executes EvalCoord, EvalPoint and EvalMesh while a vertex program and a map of NV_vertex_program
/// are enabled (5.1). The host has no such maps, so the layer evaluates them, and the conventional
/// maps beside them.
namespace arbiter::state {

struct DrawContext;

/// True if a vertex program and a map of NV_vertex_program are enabled.
[[nodiscard]] bool mayEvaluate(const DrawContext &context);

/// Prepares the maps for EvalCoord and EvalPoint, at Begin and until End. In a list being compiled
/// this is recorded, to be done when the list is called.
void beginEvaluation(DrawContext &context);
/// Executes the recorded command.
void prepareEvaluation(DrawContext &context);

/// Executes EvalCoord or EvalPoint. Passes it to the host if the layer does not evaluate.
void evaluatePoint(DrawContext &context, const EvaluatorPoint &point);

} // namespace arbiter::state
