#pragma once
#include <array>
#include <optional>
#include <string>

#include "fp_compiler/ir/ir.h"

namespace arbiter::fp::glsl {

/// The GLSL text of a source register: a variable that can be swizzled, or four components.
struct RegisterText {
  std::string variable; ///< empty if there is no variable
  std::array<std::string, 4> components;
};

/// Returns the text of a vec4 variable and of its components x, y, z, w.
[[nodiscard]] RegisterText variable(const std::string &name);

/// Returns the built-in that holds a fragment or vertex attribute. Components that the built-in
/// lacks are 0, 0, 1 as the extensions say. Empty if \p language does not have the attribute.
[[nodiscard]] RegisterText attributeText(ir::Language language, const ir::Attribute &attribute);

/// The destination of a result.
struct OutputText {
  std::string name;    ///< "gl_FragColor", "gl_TexCoord[3]"
  bool scalar = false; ///< a float: the one component of ir::resultMask() has no suffix
};
/// Returns the built-in that \p output of \p program is written to.
[[nodiscard]] OutputText outputText(const ir::Program &program, const ir::Output &output);

/// Returns the vertex shader's attribute for vertex.attrib[n], n > 0: "arb_attrib7".
[[nodiscard]] std::string genericName(int index);

} // namespace arbiter::fp::glsl
