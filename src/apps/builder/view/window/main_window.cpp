#include "apps/builder/view/window/main_window.h"

#include <QApplication>
#include <QBoxLayout>
#include <QCloseEvent>
#include <QDockWidget>
#include <QMenuBar>
#include <QScreen>
#include <QSettings>
#include <QStatusBar>
#include <algorithm>
#include <utility>

#include "apps/builder/model/attach/attachment.h"
#include "apps/builder/view/editor/code_editor.h"
#include "apps/builder/view/panels/attach_panel.h"
#include "apps/builder/view/panels/attached_text.h"
#include "apps/builder/view/panels/compare_panel.h"
#include "apps/builder/view/panels/debug_panel.h"
#include "apps/builder/view/panels/gallery.h"
#include "apps/builder/view/panels/gauges_bar.h"
#include "apps/builder/view/panels/parameters_panel.h"
#include "apps/builder/view/panels/problems_panel.h"
#include "apps/builder/view/panels/scene_panel.h"
#include "apps/builder/view/panels/textures_panel.h"
#include "apps/builder/view/panels/tool_panels.h"
#include "apps/builder/view/panels/words_panel.h"
#include "apps/builder/view/picture/picture_panel.h"
#include "apps/builder/view/picture/picture_view.h"
#include "apps/builder/view/theme.h"
#include "apps/builder/view/window/status_line.h"

