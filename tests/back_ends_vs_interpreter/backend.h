#pragma once
#include <memory>
#include <string>

#include "fp_compiler/compiler.h"

namespace arbiter::differential {

/// A program as text, and the front end's result for it.
struct Stage {
  const std::string &text;
  const fp::ir::Program &program;
};

/// One way from program texts to pixels.
class Backend {
public:
  virtual ~Backend() = default;
  /// Makes a fragment program, with a vertex program or fixed function before it, current for later
  /// draws; returns a reason if it cannot.
  [[nodiscard]] virtual std::string use(const Stage &fragment, const Stage *vertex = nullptr) = 0;
  /// True if program matrices are GL state of this way.
  [[nodiscard]] virtual bool hasProgramMatrices() const = 0;
};

/// Uses the API of ARB_fragment_program and ARB_vertex_program, of the host or of the layer in
/// front of it.
[[nodiscard]] std::unique_ptr<Backend> arbBackend();
/// These use ATI_text_fragment_shader, and ATI_fragment_shader for the same texts, of the host or
/// the layer.
[[nodiscard]] std::unique_ptr<Backend> atiTextBackend();
[[nodiscard]] std::unique_ptr<Backend> atiApiBackend();
/// Uses the ARB API with emitAssembly()'s text instead of the application's.
[[nodiscard]] std::unique_ptr<Backend> assemblyBackend();
/// Uses emitGlsl()'s text, compiled by the host. The destructor leaves no program in use.
[[nodiscard]] std::unique_ptr<Backend> glslBackend(fp::Numerics numerics = fp::Numerics::Host);

} // namespace arbiter::differential
