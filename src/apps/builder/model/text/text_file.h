#pragma once
#include <QByteArray>
#include <QIODevice>
#include <QString>

#include "util/result.h"

namespace arbiter::builder {

/// The format of a file's text, kept from opening to saving.
struct TextFormat {
  bool latin1 = false; ///< its bytes are not UTF-8
  bool crlf = false;   ///< its first line ends with \r\n
};

struct TextFile {
  QString text; ///< lines end with \n only
  TextFormat format;
};

/// A file system error, with a reason that a person can act on.
struct FileFault {
  QString message;
};

/// The largest text in bytes that is opened; no program is larger.
inline constexpr qint64 kMaxTextBytes = 16 << 20;

/// Reads at most that many bytes, in parts: QIODevice::read() allocates the whole requested size,
/// whatever there is.
[[nodiscard]] QByteArray readAtMost(QIODevice &device, qint64 most);
[[nodiscard]] Result<TextFile, FileFault> readText(const QString &path);
[[nodiscard]] TextFile decodeText(const QByteArray &bytes);
/// Encodes a text in its format. A text with characters outside Latin-1 becomes UTF-8.
[[nodiscard]] QByteArray encodeText(const QString &text, TextFormat format);

/// Writes all or nothing: a temporary file replaces the file once it is on the disk.
[[nodiscard]] Result<QByteArray, FileFault> writeText(const QString &path, const QString &text,
                                                      TextFormat format);

} // namespace arbiter::builder
