#pragma once
#include <memory>
#include <mutex>

#include "fp_compiler/emit.h"

namespace arbiter::state {

struct CompiledProgram;

/// The form of a vertex program that user clip planes clip. A vertex shader is clipped by them only
/// if it writes gl_ClipVertex, which costs each vertex an output and two transforms; so a program
/// has that form beside the plain one, and is drawn with it only while a plane may be enabled. What
/// the form does with the planes is right whether they are enabled or not: that it is used too
/// often costs time, no more. Emitted once, when it is first asked for; contexts of a share group
/// use the same one.
class ClippedVariant {
public:
  ClippedVariant(fp::GlslHost host, fp::Numerics numerics) : m_host(host), m_numerics(numerics) {}

  /// The form of `whole`, which this is the one of. Any thread may call it.
  [[nodiscard]] std::shared_ptr<const CompiledProgram> of(const CompiledProgram &whole) const;
  /// The form, or null where it was never asked for.
  [[nodiscard]] std::shared_ptr<const CompiledProgram> made() const;

private:
  fp::GlslHost m_host;
  fp::Numerics m_numerics;
  mutable std::mutex m_mutex;
  mutable std::shared_ptr<const CompiledProgram> m_form;
};

} // namespace arbiter::state
