#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "backend.h"
#include "gl_host.h"
#include "subject.h"

namespace arbiter::differential {

struct SuiteOptions {
  std::function<Subject(std::uint64_t seed)> subject = arbSubject;
  fp::Numerics numerics = fp::Numerics::Host; ///< of the interpreter and the backend
  int count = 500;
  std::uint64_t firstSeed = 1;
  bool mutate = false;  ///< expects the results of a mutant: most programs must fail
  std::string failures; ///< a folder for texts and pictures of failing programs; empty: none
};

struct Failure {
  std::uint64_t seed = 0;
  std::string reason; ///< one line
};

struct Report {
  std::string renderer;
  int programs = 0;
  std::uint64_t compared = 0; ///< values
  std::uint64_t skipped = 0;  ///< values whose tolerances are too large
  /// Largest error of the passing programs, relative to the allowed one
  float worst = 0;
  std::vector<Failure> failures;
};

/// Begins a report with the renderer's name, and makes the target. Returns false, with a failure in
/// the report, on a host without float buffers.
[[nodiscard]] bool begin(Report &report, FloatTarget &target);

/// Draws each program, and compares each pixel with the interpreter.
[[nodiscard]] Report runSuite(Backend &backend, const SuiteOptions &options);

/// Writes the drawn picture beside the expected one.
void writeFailure(const std::string &folder, std::uint64_t seed, const std::string &text,
                  const std::string &reason, const std::vector<float> &seen,
                  const std::vector<float> &expected);

} // namespace arbiter::differential
