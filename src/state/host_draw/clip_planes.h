#pragma once
#include <memory>
#include <mutex>

#include <GL/gl.h>

#include "fp_compiler/compiler.h"

/// User clip planes beside vertex programs. A vertex shader is clipped by them only if it writes
/// gl_ClipVertex, which costs each vertex an output and two transforms; so a program has that form
/// beside the plain one, and is drawn with it only while a plane may be enabled. What the form does
/// with the planes is right whether they are enabled or not: that it is used too often costs time,
/// no more.
namespace arbiter::state {

class Context;
struct CompiledProgram;

/// The form of a vertex program that user clip planes clip. Emitted once, when it is first asked
/// for; contexts of a share group use the same one.
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

/// Whether a vertex program has to be drawn in its clipped form now. Asks the host after a change,
/// once, and only in a context that has used planes.
[[nodiscard]] bool clipPlanesMatter(Context &context);
/// Planes may have been enabled or disabled, by an attribute stack or by another context. One test
/// where none was ever enabled.
void noteClipPlanesChange(Context &context);
/// Enable or Disable of a plane. An enable that goes into a display list counts for good, and for
/// all of the share group: draws of that list follow it without being looked at.
void noteClipPlane(Context &context, bool enabled);
/// CopyContext brought the enables of `from`.
void copyClipPlanes(const Context &from, Context &to);
/// Before a host list is called: one that was compiled since the program became effective may
/// enable planes.
void noteClipPlanesOfLists(Context &context);

} // namespace arbiter::state
