#pragma once
#include <QString>
#include <cstdint>
#include <string>
#include <vector>

namespace arbiter::builder {

/// Maps the bytes of a text in UTF-8 to UTF-16 units: the project's libraries count bytes.
class UtfMap {
public:
  explicit UtfMap(const QString &text) : m_bytes(text.toStdString()) {
    if (std::size_t(text.size()) == m_bytes.size())
      return; // each byte is one unit
    m_units.reserve(m_bytes.size() + 1);
    qsizetype unit = 0;
    for (const char c : m_bytes) {
      const auto byte = static_cast<unsigned char>(c);
      m_units.push_back(unit);
      if ((byte & 0xC0) != 0x80)
        unit += byte >= 0xF0 ? 2 : 1;
    }
    m_units.push_back(unit);
  }

  [[nodiscard]] const std::string &bytes() const { return m_bytes; }
  /// Returns the UTF-16 unit at which a character begins; for a byte within it, its end.
  [[nodiscard]] qsizetype unit(std::uint32_t byte) const {
    const std::size_t at = std::min<std::size_t>(byte, m_bytes.size());
    return m_units.empty() ? qsizetype(at) : m_units[at];
  }

private:
  std::string m_bytes;
  std::vector<qsizetype> m_units;
};

} // namespace arbiter::builder
