#pragma once
#include <string>
#include <vector>

#include "apps/tools/draw/drawing.h"
#include "fp_compiler/ir/interface.h"

/// Finds the inputs that a drawing's programs read. An image or value that none of them reads is a
/// mistake.
namespace arbiter::tools {

struct Sampled {
  unsigned unit = 0;
  fp::ir::TexTarget target = fp::ir::TexTarget::Tex2D;
};
/// Returns each unit that a program samples, once. Returns nothing for an invalid program.
[[nodiscard]] std::vector<Sampled> samplesOf(const scene::ProgramFile &file);

/// Returns a complaint about the first option that no program reads, or that does not fit the
/// program: "--texture 0=a.png: ..". For example, an image does not fit a cube map. Returns "" if
/// there is none, or if a program is invalid, because GL reports that.
[[nodiscard]] std::string faultOfUses(const Drawing &drawing);

/// Applies values of --texture to a document.
/// \returns an empty string, or a complaint: of applyTextures(), or of faultOfUses().
[[nodiscard]] std::string giveTextures(const std::vector<std::string> &textures,
                                       scene::Document &document);

/// Returns one line for each sampled unit without a texture, which will read a checker with the
/// unit's number.
[[nodiscard]] std::vector<std::string> unfedSamples(const scene::Document &document);

} // namespace arbiter::tools
