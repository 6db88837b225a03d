#include "apps/builder/model/text/open_file.h"

#include <QDir>
#include <QFileInfo>
#include <cmath>

#include "apps/builder/model/text/merge.h"

namespace arbiter::builder {

namespace {
constexpr int kSyncMilliseconds = 1000;
/// A journal of this size is restarted with the present text.
constexpr qint64 kMaxJournal = 8 << 20;
} // namespace

OpenFile::OpenFile(const QString &journals, QObject *parent)
    : QObject(parent), m_journal(journals), m_folder(QDir::currentPath()) {
  connect(&m_document, &Document::edited, this, &OpenFile::journal);
  connect(&m_watch, &FileWatch::changed, this, &OpenFile::outsideChange);
  connect(&m_watch, &FileWatch::removed, this, &OpenFile::fileRemoved);
  m_sync.setSingleShot(true);
  m_sync.setInterval(kSyncMilliseconds);
  connect(&m_sync, &QTimer::timeout, this, [this] { m_journal.sync(); });
}

OpenFile::~OpenFile() = default;

QString OpenFile::name() const {
  return m_path.isEmpty() ? tr("untitled") : QFileInfo(m_path).fileName();
}

QString OpenFile::proposedName() const {
  if (!m_path.isEmpty())
    return name();
  return m_proposed.isEmpty() ? QStringLiteral("untitled.fp") : m_proposed;
}

QString OpenFile::folder() const {
  return m_path.isEmpty() ? m_folder : QFileInfo(m_path).absolutePath();
}

void OpenFile::begin(const QString &path, const TextFile &file) {
  m_path = path;
  m_format = file.format;
  m_journals = false;
  m_journal.close();
  m_watch.setKnown(encodeText(file.text, file.format));
  m_watch.watch(path);
  m_opening = true;
  m_document.open(file.text);
  m_opening = false;
  Q_EMIT pathChanged(path);
}

Result<QString, FileFault> OpenFile::open(const QString &path) {
  const QString absolute = QFileInfo(path).absoluteFilePath();
  auto file = readText(absolute);
  if (!file)
    return file.error();
  begin(absolute, file.value());
  return absolute;
}

void OpenFile::openText(const QString &text, const QString &folder, const QString &proposed) {
  m_folder = folder.isEmpty() ? QDir::currentPath() : folder;
  m_proposed = proposed;
  begin({}, {text, {}});
}

void OpenFile::recover(const Recovered &recovered) {
  if (recovered.path.isEmpty() || !open(recovered.path))
    openText({});
  m_document.become(recovered.text, Origin::Tool, tr("recovery"));
  Journal::discard(recovered);
}

Result<QString, FileFault> OpenFile::save(const QString &path) {
  const QString target = path.isEmpty() ? m_path : QFileInfo(path).absoluteFilePath();
  if (target.isEmpty())
    return FileFault{tr("the document has no name yet: save it as a file")};
  auto written = writeText(target, m_document.text(), m_format);
  if (!written)
    return written.error();
  m_watch.setKnown(written.value());
  if (target != m_path) {
    m_path = target;
    Q_EMIT pathChanged(target);
  }
  m_watch.watch(m_path);
  m_journal.close();
  m_journals = false;
  m_document.markSaved();
  return target;
}

/// Records an edit. The journal begins at the first change, with the text before it.
void OpenFile::journal(const Edit &edit) {
  if (m_opening)
    return;
  if (!m_journals || m_journal.bytes() > kMaxJournal) {
    QString before = m_document.text();
    before.replace(edit.at, edit.added.size(), edit.removed);
    const auto begun = m_journal.begin(m_path, before);
    if (!begun)
      Q_EMIT complaint(begun.error().message);
    m_journals = true;
  }
  if (!m_journal.record(edit))
    Q_EMIT complaint(tr("the journal cannot be written: unsaved text is not kept"));
  if (!m_sync.isActive())
    m_sync.start();
}

void OpenFile::outsideChange(const QByteArray &bytes) {
  const TextFile theirs = decodeText(bytes);
  const QString before = m_document.text();
  const Merge merge = mergeTexts(m_document.savedText(), before, theirs.text);
  if (merge.conflicts > 0) {
    Q_EMIT conflict(theirs.text);
    return;
  }
  m_format = theirs.format;
  m_document.become(merge.text, Origin::Outside, tr("change by another program"));
  m_document.setSavedText(theirs.text);
  Q_EMIT merged(int(std::abs(merge.text.count(u'\n') - before.count(u'\n'))));
}

void OpenFile::takeTheirs(const QString &theirs) {
  m_document.become(theirs, Origin::Outside, tr("the file's text"));
  m_document.setSavedText(theirs);
}

} // namespace arbiter::builder
