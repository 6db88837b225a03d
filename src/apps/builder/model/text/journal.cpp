#include "apps/builder/model/text/journal.h"

#include <QDateTime>
#include <QDir>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <optional>
#include <sys/file.h>
#include <unistd.h>

namespace arbiter::builder {

namespace {

constexpr int kVersion = 1;

QByteArray line(const QJsonObject &object) {
  return QJsonDocument(object).toJson(QJsonDocument::Compact) + '\n';
}

std::optional<QJsonObject> objectOf(const QByteArray &text) {
  const QJsonDocument json = QJsonDocument::fromJson(text);
  if (!json.isObject())
    return std::nullopt;
  return json.object();
}

/// Applies a line to the document. Returns false if it is not an edit or does not fit the text.
bool replay(const QByteArray &text, QString &document) {
  const auto edit = objectOf(text);
  if (!edit)
    return false;
  const qint64 at = edit->value(u"at").toInteger(-1);
  const qint64 removed = edit->value(u"removed").toInteger(-1);
  if (at < 0 || removed < 0 || at > document.size() || removed > document.size() - at)
    return false;
  document.replace(at, removed, edit->value(u"added").toString());
  return true;
}

std::optional<Recovered> read(const QString &file) {
  QFile journal(file);
  if (!journal.open(QIODevice::ReadOnly))
    return std::nullopt;
  const auto head = objectOf(journal.readLine());
  if (!head || head->value(u"journal").toInt() != kVersion)
    return std::nullopt;
  Recovered recovered{file, head->value(u"path").toString(), head->value(u"text").toString()};
  bool edits = false;
  while (!journal.atEnd() && replay(journal.readLine(), recovered.text))
    edits = true;
  // An untitled document is worth keeping as soon as it has a text.
  if (!edits && !recovered.path.isEmpty())
    return std::nullopt;
  return recovered;
}

/// True if a running process holds the journal.
bool isHeld(const QString &file) {
  const int descriptor = ::open(QFile::encodeName(file).constData(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0)
    return true;
  const bool held = ::flock(descriptor, LOCK_EX | LOCK_NB) != 0;
  ::close(descriptor);
  return held;
}

} // namespace

Result<QString, FileFault> Journal::begin(const QString &path, const QString &text) {
  close();
  if (!QDir().mkpath(m_folder))
    return FileFault{m_folder + QStringLiteral(": cannot be made; unsaved text is not kept")};
  QFile::setPermissions(m_folder, QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
  static int number = 0;
  m_file = QStringLiteral("%1/%2-%3-%4.journal")
               .arg(m_folder)
               .arg(::getpid())
               .arg(QDateTime::currentMSecsSinceEpoch())
               .arg(++number);
  m_descriptor = ::open(QFile::encodeName(m_file).constData(),
                        O_WRONLY | O_CREAT | O_EXCL | O_APPEND | O_CLOEXEC, 0600);
  if (m_descriptor < 0)
    return FileFault{m_file + QStringLiteral(": ") + QString::fromLocal8Bit(std::strerror(errno))};
  ::flock(m_descriptor, LOCK_EX | LOCK_NB);
  m_bytes = 0;
  if (!write(line({{"journal", kVersion}, {"path", path}, {"text", text}})))
    return FileFault{m_file + QStringLiteral(": cannot be written; unsaved text is not kept")};
  return m_file;
}

bool Journal::record(const Edit &edit) {
  return m_descriptor >= 0 &&
         write(line({{"at", edit.at}, {"removed", edit.removed.size()}, {"added", edit.added}}));
}

bool Journal::write(const QByteArray &text) {
  qsizetype done = 0;
  while (done < text.size()) {
    const ssize_t written =
        ::write(m_descriptor, text.constData() + done, std::size_t(text.size() - done));
    if (written < 0 && errno == EINTR)
      continue;
    if (written <= 0)
      return false;
    done += written;
  }
  m_bytes += text.size();
  return true;
}

void Journal::sync() const {
  if (m_descriptor >= 0)
    ::fdatasync(m_descriptor);
}

void Journal::close() {
  if (m_descriptor < 0)
    return;
  ::unlink(QFile::encodeName(m_file).constData());
  ::close(m_descriptor);
  m_descriptor = -1;
}

QList<Recovered> Journal::recoverable(const QString &folder) {
  QList<Recovered> all;
  const QDir dir(folder);
  for (const QString &name :
       dir.entryList({QStringLiteral("*.journal")}, QDir::Files, QDir::Time)) {
    const QString file = dir.filePath(name);
    if (isHeld(file))
      continue;
    if (auto recovered = read(file))
      all.append(*recovered);
  }
  return all;
}

void Journal::discard(const Recovered &recovered) { QFile::remove(recovered.journal); }

} // namespace arbiter::builder
