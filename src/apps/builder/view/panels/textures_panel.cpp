#include "apps/builder/view/panels/textures_panel.h"

#include <QBoxLayout>
#include <QComboBox>
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

#include "apps/builder/model/panels/clauses.h"
#include "apps/builder/view/panels/beside.h"
#include "apps/builder/view/panels/cube_dialog.h"
#include "apps/builder/view/panels/flow_row.h"

namespace arbiter::builder {

namespace {

constexpr int kTextureSide = 64;
constexpr int kUnits = 16;

/// Returns a thumbnail; a blank one if the image cannot be shown flat, or has not come yet.
QIcon textureIcon(const QImage &image) {
  QPixmap pixmap(kTextureSide, kTextureSide);
  if (!image.isNull()) {
    pixmap = QPixmap::fromImage(image.scaled(kTextureSide, kTextureSide, Qt::KeepAspectRatio));
  } else {
    QPainter painter(&pixmap);
    for (int y = 0; y < kTextureSide; y += 8)
      for (int x = 0; x < kTextureSide; x += 8)
        painter.fillRect(x, y, 8, 8,
                         (x + y) / 8 % 2 ? QColor(0x70, 0x70, 0x70) : QColor(0x98, 0x98, 0x98));
  }
  return pixmap;
}

} // namespace

TexturesPanel::TexturesPanel(Workbench &bench) : m_bench(bench), m_tool(bench.places().arbiter) {
  auto *layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 4, 6, 4);
  auto *label = new QLabel(tr("&Unit"));
  m_unit = new QSpinBox;
  m_unit->setRange(0, kUnits - 1);
  label->setBuddy(m_unit);
  m_unit->setObjectName(QStringLiteral("texture-unit"));
  auto *file = new QPushButton(tr("&File..."));
  file->setObjectName(QStringLiteral("texture-file"));
  auto *cube = new QPushButton(tr("Cu&be..."));
  cube->setObjectName(QStringLiteral("texture-cube"));
  cube->setToolTip(tr("A cube map of six files"));
  auto *generate = new QToolButton;
  generate->setText(tr("&Generate"));
  generate->setPopupMode(QToolButton::InstantPopup);
  generate->setFocusPolicy(Qt::StrongFocus);
  auto *menu = new QMenu(generate);
  menu->setObjectName(QStringLiteral("texture-generators"));
  fillMenu(menu);
  generate->setMenu(menu);
  m_filter = samplerBox(Sampler::Filter, "texture-filter");
  m_wrap = samplerBox(Sampler::Wrap, "texture-wrap");
  auto *row = new FlowRow;
  row->add({label, m_unit});
  row->add({file, cube, generate});
  row->add({m_filter, m_wrap});
  m_list = new QListWidget;
  m_list->setIconSize({kTextureSide, kTextureSide});
  m_list->setAccessibleName(tr("Texture units"));
  m_list->setWordWrap(true);
  layout->addWidget(row);
  layout->addWidget(m_list, 1);
  connect(file, &QPushButton::clicked, this, [this] { chooseFile(); });
  connect(cube, &QPushButton::clicked, this, [this] { chooseCube(); });
  connect(m_unit, &QSpinBox::valueChanged, this, [this] { showSampler(); });
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
    auto *item = new QListWidgetItem(textureIcon(m_thumbnails.value(line.source)),
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
  showSampler();
  nextThumbnail();
}

/// Adds the generators that need no input, the cube maps, and those that begin from the unit's
/// image.
void TexturesPanel::fillMenu(QMenu *menu) {
  const auto add = [&](const QString &title, const std::function<QString()> &source) {
    connect(menu->addAction(title), &QAction::triggered, this,
            [this, source] { setSource(source()); });
  };
  for (const GeneratorWord &word : generators())
    add(word.word + QStringLiteral(" - ") + word.meaning,
        [word] { return word.word + QStringLiteral(" 256 256"); });
  for (const char *cube : {"sky 128", "normalize 64"}) {
    QString source = QString::fromLatin1(cube);
    add(tr("%1 - a cube map").arg(source.section(u' ', 0, 0)), [source] { return source; });
  }
  menu->addSeparator();
  const auto inner = [this](const QString &otherwise) {
    const TextureLine *line = lineOfUnit();
    return line && line->hasSides ? line->source : otherwise;
  };
  add(tr("normals of the unit's heights"), [inner] {
    return QStringLiteral("normals strength 2 of ") + inner(QStringLiteral("bumps 256 256"));
  });
  add(tr("feedback: the last frame, at first the unit's image"),
      [inner] { return QStringLiteral("feedback of ") + inner(QStringLiteral("noise 256 256")); });
}

QComboBox *TexturesPanel::samplerBox(Sampler kind, const char *name) {
  auto *box = new QComboBox;
  box->setObjectName(QLatin1StringView(name));
  box->setAccessibleName(kind == Sampler::Filter ? tr("Filter") : tr("Wrap"));
  box->addItems(samplerWords(kind));
  connect(box, &QComboBox::textActivated, this, [this, kind](const QString &word) {
    const Edit edit = setSampler(m_bench.document().text(), unit(), kind, word);
    if (edit.removed != edit.added)
      m_bench.document().apply({edit}, tr("unit %1: %2").arg(unit()).arg(word));
  });
  return box;
}

const TextureLine *TexturesPanel::lineOfUnit() const {
  for (const TextureLine &line : m_lines)
    if (line.unit == unit())
      return &line;
  return nullptr;
}

void TexturesPanel::showSampler() {
  const TextureLine *line = lineOfUnit();
  m_filter->setEnabled(line);
  m_wrap->setEnabled(line);
  if (!line)
    return;
  m_filter->setCurrentText(line->filter);
  m_wrap->setCurrentText(line->wrap);
}

void TexturesPanel::nextThumbnail() {
  if (m_tool.isRunning() || m_wanted.isEmpty())
    return;
  const QString source = m_wanted.takeFirst();
  m_thumbnails.insert(source, {});
  Scene scene = m_bench.scene();
  scene.text = thumbnailDocument(source, kTextureSide);
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
                   m_list->item(i)->setIcon(textureIcon(m_thumbnails[source]));
               // This is queued, as the current run has not ended yet.
               QMetaObject::invokeMethod(
                   this, [this] { nextThumbnail(); }, Qt::QueuedConnection);
             });
}

int TexturesPanel::unit() const { return m_unit->value(); }

void TexturesPanel::setSource(const QString &source) {
  const Edit edit = setTexture(m_bench.document().text(), unit(), source);
  m_bench.document().apply({edit}, tr("texture of unit %1").arg(unit()));
}

void TexturesPanel::chooseFile() {
  const QString path = QFileDialog::getOpenFileName(this, tr("Image of unit %1").arg(unit()),
                                                    m_bench.file().folder(), imageFilter());
  const QString name = path.isEmpty() ? QString() : nameBeside(this, m_bench, path);
  if (!name.isEmpty())
    setSource(quotedName(name));
}

void TexturesPanel::chooseCube() {
  CubeDialog dialog(m_bench, unit(), this);
  if (dialog.exec() == QDialog::Accepted)
    setSource(dialog.source());
}

} // namespace arbiter::builder
