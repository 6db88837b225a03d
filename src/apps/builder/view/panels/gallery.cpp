#include "apps/builder/view/panels/gallery.h"

#include <QCryptographicHash>
#include <QDirIterator>
#include <QPainter>
#include <QStandardPaths>

#include "apps/builder/view/theme.h"
#include "apps/scene/panel/panel.h"

namespace arbiter::builder {

namespace {

constexpr int kSide = 88; ///< a row of pictures and names fits the panel's initial size
constexpr int kMaxDocuments = 200;
constexpr int kPathRole = Qt::UserRole;

struct Entry {
  QString path, title;
};

QString titleOf(const QString &path, const QString &text) {
  const scene::Panel panel = scene::parsePanel(text.toStdString());
  const QString title = QString::fromStdString(panel.title.text);
  return title.isEmpty() ? QFileInfo(path).completeBaseName().replace(u'_', u' ') : title;
}

/// Returns the documents: texts with a panel that no other text in their folder names.
QList<Entry> documentsIn(const QString &folder) {
  QList<Entry> all;
  if (folder.isEmpty())
    return all;
  QDirIterator files(folder, {QStringLiteral("*.fp"), QStringLiteral("*.atifs")}, QDir::Files,
                     QDirIterator::Subdirectories);
  while (files.hasNext() && all.size() < kMaxDocuments) {
    const QString path = files.next();
    const auto file = readText(path);
    if (file && scene::parsePanel(file.value().text.toStdString()).title.written())
      all << Entry{path, titleOf(path, file.value().text)};
  }
  std::sort(all.begin(), all.end(),
            [](const Entry &a, const Entry &b) { return a.title.localeAwareCompare(b.title) < 0; });
  return all;
}

/// Returns the cache file of a document's picture, named by its path and time.
QString cacheOf(const QString &path) {
  const QFileInfo file(path);
  const QByteArray key = (path + file.lastModified().toString(Qt::ISODateWithMs)).toUtf8();
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::GenericCacheLocation) +
                         QStringLiteral("/arbiter-builder/gallery");
  QDir().mkpath(folder);
  return folder + u'/' +
         QString::fromLatin1(QCryptographicHash::hash(key, QCryptographicHash::Sha1).toHex()) +
         QStringLiteral(".png");
}

QIcon iconOf(const QImage &image) {
  QPixmap pixmap(kSide, kSide);
  pixmap.fill(colors().line);
  if (!image.isNull()) {
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    const QImage small = image.scaled(kSide, kSide, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    painter.fillRect(QRect((kSide - small.width()) / 2, (kSide - small.height()) / 2, small.width(),
                           small.height()),
                     Qt::black);
    painter.drawImage((kSide - small.width()) / 2, (kSide - small.height()) / 2, small);
  }
  return pixmap;
}

} // namespace

Gallery::Gallery(Workbench &bench, std::function<void(const QString &)> open)
    : m_bench(bench), m_tool(bench.places().arbiter) {
  setViewMode(IconMode);
  setIconSize({kSide, kSide});
  setGridSize({kSide + 68, kSide + 44});
  setResizeMode(Adjust);
  setMovement(Static);
  setWordWrap(true);
  setAccessibleName(tr("Gallery"));
  connect(this, &QListWidget::itemActivated, this, [open = std::move(open)](QListWidgetItem *item) {
    if (const QString path = item->data(kPathRole).toString(); !path.isEmpty())
      open(path);
  });
}

void Gallery::showEvent(QShowEvent *event) {
  QListWidget::showEvent(event);
  if (count() == 0)
    fill();
}

void Gallery::fill() {
  for (const Entry &entry : documentsIn(m_bench.places().gallery)) {
    QImage image;
    if (!image.load(cacheOf(entry.path)))
      m_wanted << count();
    auto *item = new QListWidgetItem(iconOf(image), entry.title, this);
    item->setData(kPathRole, entry.path);
    item->setToolTip(entry.path);
  }
  if (count() == 0)
    addItem(tr("no documents are installed"));
  else
    setCurrentRow(0);
  nextPicture();
}

void Gallery::nextPicture() {
  if (m_tool.isRunning() || m_wanted.isEmpty())
    return;
  const int row = m_wanted.takeFirst();
  const QString path = item(row)->data(kPathRole).toString();
  const QString cache = cacheOf(path);
  m_tool.run({QStringLiteral("draw"), path, QStringLiteral("-o"), cache}, {},
             [this, row, cache](const ToolResult &) {
               if (QImage image; item(row) && image.load(cache))
                 item(row)->setIcon(iconOf(image));
               QMetaObject::invokeMethod(
                   this, [this] { nextPicture(); }, Qt::QueuedConnection);
             });
}

} // namespace arbiter::builder
