#include "builder/view/panels/textures_panel.h"

#include <QBoxLayout>
#include <QDir>
#include <QFileDialog>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QSpinBox>
#include <QTemporaryFile>
#include <QToolButton>
#include <memory>

namespace arbiter::builder {

namespace {

constexpr int kSide = 64;
constexpr int kUnits = 16;

/// A picture of nothing: a unit whose image cannot be shown flat, or is on its way.
QIcon iconOf(const QImage &image) {
  QPixmap pixmap(kSide, kSide);
  if (!image.isNull()) {
    pixmap = QPixmap::fromImage(image.scaled(kSide, kSide, Qt::KeepAspectRatio));
  } else {
    QPainter painter(&pixmap);
    for (int y = 0; y < kSide; y += 8)
      for (int x = 0; x < kSide; x += 8)
        painter.fillRect(x, y, 8, 8,
                         (x + y) / 8 % 2 ? QColor(0x70, 0x70, 0x70) : QColor(0x98, 0x98, 0x98));
  }
  return pixmap;
}

} // namespace

TexturesPanel::TexturesPanel(Workbench &bench) : m_bench(bench), m_tool(bench.places().arbiter) {
  auto *layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 4, 6, 4);
  auto *row = new QHBoxLayout;
  auto *label = new QLabel(tr("&Unit"));
  m_unit = new QSpinBox;
  m_unit->setRange(0, kUnits - 1);
  label->setBuddy(m_unit);
  auto *file = new QPushButton(tr("&File..."));
  auto *generate = new QToolButton;
  generate->setText(tr("&Generate"));
  generate->setPopupMode(QToolButton::InstantPopup);
  generate->setFocusPolicy(Qt::StrongFocus);
  auto *menu = new QMenu(generate);
  for (const GeneratorWord &word : generators())
    connect(menu->addAction(word.word + QStringLiteral(" - ") + word.meaning), &QAction::triggered,
            this, [this, word] { setSource(word.word + QStringLiteral(" 256 256")); });
  generate->setMenu(menu);
  for (QWidget *widget : {static_cast<QWidget *>(label), static_cast<QWidget *>(m_unit),
                          static_cast<QWidget *>(file), static_cast<QWidget *>(generate)})
    row->addWidget(widget);
  row->addStretch();
  m_list = new QListWidget;
  m_list->setIconSize({kSide, kSide});
  m_list->setAccessibleName(tr("Texture units"));
  m_list->setWordWrap(true);
  layout->addLayout(row);
  layout->addWidget(m_list, 1);
  connect(file, &QPushButton::clicked, this, [this] { chooseFile(); });
  connect(m_list, &QListWidget::currentRowChanged, this, [this](int at) {
    if (at >= 0 && at < m_lines.size())
      m_unit->setValue(m_lines[at].unit);
  });
  connect(&bench.parameters(), &Parameters::linesChanged, this, [this] { read(); });
  read();
}

void TexturesPanel::read() {
  const QList<TextureLine> lines = texturesOf(m_bench.document().text());
  m_lines = lines;
  const int current = m_list->currentRow();
  m_list->clear();
  for (const TextureLine &line : lines) {
    auto *item = new QListWidgetItem(iconOf(m_thumbnails.value(line.source)),
                                     tr("unit %1: %2\n%3, %4; line %5")
                                         .arg(line.unit)
                                         .arg(line.source, line.filter, line.wrap)
                                         .arg(line.line));
    m_list->addItem(item);
    if (!m_thumbnails.contains(line.source) && !m_wanted.contains(line.source))
      m_wanted << line.source;
  }
  if (lines.isEmpty())
    m_list->addItem(tr("No textures yet: choose a unit, then a file or a generator."));
  m_list->setCurrentRow(current);
  nextThumbnail();
}

void TexturesPanel::nextThumbnail() {
  if (m_tool.isRunning() || m_wanted.isEmpty())
    return;
  const QString source = m_wanted.takeFirst();
  m_thumbnails.insert(source, {});
  Scene scene = m_bench.scene();
  scene.text = thumbnailDocument(source, kSide);
  scene.name = QStringLiteral(".thumbnail.fp");
  auto file = std::make_shared<QTemporaryFile>();
  if (!file->open())
    return;
  m_tool.run({QStringLiteral("draw"), QStringLiteral("@"), QStringLiteral("-o"), file->fileName()},
             scene, [this, source, file](const ToolResult &result) {
               if (QImage image; result.code == 0 && image.load(file->fileName(), "PNG"))
                 m_thumbnails[source] = image;
               for (int i = 0; i < m_lines.size(); ++i)
                 if (m_lines[i].source == source && m_list->item(i))
                   m_list->item(i)->setIcon(iconOf(m_thumbnails[source]));
               // Behind the run that ends here.
               QMetaObject::invokeMethod(
                   this, [this] { nextThumbnail(); }, Qt::QueuedConnection);
             });
}

int TexturesPanel::unit() const { return m_unit->value(); }

void TexturesPanel::setSource(const QString &source) {
  const Edit edit = setTexture(m_bench.document().text(), unit(), source);
  m_bench.document().apply({edit}, tr("texture of unit %1").arg(unit()));
}

/// A file beside the document is named as such; another by its whole path.
void TexturesPanel::chooseFile() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Image of unit %1").arg(unit()),
                                                    m_bench.file().folder(),
                                                    tr("Images (*.png *.jpg *.jpeg *.dds)"));
  if (path.isEmpty())
    return;
  const QString relative = QDir(m_bench.file().folder()).relativeFilePath(path);
  setSource(u'"' + (relative.startsWith(u"../") ? path : relative) + u'"');
}

} // namespace arbiter::builder
