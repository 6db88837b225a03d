// The window's menus and keys.
#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QDockWidget>
#include <QInputDialog>
#include <QJsonArray>
#include <QKeyEvent>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>
#include <QShortcut>

#include "apps/builder/model/attach/attachment.h"
#include "apps/builder/view/editor/code_editor.h"
#include "apps/builder/view/panels/attach_panel.h"
#include "apps/builder/view/panels/words_panel.h"
#include "apps/builder/view/picture/picture_panel.h"
#include "apps/builder/view/picture/picture_view.h"
#include "apps/builder/view/window/main_window.h"
#include "apps/builder/view/window/pick.h"
#include "fp_compiler/hw/profile.h"
#include "fp_compiler/numerics.h"

namespace arbiter::builder {

QAction *MainWindow::add(QMenu *menu, const QString &text, const QKeySequence &keys,
                         const std::function<void()> &action) {
  QAction *made = menu->addAction(text);
  made->setShortcut(keys);
  connect(made, &QAction::triggered, this, [action] { action(); });
  m_actions << made;
  return made;
}

void MainWindow::buildFileMenu() {
  QMenu *file = menuBar()->addMenu(tr("&File"));
  add(file, tr("&New"), QKeySequence::New, [this] { newFile(); });
  add(file, tr("&Open..."), QKeySequence::Open, [this] { openFile(); });
  add(file, tr("&Gallery"), {}, [this] { showPanel(tr("Gallery")); });
  file->addSeparator();
  add(file, tr("&Save"), QKeySequence::Save, [this] { save(); });
  add(file, tr("Save &as..."), QKeySequence::SaveAs, [this] { saveAs(); });
  add(file, tr("&Export picture..."), QKeySequence(tr("Ctrl+E")), [this] { exportPicture(); });
  add(file, tr("Export se&quence..."), QKeySequence(tr("Ctrl+Shift+E")),
      [this] { exportSequence(); });
  file->addSeparator();
  add(file, tr("&Quit"), QKeySequence::Quit, [this] { close(); });
}

void MainWindow::buildEditMenu() {
  QMenu *edit = menuBar()->addMenu(tr("&Edit"));
  add(edit, tr("&Undo"), QKeySequence::Undo, [this] { m_editor->undoStep(); });
  add(edit, tr("&Redo"), QKeySequence::Redo, [this] { m_editor->redoStep(); });
  edit->addSeparator();
  add(edit, tr("&Complete word"), QKeySequence(tr("Ctrl+Space")), [this] { m_editor->complete(); });
  add(edit, tr("Re&name..."), QKeySequence(tr("F2")), [this] { m_editor->renameName(); });
  add(edit, tr("Go to &definition"), QKeySequence(tr("F12")),
      [this] { m_editor->goToDefinition(); });
  add(edit, tr("Go to na&me..."), QKeySequence(tr("Ctrl+Shift+O")), [this] { goToName(); });
  add(edit, tr("Next &problem"), QKeySequence(tr("F8")), [this] { m_editor->goToProblem(true); });
  add(edit, tr("Pre&vious problem"), QKeySequence(tr("Shift+F8")),
      [this] { m_editor->goToProblem(false); });
  add(edit, tr("&Fix this line"), QKeySequence(tr("Alt+Return")), [this] { m_editor->fixHere(); });
}

void MainWindow::buildSceneMenu() {
  QMenu *scene = menuBar()->addMenu(tr("&Scene"));
  add(scene, tr("&Pause"), QKeySequence(tr("Ctrl+P")), [this] { m_picture->togglePause(); });
  add(scene, tr("One &frame"), QKeySequence(tr("Ctrl+.")), [this] { m_picture->step(); });
  add(scene, tr("&Stop drawing this text"), QKeySequence(tr("Ctrl+Shift+C")),
      [this] { m_bench.renderer().stop(); });
  add(scene, tr("Picture as its own &window"), QKeySequence(tr("F11")),
      [this] { dock(tr("Picture"))->setFloating(!dock(tr("Picture"))->isFloating()); });
}

void MainWindow::buildDebugMenu() {
  QMenu *debug = menuBar()->addMenu(tr("&Debug"));
  add(debug, tr("&Pixel at the mark"), QKeySequence(tr("Ctrl+D")), [this] {
    const QSize size = m_bench.picture().size();
    m_bench.debugPixel(
        m_bench.debuggedPixel().value_or(QPoint(size.width() / 2, size.height() / 2)));
    dock(tr("Debug"))->raise();
    m_picture->view().setFocus(); // arrow keys move the mark
  });
  add(debug, tr("Step &forward"), QKeySequence(tr("F10")), [this] { m_bench.trace().step(1); });
  add(debug, tr("Step &back"), QKeySequence(tr("Shift+F10")), [this] { m_bench.trace().step(-1); });
  add(debug, tr("Run to &cursor"), QKeySequence(tr("Ctrl+F10")),
      [this] { m_bench.trace().runToLine(m_editor->textCursor().blockNumber() + 1); });
  add(debug, tr("Next &NaN"), QKeySequence(tr("F7")), [this] {
    if (!m_bench.trace().nextFlag(QStringLiteral("nan")))
      notice(tr("no instruction makes a NaN at this pixel"));
  });
}

void MainWindow::buildCompareMenu() {
  QMenu *compare = menuBar()->addMenu(tr("&Compare"));
  add(compare, tr("&Pin the picture as A"), QKeySequence(tr("Ctrl+Shift+A")),
      [this] { m_bench.pin(); });
  add(compare, tr("&Unpin"), {}, [this] { m_bench.unpin(); });
}

void MainWindow::buildAttachMenu() {
  QMenu *attach = menuBar()->addMenu(tr("&Attach"));
  add(attach, tr("&To an application..."), QKeySequence(tr("Ctrl+Shift+T")), [this] {
    showPanel(tr("Attach"));
    m_attach->listProcesses();
  });
  add(attach, tr("&Attach or detach"), QKeySequence(tr("Ctrl+Shift+D")), [this] {
    showPanel(tr("Attach"));
    m_attach->attachOrDetach();
  });
  add(attach, tr("&Measure a frame"), {}, [this] { m_attachment->measure(); });
  add(attach, tr("&Put the text back"), {}, [this] { m_attachment->putBack(); });
  add(attach, tr("&Export replacements..."), {}, [this] { m_attach->askExport(); });
}

void MainWindow::buildHelpMenu() {
  QMenu *help = menuBar()->addMenu(tr("&Help"));
  add(help, tr("&Word at the cursor"), QKeySequence(tr("F1")), [this] {
    showPanel(tr("Words"));
    m_words->lookUp(m_editor->wordAtCursor());
  });
  add(help, tr("&Any action..."), QKeySequence(tr("Ctrl+Shift+P")), [this] { anyAction(); });
  add(help, tr("&Keys..."), {}, [this] { bindKeys(); });
}

void MainWindow::buildMenus() {
  buildFileMenu();
  buildEditMenu();
  buildChoices(menuBar()->addMenu(tr("&Program")));
  buildSceneMenu();
  buildDebugMenu();
  buildCompareMenu();
  buildAttachMenu();
  buildPanelMenu(menuBar()->addMenu(tr("&View")));
  buildHelpMenu();
  const QSettings settings;
  for (QAction *action : m_actions) {
    const QVariant kept = settings.value(QStringLiteral("keys/") + action->text().remove(u'&'));
    if (kept.isValid())
      action->setShortcut(QKeySequence(kept.toString()));
  }
}

void MainWindow::addChoice(QMenu *menu, const QString &title, const QStringList &values,
                           const std::function<void(const QString &)> &chosen) {
  QMenu *choices = menu->addMenu(title);
  auto *group = new QActionGroup(this);
  for (const QString &value : values) {
    QAction *action = choices->addAction(value);
    action->setCheckable(true);
    action->setChecked(value == values.first());
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, chosen, value] {
      chosen(value);
      showStatus();
    });
  }
}

