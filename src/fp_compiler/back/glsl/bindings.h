#pragma once
#include <array>
#include <optional>
#include <string>

#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::glsl {

/// How a source register is spelled: as a variable that can be swizzled, or as four components.
struct RegisterText {
  std::string variable; ///< empty: only the components can be named
  std::array<std::string, 4> components;
};

/// A vec4 variable.
[[nodiscard]] RegisterText variable(const std::string &name);

/// What a fragment or vertex attribute is read from.
[[nodiscard]] RegisterText attributeText(ir::Language language, const ir::Attribute &attribute);

/// What a result is written to.
struct OutputText {
  std::string name;    ///< "gl_FragColor", "gl_TexCoord[3]"
  bool scalar = false; ///< a float: the one component of ir::resultMask() stands without a suffix
};
[[nodiscard]] OutputText outputText(const ir::Program &program, const ir::Output &output);

/// "arb_attrib7": the vertex shader's attribute for vertex.attrib[n], n > 0.
[[nodiscard]] std::string genericName(int index);

} // namespace arbiter::fp::glsl
