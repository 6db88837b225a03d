#pragma once
#include <cstdint>
#include <memory>

#include <GL/gl.h>

namespace arbiter::host {
struct HostTable;
}
namespace arbiter::state {

class Context;
struct CompiledProgram;

/// Attributes may alias in this process: in contexts of the active profile, or as
/// ARBITER_ATTRIBUTES says.
[[nodiscard]] bool attributesMayAlias();
/// When the targets are offered: `aliases` and `attributesAlias` of the context, which is current
/// and outside of lists.
void offerAliases(Context &context);
/// The arrays of generic attributes that are enabled, of those with two names that ever were. The
/// host is asked, as vertex array objects and the client attribute stack change them too. Requires:
/// the context has `aliases`.
[[nodiscard]] std::uint32_t enabledArrays(const Context &context, const host::HostTable &host);
/// EnableVertexAttribArray and DisableVertexAttribArray, where attributes alias.
void noteGenericArray(Context &context, GLuint index, bool enabled);

/// What of GL's state reaches vertex programs by NV_vertex_program's ways and changes without a
/// command of the layer's: matrices that c[] follows (2.14.5), and which attribute arrays are
/// enabled (2.14.3). Before a draw; sets the attention bits of what changed.
void refreshNativeInputs(Context &context);
/// Each draw must look, as any of that may reach it.
[[nodiscard]] bool nativeInputsMayChange(const Context &context);

/// The form of a program that has `arrays` which reads the attributes where they are now.
/// Outside of Begin and End.
[[nodiscard]] std::shared_ptr<const CompiledProgram>
withItsAttributes(Context &context, const CompiledProgram &program);

/// While it lives a primitive between Begin and End is prepared, which reads no arrays.
class ImmediateInputs {
public:
  explicit ImmediateInputs(Context &context);
  ~ImmediateInputs();
  ImmediateInputs(const ImmediateInputs &) = delete;
  ImmediateInputs &operator=(const ImmediateInputs &) = delete;

private:
  Context &m_context;
};

} // namespace arbiter::state