void MainWindow::buildChoices(QMenu *menu) {
  const QString own = tr("as the document says");
  const auto chosen = [own](const QString &name) { return name == own ? QString() : name; };
  QStringList profiles{own};
  for (const std::string_view builtin : fp::hw::builtinNames())
    profiles << QString::fromUtf8(builtin.data(), qsizetype(builtin.size()));
  addChoice(menu, tr("&Profile"), profiles,
            [this, chosen](const QString &name) { m_bench.setProfile(chosen(name)); });
  QStringList numerics{own};
  for (const std::string_view name : fp::kNumericsNames)
    numerics << QString::fromUtf8(name.data(), qsizetype(name.size()));
  addChoice(menu, tr("&Numerics"), numerics,
            [this, chosen](const QString &name) { m_bench.setNumerics(chosen(name)); });
  addChoice(menu, tr("&Back end"),
            {QStringLiteral("auto"), QStringLiteral("host"), QStringLiteral("swrast")},
            [this](const QString &name) { m_bench.setBackend(name); });
}

void MainWindow::buildPanelMenu(QMenu *menu) {
  int number = 0;
  for (const QString &name : panelNames())
    add(menu, name, ++number <= 9 ? QKeySequence(tr("Alt+%1").arg(number)) : QKeySequence(),
        [this, name] { showPanel(name); });
  menu->addSeparator();
  addChoice(menu, tr("&Colours"),
            {QStringLiteral("system"), QStringLiteral("light"), QStringLiteral("dark")},
            [this](const QString &name) { setScheme(name); });
  add(menu, tr("Panels as at &first"), {}, [this] { arrangeAnew(); });
  // While the key is held, only A is shown.
  auto *held = new QShortcut(QKeySequence(tr("Ctrl+B")), this);
  held->setAutoRepeat(false);
  connect(held, &QShortcut::activated, this, [this] { m_picture->view().setShowsOther(true); });
  qApp->installEventFilter(this);
}

