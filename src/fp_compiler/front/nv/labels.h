#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "fp_compiler/front/nv/statement.h"
#include "fp_compiler/front/reporter.h"

namespace arbiter::fp::nv {

/// The places that BRA and CAL name, of the options' programs and of NVIDIA's own languages.
class Labels {
public:
  Labels(std::string_view text, Reporter &reporter) : m_text(text), m_reporter(reporter) {}

  /// The number of the label of that name. Statements have 16 bits for it: an error, and some
  /// number, where there are more of them.
  [[nodiscard]] std::uint16_t numberOf(Span name);
  /// The statement of a label that stands here; an error if it stood elsewhere too.
  [[nodiscard]] Statement place(Span name);
  /// Errors for labels that are named and stand nowhere.
  void check() const;
  /// The label that the program begins at, if it has one.
  [[nodiscard]] std::optional<std::uint16_t> start() const;

private:
  struct Label {
    Span name;
    bool placed = false;
  };
  [[nodiscard]] std::string_view text(Span span) const {
    return m_text.substr(span.begin, span.end - span.begin);
  }

  std::string_view m_text;
  Reporter &m_reporter;
  std::vector<Label> m_labels;
  std::map<std::string_view, std::uint16_t> m_numbers;
};

} // namespace arbiter::fp::nv
