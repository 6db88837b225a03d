#include "apps/builder/view/window/export_dialog.h"

#include <QDir>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSpinBox>
#include <cmath>

#include "apps/builder/model/panels/scene_settings.h"

namespace arbiter::builder {

namespace {
constexpr int kMaxFrames = 100000;
} // namespace

ExportDialog::ExportDialog(Workbench &bench, const QString &folder, QWidget *parent)
    : QDialog(parent), m_bench(bench), m_export(bench.places().arbiter),
      m_rate(sceneOf(bench.document().text()).rate) {
  setObjectName(QStringLiteral("export-dialog"));
  setWindowTitle(tr("Export a sequence"));
  build(folder);
  connect(&m_export, &SequenceExport::progressed, this, [this](int written, int frames) {
    m_progress->setMaximum(frames);
    m_progress->setValue(written);
    m_state->setText(tr("%1 of %2 frames").arg(written).arg(frames));
  });
  connect(&m_export, &SequenceExport::finished, this,
          [this](const QString &complaint) { ended(complaint); });
  setRunning(false);
}

void ExportDialog::build(const QString &folder) {
  auto *form = new QFormLayout(this);
  const auto named = [](auto *widget, const char *name) {
    widget->setObjectName(QLatin1StringView(name));
    return widget;
  };
  m_first = named(new QSpinBox, "export-first");
  m_first->setRange(0, kMaxFrames);
  m_frames = named(new QSpinBox, "export-frames");
  m_frames->setRange(1, kMaxFrames);
  m_seconds = named(new QDoubleSpinBox, "export-seconds");
  m_seconds->setRange(0.001, kMaxFrames);
  m_seconds->setDecimals(3);
  m_seconds->setSuffix(tr(" s"));
  m_folder = named(new QLineEdit(folder), "export-folder");
  m_folder->setMinimumWidth(280);
  m_name = named(new QLineEdit(QFileInfo(m_bench.file().proposedName()).completeBaseName()),
                 "export-name");
  m_browse = new QPushButton(tr("Browse..."));
  m_progress = named(new QProgressBar, "export-progress");
  m_state = named(new QLabel, "export-state");
  m_state->setWordWrap(true);
  m_start = named(new QPushButton(tr("&Export")), "export-start");
  m_start->setDefault(true);
  m_close = named(new QPushButton(tr("Close")), "export-close");
  m_close->setAutoDefault(false);
  m_browse->setAutoDefault(false);

  auto *where = new QHBoxLayout;
  where->addWidget(m_folder, 1);
  where->addWidget(m_browse);
  auto *buttons = new QHBoxLayout;
  buttons->addStretch();
  buttons->addWidget(m_start);
  buttons->addWidget(m_close);
  form->addRow(tr("&First frame"), m_first);
  form->addRow(tr("F&rames"), m_frames);
  form->addRow(tr("or &seconds, at %1 frames/s").arg(m_rate), m_seconds);
  form->addRow(tr("Folder"), where);
  form->addRow(tr("&Name"), m_name);
  form->addRow(m_progress);
  form->addRow(m_state);
  form->addRow(buttons);
  connect(m_frames, &QSpinBox::valueChanged, this, [this](int frames) {
    const QSignalBlocker block(m_seconds);
    m_seconds->setValue(frames / m_rate);
  });
  connect(m_seconds, &QDoubleSpinBox::valueChanged, this, [this](double seconds) {
    const QSignalBlocker block(m_frames);
    m_frames->setValue(std::max(1, int(std::lround(seconds * m_rate))));
  });
  m_frames->setValue(int(std::lround(m_rate)));
  connect(m_browse, &QPushButton::clicked, this, [this] { browse(); });
  connect(m_start, &QPushButton::clicked, this, [this] { begin(); });
  connect(m_close, &QPushButton::clicked, this, [this] { reject(); });
}

void ExportDialog::browse() {
  const QString folder =
      QFileDialog::getExistingDirectory(this, tr("Folder of the frames"), m_folder->text());
  if (!folder.isEmpty())
    m_folder->setText(folder);
}

SequenceRequest ExportDialog::request() const {
  SequenceRequest wanted;
  wanted.folder = QDir(m_folder->text()).absolutePath();
  wanted.name = m_name->text().trimmed();
  wanted.first = m_first->value();
  wanted.frames = m_frames->value();
  wanted.rate = m_rate;
  return wanted;
}

void ExportDialog::begin() {
  const SequenceRequest wanted = request();
  if (wanted.name.isEmpty() || wanted.name.contains(u'/'))
    return m_state->setText(tr("A name is needed, without a folder: frames are NAME-0000.png."));
  m_state->setText(tr("drawing..."));
  m_progress->setMaximum(wanted.frames);
  m_progress->setValue(0);
  setRunning(true);
  m_export.start(m_bench.scene(), m_bench.renderer().options(), wanted);
}

void ExportDialog::ended(const QString &complaint) {
  setRunning(false);
  const SequenceRequest wanted = request();
  const int written = m_export.written();
  QString text = tr("%1 of %2 frames are written").arg(written).arg(wanted.frames);
  if (written > 0)
    text += tr(": %1 and on").arg(SequenceExport::fileOf(wanted, wanted.first));
  m_state->setText(complaint.isEmpty() ? text : complaint + QStringLiteral("\n") + text);
}

void ExportDialog::setRunning(bool running) {
  for (QWidget *widget : {static_cast<QWidget *>(m_first), static_cast<QWidget *>(m_frames),
                          static_cast<QWidget *>(m_seconds), static_cast<QWidget *>(m_folder),
                          static_cast<QWidget *>(m_name), static_cast<QWidget *>(m_browse),
                          static_cast<QWidget *>(m_start)})
    widget->setEnabled(!running);
  m_close->setText(running ? tr("Stop") : tr("Close"));
  if (running)
    m_close->setFocus();
}

/// Stops a running export before the dialog closes, also for Escape.
void ExportDialog::reject() {
  if (m_export.isRunning())
    m_export.cancel();
  else
    QDialog::reject();
}

} // namespace arbiter::builder
