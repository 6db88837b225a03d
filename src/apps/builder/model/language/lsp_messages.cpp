#include "apps/builder/model/language/lsp_messages.h"

#include <QJsonDocument>

namespace arbiter::builder {

namespace {

constexpr qsizetype kMaxHeader = 4096;

/// Returns the value of Content-Length; -1 without one.
qint64 lengthOf(const QByteArray &header) {
  for (const QByteArray &line : header.split('\n')) {
    const QByteArray lower = line.trimmed().toLower();
    if (!lower.startsWith("content-length:"))
      continue;
    bool ok = false;
    const qint64 length = lower.mid(15).trimmed().toLongLong(&ok);
    return ok ? length : -1;
  }
  return -1;
}

} // namespace

QList<QJsonObject> LspMessages::take(const QByteArray &bytes) {
  QList<QJsonObject> all;
  m_buffer += bytes;
  while (!m_broken) {
    const qsizetype end = m_buffer.indexOf("\r\n\r\n");
    if (end < 0) {
      m_broken = m_buffer.size() > kMaxHeader;
      break;
    }
    const qint64 length = lengthOf(m_buffer.left(end));
    if (length < 0 || length > kMaxBytes) {
      m_broken = true;
      break;
    }
    if (m_buffer.size() < end + 4 + length)
      break;
    const QJsonDocument json = QJsonDocument::fromJson(m_buffer.mid(end + 4, length));
    m_buffer.remove(0, end + 4 + length);
    if (json.isObject())
      all.append(json.object());
  }
  return all;
}

void LspMessages::clear() {
  m_buffer.clear();
  m_broken = false;
}

QByteArray LspMessages::frame(const QJsonObject &message) {
  const QByteArray body = QJsonDocument(message).toJson(QJsonDocument::Compact);
  return "Content-Length: " + QByteArray::number(body.size()) + "\r\n\r\n" + body;
}

} // namespace arbiter::builder
