#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "state/objects/linked_program.h"

namespace arbiter::state {

class Context;

/// The linked programs of a context, with the host's shaders and programs that they consist of.
/// Each program is compiled once, however many it is paired with.
class LinkedProgramCache {
public:
  /// The form of the fragment program on the host. It is GLSL anyway if the host refuses the
  /// assembly, or if the vertex program is GLSL, with which assembly cannot be combined.
  enum class Fragments : std::uint8_t { Glsl, Assembly };

  /// True if vertex programs are drawn with the host's own ARB path. The host must have one, and
  /// numerics must be the host's, because assembly cannot express other numerics.
  [[nodiscard]] bool drawsVerticesByAssembly(const Context &context);

} // namespace arbiter::state
