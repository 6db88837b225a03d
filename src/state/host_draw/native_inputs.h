#pragma once
#include <cstdint>
#include <memory>

#include <GL/gl.h>

namespace arbiter::host {
struct HostTable;
}
namespace arbiter::state {

struct DrawContext;
struct CompiledProgram;

/// Returns the enabled arrays of generic attributes that have two names. Queries the host, because
/// vertex array objects and the client attribute stack change them too.
[[nodiscard]] std::uint32_t enabledArrays(const DrawContext &context, const host::HostTable &host);
/// Notes an EnableVertexAttribArray or a DisableVertexAttribArray while attributes alias.
void noteGenericArray(DrawContext &context, GLuint index, bool enabled);

/// Updates GL state that reaches vertex programs through NV_vertex_program and changes without the
/// layer's commands. This is the matrices that c[] tracks (2.14.5), and which attribute arrays are
/// enabled (2.14.3). Call it before a draw; it sets the attention bits of what changed.
void refreshNativeInputs(DrawContext &context);
/// True if each draw must call refreshNativeInputs().
[[nodiscard]] bool nativeInputsMayChange(const DrawContext &context);

/// Returns the variant of a program with `arrays` that reads each attribute where its value is now.
/// Requires that no primitive is open.
[[nodiscard]] std::shared_ptr<const CompiledProgram>
withItsAttributes(DrawContext &context, const CompiledProgram &program);

/// While it lives, a primitive between Begin and End is being prepared, which reads no arrays.
class ImmediateInputs {
public:
  explicit ImmediateInputs(DrawContext &context);
  ~ImmediateInputs();
  ImmediateInputs(const ImmediateInputs &) = delete;
  ImmediateInputs &operator=(const ImmediateInputs &) = delete;

private:
  DrawContext &m_context;
};

} // namespace arbiter::state
