#pragma once
#include "state/programs/nv/evaluation.h"

/// EvalCoord, EvalPoint and EvalMesh where a vertex program is enabled and a map of
/// NV_vertex_program's is (5.1). The host has no such maps: the layer evaluates these, and the
/// conventional ones beside them.
namespace arbiter::state {

class Context;

/// A vertex program is enabled, and a map of NV_vertex_program's.
[[nodiscard]] bool mayEvaluate(const Context &context);

/// At Begin: what EvalCoord and EvalPoint go by until End. In a list that is compiled that is a
/// command, for when the list is called.
void beginEvaluation(Context &context);
/// The command, executed.
void prepareEvaluation(Context &context);

/// EvalCoord and EvalPoint, executed: the host's where the layer does not evaluate.
void evaluatePoint(Context &context, const EvaluatorPoint &point);

} // namespace arbiter::state
