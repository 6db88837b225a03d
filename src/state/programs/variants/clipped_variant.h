#pragma once
#include <memory>
#include <vector>

#include "fp_compiler/emit.h"
#include "state/programs/variants/forms.h"

namespace arbiter::state {

/// True if what clips the program's vertices is what it writes: one of NVIDIA's
/// (ir::Options::clipsByDistances()). Each form of it writes gl_ClipDistance.
[[nodiscard]] bool writesClipDistances(const CompiledProgram &compiled);

/// The forms of a vertex program that user clip planes clip. A vertex shader is clipped by them
/// only if it writes gl_ClipVertex, which costs each vertex an output and two transforms; so a
/// program has that form beside the plain one, and is drawn with it only while a plane may be
/// enabled. What the form does with the planes is right whether they are enabled or not: that it is
/// used too often costs time, no more. One that writes distances of its own has a form for each
/// set of planes, as hosts clip by each that is written. Emitted once, when first asked for;
/// contexts of a share group use the same ones.
class ClippedVariant {
public:
  /// \param distances the host has GLSL 1.30, in which they are written
  ClippedVariant(fp::GlslHost host, fp::Numerics numerics, bool distances)
      : m_host(host), m_numerics(numerics), m_distances(distances) {}

  /// The form of `whole`, which this is the one of. Any thread may call it.
  /// \param planes a bit for each that is enabled
  /// \param alphaDepths fp::GlslHost's, where it writes distances
  [[nodiscard]] std::shared_ptr<const CompiledProgram>
  of(const CompiledProgram &whole, std::uint8_t planes, std::uint32_t alphaDepths = 0) const;
  /// The forms that were asked for.
  [[nodiscard]] std::vector<std::shared_ptr<const CompiledProgram>> all() const {
    return m_forms.all();
  }

private:
  struct Key {
    std::uint8_t planes;
    std::uint32_t alphaDepths;
    bool operator==(const Key &) const = default;
  };
  fp::GlslHost m_host;
  fp::Numerics m_numerics;
  bool m_distances;
  Forms<Key> m_forms;
};

} // namespace arbiter::state
