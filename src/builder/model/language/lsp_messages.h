#pragma once
#include <QByteArray>
#include <QJsonObject>
#include <QList>

namespace arbiter::builder {

/// Messages of the language server protocol, cut out of a stream of bytes: header lines with
/// Content-Length, an empty line, that many bytes.
class LspMessages {
public:
  static constexpr qint64 kMaxBytes = 64 << 20;

  /// The messages that are whole now; what is no JSON object is passed over.
  [[nodiscard]] QList<QJsonObject> take(const QByteArray &bytes);
  /// The stream cannot be read any further: a header without a usable length.
  [[nodiscard]] bool broken() const { return m_broken; }
  void clear();

  [[nodiscard]] static QByteArray frame(const QJsonObject &message);

private:
  QByteArray m_buffer;
  bool m_broken = false;
};

} // namespace arbiter::builder