namespace arbiter::builder {

namespace {

// These heights are in device-independent pixels.
constexpr int kLeastInside = 60; ///< of a panel
constexpr int kLeastBelow = 110; ///< of a panel below: a header, three rows and a slider
/// The initial height of a panel below, with its tab and title: a row of the gallery.
constexpr int kBelow = 190;
constexpr int kAside = 150;   ///< of a panel under the picture, initially
constexpr int kPicture = 200; ///< of the picture, initially

} // namespace

MainWindow::MainWindow(Places places)
    : m_bench(std::move(places)),
      m_attachment(std::make_unique<Attachment>(m_bench.places().arbiter)) {
  setObjectName(QStringLiteral("MainWindow"));
  setDockNestingEnabled(true);
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  setWindowIcon(applicationIcon());
  buildPanels();
  buildMenus();
  buildStatus();
  resize(1280, 800);
  arrange();
  m_madeLayout = saveState(kLayoutVersion);
  connect(&m_bench, &Workbench::statusChanged, this, [this] { showStatus(); });
  connect(&m_bench, &Workbench::notice, this, [this](const QString &text) { notice(text); });
  connect(&m_bench.document(), &Document::stateChanged, this, [this] { showTitle(); });
  connect(&m_bench.file(), &OpenFile::pathChanged, this, [this] { showTitle(); });
  connect(&m_bench.file(), &OpenFile::conflict, this,
          [this](const QString &theirs) { askConflict(theirs); });
  connect(&m_bench.file(), &OpenFile::merged, this, [this] {
    notice(tr("%1 was changed by another program; the change is here too (Ctrl+Z takes it back)")
               .arg(m_bench.file().name()));
  });
  connect(&m_bench.file(), &OpenFile::fileRemoved, this,
          [this] { notice(tr("%1 is gone; saving writes it anew").arg(m_bench.file().path())); });
  showTitle();
  showStatus();
}

MainWindow::~MainWindow() {
  hide();
  m_bench.disconnect(this);
  m_bench.document().disconnect(this);
  m_bench.file().disconnect(this);
  m_bench.trace().disconnect(this);
  m_attachment->disconnect(this);
  qDeleteAll(std::exchange(m_docks, {}));
}

QDockWidget *MainWindow::addPanel(const QString &name, QWidget *widget, Qt::DockWidgetArea area) {
  auto *dock = new QDockWidget(name, this);
  dock->setObjectName(name);
  // A long label inside must not widen the window.
  widget->setMinimumSize(120, area == Qt::BottomDockWidgetArea ? kLeastBelow : kLeastInside);
  dock->setWidget(widget);
  addDockWidget(area, dock);
  m_docks << dock;
  return dock;
}

void MainWindow::buildPanels() {
  m_editor = new CodeEditor(m_bench);
  auto *text = new QWidget;
  auto *layout = new QVBoxLayout(text);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(new GaugesBar(m_bench));
  layout->addWidget(m_editor, 1);
  m_picture = new PicturePanel(m_bench);
  const auto goTo = [this](qsizetype offset) {
    m_editor->goTo(offset);
    m_editor->setFocus();
  };
  m_problems = new ProblemsPanel(m_bench, goTo);
  m_debug = new DebugPanel(m_bench);
  m_words = new WordsPanel([this](const QString &word) {
    m_editor->textCursor().insertText(word);
    m_editor->setFocus();
  });
  m_gallery = new Gallery(m_bench, [this](const QString &path) { openCopy(path); });
  addPanel(tr("Program"), text, Qt::LeftDockWidgetArea);
  addPanel(tr("Picture"), m_picture, Qt::RightDockWidgetArea);
  addPanel(tr("Parameters"), new ParametersPanel(m_bench), Qt::RightDockWidgetArea);
  addPanel(tr("Textures"), new TexturesPanel(m_bench), Qt::RightDockWidgetArea);
  addPanel(tr("Scene"), new ScenePanel(m_bench, [this](const QString &path) { openInstead(path); }),
           Qt::RightDockWidgetArea);
  addPanel(tr("Problems"), m_problems, Qt::BottomDockWidgetArea);
  addPanel(tr("Debug"), m_debug, Qt::BottomDockWidgetArea);
  addPanel(tr("Advice"), new AdvicePanel(m_bench), Qt::BottomDockWidgetArea);
  addPanel(tr("Native"), new NativePanel(m_bench), Qt::BottomDockWidgetArea);
  addPanel(tr("Compare"), new ComparePanel(m_bench, m_picture->view()), Qt::BottomDockWidgetArea);
  addPanel(tr("Bench"), new BenchPanel(m_bench), Qt::BottomDockWidgetArea);
  addPanel(tr("Words"), m_words, Qt::BottomDockWidgetArea);
  addPanel(tr("Gallery"), m_gallery, Qt::BottomDockWidgetArea);
  buildAttachment();
  connect(&m_picture->view(), &PictureView::pixelPicked, this,
          [this] { dock(tr("Debug"))->raise(); });
  connect(m_editor, &CodeEditor::lineClicked, this,
          [this](int line) { m_bench.trace().runToLine(line); });
  connect(&m_bench, &Workbench::problemsChanged, this, [this] {
    const int count = int(m_bench.problems().size());
    dock(tr("Problems"))
        ->setWindowTitle(count == 0 ? tr("Problems") : tr("Problems %1").arg(count));
  });
}

QDockWidget *MainWindow::dock(const QString &name) const {
  for (QDockWidget *each : m_docks)
    if (each->objectName() == name)
      return each;
  return nullptr;
}

/// Builds the attach panel. A pixel of an application is shown like the document's, and marked in
/// the application's text.
void MainWindow::buildAttachment() {
  m_attach = new AttachPanel(*m_attachment);
  addPanel(tr("Attach"), m_attach, Qt::RightDockWidgetArea);
  Trace &trace = m_bench.trace();
  connect(m_attachment.get(), &Attachment::traced, this, [this, &trace](const QJsonObject &json) {
    m_takesTrace = true;
    m_debug->setApplicationPixel(m_attachment->tracedPixel());
    trace.take(json);
    m_takesTrace = false;
  });
  connect(&trace, &Trace::changed, this, [this] {
    m_tracesApplication = m_takesTrace;
    if (!m_takesTrace)
      m_debug->setApplicationPixel({});
  });
  connect(m_attachment.get(), &Attachment::attachedChanged, this, [this, &trace] {
    if (m_tracesApplication)
      trace.clear();
  });
  connect(&trace, &Trace::moved, this, [this, &trace](int row) {
    const auto &rows = trace.rows();
    const int line = row >= 0 && row < rows.size() ? rows[row].line : 0;
    m_editor->setTracedLine(m_tracesApplication ? 0 : line);
    m_attach->text().setTracedLine(m_tracesApplication ? line : 0);
  });
  connect(m_attachment.get(), &Attachment::troubled, this,
          [this](const QString &why) { notice(why); });
  connect(&m_attach->picture(), &PictureView::pixelPicked, this,
          [this] { dock(tr("Debug"))->raise(); });
}

void MainWindow::arrange() {
  for (QDockWidget *each : m_docks) {
    each->setFloating(false);
    each->show();
  }
  setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
  setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
  QDockWidget *const picture = dock(tr("Picture")), *const parameters = dock(tr("Parameters"));
  QDockWidget *const problems = dock(tr("Problems"));
  splitDockWidget(picture, parameters, Qt::Vertical);
  for (const QString &name : {tr("Textures"), tr("Scene")})
    tabifyDockWidget(parameters, dock(name));
  for (QDockWidget *each : m_docks)
    if (each != problems && dockWidgetArea(each) == Qt::BottomDockWidgetArea)
      tabifyDockWidget(problems, each);
  tabifyDockWidget(picture, dock(tr("Attach")));
  picture->raise();
  parameters->raise();
  problems->raise();
}

/// Gives each dock its initial part of the window: panels below and beside get enough to be read,
/// text and picture the rest.
void MainWindow::share() {
  QDockWidget *const program = dock(tr("Program")), *const picture = dock(tr("Picture"));
  QDockWidget *const parameters = dock(tr("Parameters")), *const problems = dock(tr("Problems"));
  const int whole = height() - menuBar()->height() - statusBar()->height();
  const int below = std::max(kBelow, whole * 28 / 100);
  const int above = std::max(1, whole - below);
  const int aside = std::max(1, std::min(std::max(kAside, above * 3 / 10), above - kPicture));
  resizeDocks({program, picture}, {width() / 2, width() / 2}, Qt::Horizontal);
  resizeDocks({program, problems}, {above, below}, Qt::Vertical);
  resizeDocks({picture, parameters}, {above - aside, aside}, Qt::Vertical);
}

void MainWindow::arrangeAnew() {
  restoreState(m_madeLayout, kLayoutVersion);
  share();
}

/// Shares the space: now the window has its final size, and a saved layout is restored.
void MainWindow::showEvent(QShowEvent *event) {
  QMainWindow::showEvent(event);
  if (std::exchange(m_isShared, true))
    return;
  layout()->activate();
  share();
}

void MainWindow::buildStatus() {
  m_status = new StatusLine(*statusBar(), m_bench);
  connect(m_editor, &CodeEditor::placeChanged, m_status,
          [this](int line, int column) { m_status->setPlace(line, column); });
}

void MainWindow::showStatus() { m_status->showState(); }

void MainWindow::showTitle() {
  setWindowTitle(QStringLiteral("%1[*] - Shader Builder").arg(m_bench.file().name()));
  setWindowModified(m_bench.document().isModified());
  m_docks[0]->setWindowTitle(m_bench.file().name() +
                             (m_bench.document().isModified() ? QStringLiteral("*") : QString()));
}

void MainWindow::notice(const QString &text) { m_status->notice(text); }

QString MainWindow::lastNotice() const { return m_status->lastNotice(); }

QStringList MainWindow::panelNames() {
  return {tr("Program"),  tr("Picture"), tr("Parameters"), tr("Textures"), tr("Scene"),
          tr("Problems"), tr("Debug"),   tr("Advice"),     tr("Native"),   tr("Compare"),
          tr("Bench"),    tr("Words"),   tr("Gallery"),    tr("Attach")};
}

void MainWindow::showPanel(const QString &name) {
  for (QDockWidget *dock : m_docks) {
    if (dock->objectName() != name)
      continue;
    dock->show();
    dock->raise();
    if (QWidget *inside = dock->widget()) {
      QWidget *first = inside->focusPolicy() == Qt::NoFocus ? inside->nextInFocusChain() : inside;
      while (first && first != inside &&
             (first->focusPolicy() == Qt::NoFocus || !first->isVisible()))
        first = first->nextInFocusChain();
      if (name == tr("Program"))
        first = m_editor;
      if (first)
        first->setFocus();
    }
  }
}

void MainWindow::setScheme(const QString &name) {
  applyScheme(*qApp, schemeNamed(name));
  QSettings().setValue(QStringLiteral("scheme"), name);
  m_editor->refreshColors();
  showStatus();
  Q_EMIT m_bench.problemsChanged();
}

void MainWindow::restoreLayout() {
  const QSettings settings;
  if (!restoreGeometry(settings.value(QStringLiteral("geometry")).toByteArray()))
    resize(size().boundedTo(screen()->availableSize()));
  if (restoreState(settings.value(QStringLiteral("layout")).toByteArray(), kLayoutVersion))
    m_isShared = true;
}

void MainWindow::closeEvent(QCloseEvent *event) {
  if (!mayDiscard()) {
    event->ignore();
    return;
  }
  QSettings settings;
  settings.setValue(QStringLiteral("geometry"), saveGeometry());
  settings.setValue(QStringLiteral("layout"), saveState(kLayoutVersion));
  event->accept();
}

} // namespace arbiter::builder
