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

/// The spelling of a vec4 variable: it and its components x, y, z, w.
[[nodiscard]] RegisterText variable(const std::string &name);

/// The built-in that a fragment or vertex attribute is read from; what the built-in lacks of a vec4
/// is 0, 0, 1 as the extensions say. Empty for an attribute that \p language does not have.
[[nodiscard]] RegisterText attributeText(ir::Language language, const ir::Attribute &attribute);

/// What a result is written to.
struct OutputText {
  std::string name;    ///< "gl_FragColor", "gl_TexCoord[3]"
  bool scalar = false; ///< a float: the one component of ir::resultMask() stands without a suffix
};
/// The built-in that \p output of \p program is written to.
[[nodiscard]] OutputText outputText(const ir::Program &program, const ir::Output &output);

/// "arb_attrib7": the vertex shader's attribute for vertex.attrib[n], n > 0.
[[nodiscard]] std::string genericName(int index);

} // namespace arbiter::fp::glsl
