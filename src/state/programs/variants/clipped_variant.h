#pragma once
#include <memory>
#include <vector>

#include "fp_compiler/emit.h"
#include "state/programs/variants/forms.h"

namespace arbiter::state {

/// True if the program is clipped by distances that it writes: a program of NVIDIA's
/// (ir::Options::clipsByDistances()). Each of its variants writes gl_ClipDistance.
[[nodiscard]] bool writesClipDistances(const CompiledProgram &compiled);

/// The variants of a vertex program that user clip planes clip. Planes clip a GLSL vertex shader
/// only if it writes gl_ClipVertex, which costs an output and two transforms for each vertex. A
/// program therefore has that variant beside the plain one, used only while a plane may be enabled.
/// The variant is correct whether planes are enabled or not, so using it too often only costs time.
/// A program that writes distances of its own has a variant for each set of planes, because hosts
/// clip by each distance that is written. Variants are emitted when first needed, and contexts of a
/// share group use the same ones.
class ClippedVariant {
public:
  /// \param distances true if the host has GLSL 1.30, in which distances are written
  ClippedVariant(fp::GlslHost host, fp::Numerics numerics, bool distances)
      : m_host(host), m_numerics(numerics), m_distances(distances) {}

  /// Returns the clip-plane variant of `whole`, the program that this object belongs to. Any thread
  /// may call it.
  /// \param planes one bit for each enabled plane
  /// \param alphaDepths fp::GlslHost::alphaDepths, if the program writes distances
  [[nodiscard]] std::shared_ptr<const CompiledProgram>
  of(const CompiledProgram &whole, std::uint8_t planes, std::uint32_t alphaDepths = 0) const;
  /// Returns all variants made so far.
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
