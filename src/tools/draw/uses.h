#pragma once
#include <string>
#include <vector>

#include "fp_compiler/ir/interface.h"
#include "tools/draw/drawing.h"

/// What the programs of a drawing read of it: an image or a value that none reads is a mistake.
namespace arbiter::tools {

struct Sampled {
  unsigned unit = 0;
  fp::ir::TexTarget target = fp::ir::TexTarget::Tex2D;
};
/// Each unit that a program samples, once. Empty for a program that the compiler refuses.
[[nodiscard]] std::vector<Sampled> samplesOf(const scene::ProgramFile &file);

/// The first option that no program reads, or that is not what the program expects of it (a
/// sample of a cube map has no use for an image): "--texture 0=a.png: ..". Empty if there is none,
/// and for programs that the compiler refuses: of those GL says what is wrong.
[[nodiscard]] std::string faultOfUses(const Drawing &drawing);

/// Samples that will read a checker with their unit's number, as nothing was given for it: one line
/// each.
[[nodiscard]] std::vector<std::string> unfedSamples(const scene::Document &document);

} // namespace arbiter::tools
