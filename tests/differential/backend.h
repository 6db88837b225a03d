#pragma once
#include <memory>
#include <string>

#include "fp_compiler/compiler.h"

namespace arbiter::differential {

/// One way from a program text to pixels.
class Backend {
public:
  virtual ~Backend() = default;
  /// Makes the program current for the draws that follow; a reason if it cannot.
  [[nodiscard]] virtual std::string use(const std::string &text,
                                        const fp::ir::Program &program) = 0;
  /// True if program matrices are GL state of this way.
  [[nodiscard]] virtual bool hasProgramMatrices() const = 0;
};

/// The API of ARB_fragment_program, whoever implements it.
[[nodiscard]] std::unique_ptr<Backend> arbBackend();
/// ATI_text_fragment_shader, and ATI_fragment_shader for the same texts, whoever implements them.
[[nodiscard]] std::unique_ptr<Backend> atiTextBackend();
[[nodiscard]] std::unique_ptr<Backend> atiApiBackend();
/// emitGlsl()'s text, compiled by the host.
[[nodiscard]] std::unique_ptr<Backend> glslBackend();

} // namespace arbiter::differential
