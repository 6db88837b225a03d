#pragma once
#include <cstdint>
#include <string>
#include <vector>

/// Counts the programs of a set by their use of one resource.
namespace arbiter::tools {

struct Histogram {
  struct Bin {
    std::uint32_t first = 0, last = 0; ///< amounts, both included
    std::uint32_t programs = 0;
  };
  std::vector<Bin> bins;
  std::uint32_t limit = 0;
  bool open = false; ///< true if the last bin also counts all larger amounts
};

/// Returns the histogram. A bin's width is a power of two, so that cards' limits lie between two
/// bins. An amount of zero counts in the first bin. The axis reaches the limit unless that is far
/// above all amounts. It ends at twice the limit at most; larger amounts count in the last bin.
/// \param amounts one for each program
[[nodiscard]] Histogram histogramOf(const std::vector<std::uint32_t> &amounts, std::uint32_t limit);

/// Returns an inline drawing with the limit as a line, and the figures as a folded table below.
/// \param what "ALU slots"; plain text
[[nodiscard]] std::string drawing(const Histogram &histogram, const std::string &what);

} // namespace arbiter::tools
