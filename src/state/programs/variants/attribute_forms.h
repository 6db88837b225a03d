#pragma once
#include <cstdint>
#include <memory>

#include "fp_compiler/ir/ir.h"

/// Changes which attributes a program reads where generic attributes alias the conventional ones
/// (NV_vertex_program, table X.2), as v[n] of NVIDIA's languages always does. Bit n of a mask
/// stands for register n.
namespace arbiter::state {

/// Returns the program with the conventional name for each attribute that has one, or null if
/// nothing changes.
[[nodiscard]] std::shared_ptr<const fp::ir::Program>
withConventionalAttributes(const fp::ir::Program &program);
/// Returns the aliased registers that a program reads by their conventional name.
[[nodiscard]] std::uint32_t registersOf(const fp::ir::Program &program);

/// Returns the registers of the normal, the secondary colour and the fog coordinate of which \p
/// program reads components that conventional commands do not set. These are w, and y and z of the
/// fog coordinate; VertexAttribNV sets them.
[[nodiscard]] std::uint32_t readsBeyondConventional(const fp::ir::Program &program);

/// Returns the program that reads the host's generic attribute n if \p generic has bit n, and both
/// attributes if \p either has it. VertexAttribNV sets both on the host. The generic one is
/// therefore valid if the common components are equal; otherwise a conventional command came later.
[[nodiscard]] std::shared_ptr<const fp::ir::Program>
withAttributes(const fp::ir::Program &program, std::uint32_t generic, std::uint32_t either);

} // namespace arbiter::state
