#pragma once
#include <memory>

namespace arbiter::state {

class Context;
struct CompiledProgram;

/// What of GL's state reaches vertex programs by NV_vertex_program's ways and changes without a
/// command of the layer's: matrices that c[] follows (2.14.5), and which attribute arrays are
/// enabled (2.14.3). Before a draw, in a context that has an NvState; sets the attention bits of
/// what changed.
void refreshNativeInputs(Context &context);
/// Each draw must look, as a vertex program is enabled that any of that may reach.
[[nodiscard]] bool nativeInputsMayChange(const Context &context);

/// The form of a program of NVIDIA's own languages that reads the attributes where they are now.
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
