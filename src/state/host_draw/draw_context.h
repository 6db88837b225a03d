#pragma once
#include <memory>

#include <GL/gl.h>

#include "state/core/attrib_stack.h"
#include "state/programs/program_context.h"

namespace arbiter::state {

class HostAssembly;
class LinkedProgramCache;
class SamplerOverride;
class StagePipeline;

/// The application's own GLSL program: cached, and queried again after possible changes.
struct ApplicationProgram {
  GLuint program = 0;
  bool programKnown = true;
  bool pipelinesUsed = false;
};

/// Programs and bindings that the layer holds on the host. All are null only in the null
/// context.
struct HostSide {
  std::unique_ptr<LinkedProgramCache> linkedPrograms;
  std::unique_ptr<SamplerOverride> samplerOverride;
  std::unique_ptr<HostAssembly> assembly;
  std::unique_ptr<StagePipeline> stagePipeline;
};

/// Adds what the host draws with.
struct DrawContext : ProgramContext {
  ApplicationProgram application;
  HostSide hostSide;
  bool vertexResultsMatter = false; ///< RasterPos is being validated: it needs all results of a
                                    ///< vertex program
  AttribStack attribStack;

protected:
  constexpr DrawContext();
  ~DrawContext();
};

} // namespace arbiter::state
