#include "apps/builder/view/panels/attach_panel.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QFileDialog>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSplitter>
#include <QTabWidget>

#include "apps/builder/view/panels/attached_text.h"
#include "apps/builder/view/panels/attached_values.h"
#include "apps/builder/view/panels/table.h"
#include "apps/builder/view/picture/picture_view.h"
#include "apps/builder/view/theme.h"

namespace arbiter::builder {

namespace {

enum Column { kProgram, kDrawer, kDraws, kTime, kPixels, kFrameTime, kMarks, kColumns };

/// Shortens an id to the part that distinguishes it; the tool tip has all of it.
QString shortId(const QString &id) {
  const qsizetype dot = id.lastIndexOf(u'.');
  return id.left(8) + (dot < 0 ? QString() : id.mid(dot));
}

QString marksOf(const AttachedProgram &program) {
  QStringList marks;
  if (program.edited)
    marks << QObject::tr("edited");
  if (program.replaced)
    marks << QObject::tr("replaced");
  if (!program.enabled)
    marks << QObject::tr("off");
  if (!program.underNativeLimits)
    marks << QObject::tr("over native limits");
  return marks.join(QStringLiteral(", "));
}

} // namespace

AttachPanel::AttachPanel(Attachment &attachment) : m_attachment(attachment) {
  m_programs = new Table({tr("Program"), tr("Drawn by"), tr("Draws"), tr("ms"), tr("Pixels/frame"),
                          tr("ms/frame"), tr("Marks")});
  m_programs->setObjectName(QStringLiteral("attached-programs"));
  m_programs->setAccessibleName(tr("Programs of the application"));
  m_programs->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  m_picture = new PictureView;
  m_picture->setAccessibleName(tr("The application's frame"));
  m_picture->setToolTip(tr("A click traces the program that gave the pixel its colour"));
  m_text = new AttachedText(m_attachment);
  m_values = new AttachedValues(m_attachment);
  m_textures = new QListWidget;
  m_textures->setObjectName(QStringLiteral("attached-textures"));
  m_textures->setAccessibleName(tr("Textures of the application"));
  m_textures->setIconSize({64, 64});
  m_tabs = new QTabWidget;
  m_tabs->setAccessibleName(tr("Of the chosen program"));
  m_tabs->addTab(m_text, tr("Te&xt"));
  m_tabs->addTab(m_values, tr("P&arameters"));
  m_tabs->addTab(m_textures, tr("Text&ures"));
  auto *above = new QSplitter(Qt::Horizontal);
  above->addWidget(m_programs);
  above->addWidget(m_picture);
  above->setSizes({330, 300});
  auto *split = new QSplitter(Qt::Vertical);
  split->addWidget(above);
  split->addWidget(m_tabs);
  split->setSizes({200, 250});
  m_said = new QLabel;
  m_said->setWordWrap(true);
  m_said->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto *layout = new QVBoxLayout(this);
  layout->setContentsMargins(6, 4, 6, 4);
  layout->addWidget(buildBar());
  layout->addWidget(split, 1);
  layout->addWidget(m_said);

  connect(m_programs, &QTableWidget::currentCellChanged, this, [this](int row) { choose(row); });
  connect(m_picture, &PictureView::pixelPicked, this,
          [this](QPoint pixel) { m_attachment.tracePixel(pixel); });
  connect(&m_attachment, &Attachment::attachedChanged, this, [this] { showState(); });
  connect(&m_attachment, &Attachment::programsChanged, this, [this] { showPrograms(); });
  connect(&m_attachment, &Attachment::texturesChanged, this, [this] { showTextures(); });
  connect(&m_attachment, &Attachment::troubled, this, [this](const QString &why) { say(why); });
  connect(&m_attachment, &Attachment::busy, this, [this](double milliseconds) {
    say(tr("the application has not answered for %1 s").arg(milliseconds / 1000, 0, 'f', 1));
    m_saidBusy = true;
  });
  connect(&m_attachment, &Attachment::exported, this, [this](const QString &folder, int programs) {
    say(tr("%1 programs in %2; arbiter run --replace %2 draws with them")
            .arg(programs)
            .arg(folder));
  });
  connect(&m_attachment, &Attachment::pictureChanged, this, [this] {
    m_picture->setPicture(m_attachment.picture());
    m_picture->setMark(m_attachment.tracedPixel());
  });
  showState();
}

QWidget *AttachPanel::buildBar() {
  auto *bar = new QWidget;
  auto *layout = new QHBoxLayout(bar);
  layout->setContentsMargins(0, 0, 0, 0);
  m_process = new QComboBox;
  m_process->setObjectName(QStringLiteral("attached-process"));
  m_process->setAccessibleName(tr("Processes that listen"));
  m_process->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  auto *again = new QPushButton(tr("&Look again"));
  m_attach = new QPushButton(tr("A&ttach"));
  m_attach->setObjectName(QStringLiteral("attach"));
  m_measure = new QPushButton(tr("&Measure"));
  m_measure->setToolTip(tr("Pixels and milliseconds of each program in one frame, drawn by the "
                           "host"));
  m_export = new QPushButton(tr("&Export..."));
  m_export->setToolTip(tr("Every text as it is drawn with, for arbiter run --replace"));
  layout->addWidget(m_process, 1);
  for (QPushButton *button : {again, m_attach, m_measure, m_export})
    layout->addWidget(button);
  connect(again, &QPushButton::clicked, this, [this] { listProcesses(); });
  connect(m_attach, &QPushButton::clicked, this, [this] { attachOrDetach(); });
  connect(m_measure, &QPushButton::clicked, this, [this] { m_attachment.measure(); });
  connect(m_export, &QPushButton::clicked, this, [this] { askExport(); });
  return bar;
}

void AttachPanel::say(const QString &text) {
  m_said->setText(text);
  m_said->setVisible(!text.isEmpty());
  m_saidBusy = false;
}

void AttachPanel::listProcesses() {
  QString why;
  m_processes = listeningProcesses(&why);
  m_process->clear();
  for (const ListeningProcess &each : m_processes)
    m_process->addItem(tr("%1, process %2").arg(each.name).arg(each.process));
  if (m_processes.isEmpty())
    say(why.isEmpty() ? tr("No application listens. Start one with "
                           "arbiter run --control -- COMMAND, then look again.")
                      : why);
  else
    say({});
  showState();
}

void AttachPanel::attachOrDetach() {
  if (m_attachment.isAttached())
    return m_attachment.detach();
  const int at = m_process->currentIndex();
  if (at < 0 || at >= m_processes.size())
    return listProcesses();
  say({});
  m_attachment.attach(m_processes[at]);
}

void AttachPanel::attachTo(qint64 process) {
  listProcesses();
  for (int at = 0; at < m_processes.size(); ++at)
    if (m_processes[at].process == process) {
      m_process->setCurrentIndex(at);
      return attachOrDetach();
    }
  say(tr("process %1 does not listen: start it under arbiter run --control -- COMMAND")
          .arg(process));
}

void AttachPanel::askExport() {
  if (!m_attachment.isAttached())
    return say(tr("attach to an application first"));
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder of replacements"));
  if (!folder.isEmpty())
    m_attachment.exportTo(folder);
}

void AttachPanel::showState() {
  const bool attached = m_attachment.isAttached();
  m_attach->setText(attached ? tr("De&tach") : tr("A&ttach"));
  m_attach->setEnabled(attached || !m_processes.isEmpty());
  m_process->setEnabled(!attached);
  for (QWidget *widget : {static_cast<QWidget *>(m_measure), static_cast<QWidget *>(m_export),
                          static_cast<QWidget *>(m_tabs)})
    widget->setEnabled(attached);
  if (attached)
    return;
  m_picture->setPicture({});
  m_picture->setMark({});
  showPrograms();
  showTextures();
}

void AttachPanel::showPrograms() {
  if (m_saidBusy)
    say({});
  const QSignalBlocker block(m_programs);
  const QList<AttachedProgram> &programs = m_attachment.programs();
  m_programs->setRowCount(int(programs.size()));
  int chosen = -1;
  for (int row = 0; row < programs.size(); ++row) {
    const AttachedProgram &program = programs[row];
    if (program.id == m_attachment.selected())
      chosen = row;
    m_programs->put(row, kProgram, shortId(program.id))->setToolTip(program.id);
    m_programs->put(row, kDrawer, program.drawer());
    m_programs->put(row, kDraws, QString::number(program.draws));
    m_programs->put(row, kTime, QString::number(program.milliseconds, 'f', 1));
    const auto &measured = program.measured;
    m_programs->put(row, kPixels,
                    !measured          ? QString()
                    : measured->pixels ? QString::number(*measured->pixels)
                                       : tr("not counted"));
    m_programs->put(row, kFrameTime,
                    measured ? QString::number(measured->milliseconds, 'f', 3) : QString());
    m_programs->put(row, kMarks, marksOf(program));
  }
  m_programs->setCurrentCell(chosen, kProgram);
  if (chosen < 0 && !programs.isEmpty() && m_attachment.selected().isEmpty())
    choose(0);
}

void AttachPanel::choose(int row) {
  const QList<AttachedProgram> &programs = m_attachment.programs();
  if (row < 0 || row >= programs.size() || programs[row].id == m_attachment.selected())
    return;
  const QString id = programs[row].id; // the list is rebuilt
  m_attachment.select(id);
}

void AttachPanel::showTextures() {
  const QList<AttachedTexture> &textures = m_attachment.textures();
  const int current = m_textures->currentRow();
  m_textures->clear();
  for (const AttachedTexture &texture : textures) {
    QPixmap pixmap(64, 64);
    pixmap.fill(Qt::transparent);
    if (!texture.image.isNull())
      pixmap = QPixmap::fromImage(texture.image.scaled(64, 64, Qt::KeepAspectRatio));
    m_textures->addItem(new QListWidgetItem(pixmap, tr("unit %1: texture %2, %3\n%4x%5, %6")
                                                        .arg(texture.unit)
                                                        .arg(texture.name)
                                                        .arg(texture.target)
                                                        .arg(texture.width)
                                                        .arg(texture.height)
                                                        .arg(texture.format)));
  }
  m_textures->setCurrentRow(current);
}

void AttachPanel::showEvent(QShowEvent *event) {
  QWidget::showEvent(event);
  m_attachment.setWatched(true);
  if (!m_attachment.isAttached())
    listProcesses();
}

void AttachPanel::hideEvent(QHideEvent *event) {
  QWidget::hideEvent(event);
  m_attachment.setWatched(false);
}

} // namespace arbiter::builder
