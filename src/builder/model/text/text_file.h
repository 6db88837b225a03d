#pragma once
#include <QByteArray>
#include <QIODevice>
#include <QString>

#include "util/result.h"

namespace arbiter::builder {

/// How a file writes its text, kept from opening to saving.
struct TextFormat {
  bool latin1 = false; ///< its bytes are no UTF-8
  bool crlf = false;   ///< its first line ends so
};

struct TextFile {
  QString text; ///< lines end with \n alone
  TextFormat format;
};

/// A file of the file system, with a reason that a person can act on.
struct FileFault {
  QString message;
};

/// Texts over this many bytes are no programs and are not opened.
inline constexpr qint64 kMaxTextBytes = 16 << 20;

/// Reads at most that many bytes, in parts: QIODevice::read() allocates all that it is asked for,
/// whatever there is.
[[nodiscard]] QByteArray readAtMost(QIODevice &device, qint64 most);
[[nodiscard]] Result<TextFile, FileFault> readText(const QString &path);
[[nodiscard]] TextFile decodeText(const QByteArray &bytes);
/// Text that Latin-1 has no letters for becomes UTF-8.
[[nodiscard]] QByteArray encodeText(const QString &text, TextFormat format);

/// Writes all or nothing: a file beside it takes its place when it is on the disk.
[[nodiscard]] Result<QByteArray, FileFault> writeText(const QString &path, const QString &text,
                                                      TextFormat format);

} // namespace arbiter::builder
