#pragma once
#include <cstdint>
#include <memory>

#include "fp_compiler/ir/ir.h"

/// How programs of NVIDIA's own languages read v[n], which is the conventional attribute of that
/// number (NV_vertex_program, table X.2). Bit n of a mask stands for v[n].
namespace arbiter::state {

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
