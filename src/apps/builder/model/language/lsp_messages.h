#pragma once
#include <QByteArray>
#include <QJsonObject>
#include <QList>

namespace arbiter::builder {

/// Splits a byte stream into messages of the language server protocol: header lines with
/// Content-Length, an empty line, and that many bytes.
class LspMessages {
public:
  static constexpr qint64 kMaxBytes = 64 << 20;

  /// Returns the complete messages; skips what is not a JSON object.
  [[nodiscard]] QList<QJsonObject> take(const QByteArray &bytes);
  /// True if the stream is unusable because a header has no valid length.
  [[nodiscard]] bool broken() const { return m_broken; }
  void clear();

  [[nodiscard]] static QByteArray frame(const QJsonObject &message);

private:
  QByteArray m_buffer;
  bool m_broken = false;
};

} // namespace arbiter::builder
