#pragma once
#include <cstdint>
#include <string>
#include <vector>

/// How many programs of a set take how much of one resource.
namespace arbiter::tools {

struct Histogram {
  struct Bin {
    std::uint32_t first = 0, last = 0; ///< amounts, both included
    std::uint32_t programs = 0;
  };
  std::vector<Bin> bins;
  std::uint32_t limit = 0;
  bool open = false; ///< the last bin holds everything from its `first` up
};

/// \param amounts one a program
/// Bins are as wide as a power of two, so that the limits of cards lie between two of them; one at
/// zero is joined to the first. The axis reaches the limit unless that is far away from what
/// is used, and ends at twice the limit: what is larger is in the last bin.
[[nodiscard]] Histogram histogramOf(const std::vector<std::uint32_t> &amounts, std::uint32_t limit);

/// As an inline drawing with the limit as a line, and the figures as a folded table below.
/// \param what "ALU slots"; plain text
[[nodiscard]] std::string drawing(const Histogram &histogram, const std::string &what);

} // namespace arbiter::tools
