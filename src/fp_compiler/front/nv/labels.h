#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "fp_compiler/front/nv/statement.h"
#include "fp_compiler/front/reporter.h"

namespace arbiter::fp::nv {

/// The labels that BRA and CAL name, for programs under NVIDIA's options and in its own languages.
class Labels {
public:
  Labels(std::string_view text, Reporter &reporter) : m_text(text), m_reporter(reporter) {}

  /// Returns the number of the label of that name. Statements have 16 bits for it. If there are
  /// more labels, reports an error and returns some number.
  [[nodiscard]] std::uint16_t numberOf(Span name);
  /// Returns the statement of a label that is placed here. Reports an error if the label is already
  /// placed.
  [[nodiscard]] Statement place(Span name);
  /// Reports an error for each label that is used but never placed.
  void check() const;
  /// Returns the label at which the program begins, if it has one.
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
