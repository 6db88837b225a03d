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

/// Returns the arrays of generic attributes with two names that are enabled. The host is asked, as
/// vertex array objects and the client attribute stack change them too.
[[nodiscard]] std::uint32_t enabledArrays(const Context &context, const host::HostTable &host);
/// Notes an EnableVertexAttribArray or a DisableVertexAttribArray where attributes alias.
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
