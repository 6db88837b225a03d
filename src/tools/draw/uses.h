#pragma once
#include <string>
#include <vector>

#include "tools/draw/scene.h"

/// What the programs of a scene read of it: an image or a value that none reads is a mistake.
namespace arbiter::tools {

/// The first argument that no program reads, or that is not what the program expects of it (a
/// sample of a cube map has no use for an image): "--texture 0=a.png: ..". Empty if there is none,
/// and for programs that the compiler refuses: of those GL says what is wrong.
[[nodiscard]] std::string faultOfUses(const Scene &scene);

/// Samples that will read black, as nothing was given for their unit: one line each.
[[nodiscard]] std::vector<std::string> unfedSamples(const Scene &scene);

} // namespace arbiter::tools
