#include "apps/builder/model/text/text_file.h"

#include <QFile>
#include <QFileInfo>
#include <QSaveFile>
#include <QStringDecoder>
#include <algorithm>

namespace arbiter::builder {

TextFile decodeText(const QByteArray &bytes) {
  TextFile file;
  QStringDecoder decoder(QStringDecoder::Utf8);
  file.text = decoder(bytes);
  if (decoder.hasError()) {
    file.text = QString::fromLatin1(bytes);
    file.format.latin1 = true;
  }
  const qsizetype first = bytes.indexOf('\n');
  file.format.crlf = first > 0 && bytes[first - 1] == '\r';
  file.text.replace(QStringLiteral("\r\n"), QStringLiteral("\n"));
  file.text.replace(u'\r', u'\n');
  return file;
}

QByteArray encodeText(const QString &text, TextFormat format) {
  QString lines = text;
  if (format.crlf)
    lines.replace(u'\n', QStringLiteral("\r\n"));
  const bool fits =
      std::all_of(lines.cbegin(), lines.cend(), [](QChar c) { return c.unicode() < 256; });
  return format.latin1 && fits ? lines.toLatin1() : lines.toUtf8();
}

QByteArray readAtMost(QIODevice &device, qint64 most) {
  constexpr qint64 kPart = 64 << 10;
  QByteArray bytes;
  while (bytes.size() < most) {
    const QByteArray part = device.read(std::min<qint64>(kPart, most - bytes.size()));
    if (part.isEmpty())
      break;
    bytes += part;
  }
  return bytes;
}

Result<TextFile, FileFault> readText(const QString &path) {
  QFile file(path);
  if (QFileInfo(path).isDir())
    return FileFault{path + QStringLiteral(": is a folder; open a program in it")};
  if (!file.open(QIODevice::ReadOnly))
    return FileFault{path + QStringLiteral(": ") + file.errorString()};
  const QByteArray bytes = readAtMost(file, kMaxTextBytes + 1);
  if (bytes.size() > kMaxTextBytes)
    return FileFault{path + QStringLiteral(": is over 16 MiB, too long for a program")};
  if (file.error() != QFileDevice::NoError)
    return FileFault{path + QStringLiteral(": ") + file.errorString()};
  return decodeText(bytes);
}

Result<QByteArray, FileFault> writeText(const QString &path, const QString &text,
                                        TextFormat format) {
  QSaveFile file(path);
  const QByteArray bytes = encodeText(text, format);
  if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.commit())
    return FileFault{path + QStringLiteral(": not saved: ") + file.errorString()};
  return bytes;
}

} // namespace arbiter::builder
