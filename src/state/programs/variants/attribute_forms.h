#pragma once
#include <cstdint>
#include <memory>

#include "fp_compiler/ir/ir.h"

/// How programs read attributes where generic ones are the conventional ones of their numbers
/// (NV_vertex_program, table X.2), as v[n] of NVIDIA's own languages always is. Bit n of a mask
/// stands for register n.
namespace arbiter::state {

/// The program with the conventional name of each attribute that has one; null: it reads no other.
[[nodiscard]] std::shared_ptr<const fp::ir::Program>
withConventionalAttributes(const fp::ir::Program &program);
/// The registers with two names that a program reads by the conventional one.
[[nodiscard]] std::uint32_t registersOf(const fp::ir::Program &program);

/// Those of the normal, the secondary colour and the fog coordinate, of which \p program reads
/// components that the conventional commands do not have: w, and y and z of the fog coordinate.
/// VertexAttribNV sets them.
[[nodiscard]] std::uint32_t readsBeyondConventional(const fp::ir::Program &program);

/// The program that reads the host's generic attribute n where \p generic has a bit, and both where
/// \p either has one: VertexAttribNV gives the host both, so that the generic one counts where the
/// components that both have are equal. Where they are not, a conventional command came later.
[[nodiscard]] std::shared_ptr<const fp::ir::Program>
withAttributes(const fp::ir::Program &program, std::uint32_t generic, std::uint32_t either);

} // namespace arbiter::state