/// Ends a held view when its key is released.
bool MainWindow::eventFilter(QObject *watched, QEvent *event) {
  if (event->type() == QEvent::KeyRelease) {
    const auto *key = static_cast<QKeyEvent *>(event);
    if (!key->isAutoRepeat() && (key->key() == Qt::Key_B || key->key() == Qt::Key_Control))
      m_picture->view().setShowsOther(false);
  }
  return QMainWindow::eventFilter(watched, event);
}

/// Lists every action, narrowed by what is typed.
void MainWindow::anyAction() {
  QStringList names;
  for (const QAction *action : m_actions)
    names << QString(action->text()).remove(u'&') + QStringLiteral("    ") +
                 action->shortcut().toString(QKeySequence::NativeText);
  if (const int at = pickFrom(names, tr("Any action"), this); at >= 0)
    m_actions[at]->trigger();
}

/// Lists the names that the text declares, and goes to one.
void MainWindow::goToName() {
  m_bench.language().request(
      QStringLiteral("textDocument/documentSymbol"), -1, {}, [this](const QJsonValue &result) {
        QStringList names;
        QList<QJsonValue> places;
        for (const QJsonValue symbol : result.toArray()) {
          names << symbol[u"name"].toString() + QStringLiteral("    ") +
                       symbol[u"detail"].toString();
          places << symbol[u"selectionRange"][u"start"];
        }
        if (names.isEmpty())
          return notice(tr("the text declares no names"));
        const int at = pickFrom(names, tr("Go to name"), this);
        if (at < 0)
          return;
        m_editor->goTo(offsetOf(m_bench.document().text(), places[at][u"line"].toInteger(),
                                places[at][u"character"].toInteger()));
        m_editor->setFocus();
      });
}

void MainWindow::bindKeys() {
  QStringList names;
  for (const QAction *action : m_actions)
    names << QStringLiteral("%1  [%2]")
                 .arg(QString(action->text()).remove(u'&'), action->shortcut().toString());
  bool ok = false;
  const QString name = QInputDialog::getItem(this, tr("Keys"), tr("Action:"), names, 0, false, &ok);
  if (!ok)
    return;
  QAction *action = m_actions[names.indexOf(name)];
  const QString keys = QInputDialog::getText(this, tr("Keys"), tr("Keys, as \"Ctrl+Shift+K\":"),
                                             QLineEdit::Normal, action->shortcut().toString(), &ok);
  if (!ok)
    return;
  action->setShortcut(QKeySequence(keys));
  QSettings().setValue(QStringLiteral("keys/") + action->text().remove(u'&'), keys);
}

} // namespace arbiter::builder
