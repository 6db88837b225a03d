#pragma once
#include <QMainWindow>

#include "apps/builder/model/workbench.h"

class QActionGroup;

namespace arbiter::builder {

class AttachPanel;
class Attachment;
class CodeEditor;
class DebugPanel;
class Gallery;
class PicturePanel;
class ProblemsPanel;
class StatusLine;
class WordsPanel;

/// The window: every panel is a dock, and all actions are in menus with keys.
class MainWindow : public QMainWindow {
  Q_OBJECT
public:
  explicit MainWindow(Places places);
  /// Destroys the panels before the objects that they show.
  ~MainWindow() override;

  [[nodiscard]] Workbench &bench() { return m_bench; }
  [[nodiscard]] CodeEditor &editor() { return *m_editor; }
  [[nodiscard]] PicturePanel &picture() { return *m_picture; }
  [[nodiscard]] AttachPanel &attachPanel() { return *m_attach; }
  [[nodiscard]] Attachment &attachment() { return *m_attachment; }
  /// True if the workbench's trace belongs to the application's program instead of the document.
  [[nodiscard]] bool tracesApplication() const { return m_tracesApplication; }

  /// Opens a program, or the document of a folder. \returns false after showing a complaint
  bool openPath(const QString &path);
  /// Opens a path, or a copy of the gallery's document for "gallery:NAME".
  bool openNamed(const QString &name);
  void openText(const QString &text);
  /// Offers to open the documents that ended processes left unsaved.
  void offerRecovery();
  /// Brings a panel to the front by its name ("Debug") and gives it the focus.
  void showPanel(const QString &name);
  /// Opens a file in place of the document, after unsaved text is saved or discarded.
  void openInstead(const QString &path);
  /// Returns the names of all panels, in the order of the menu.
  [[nodiscard]] static QStringList panelNames();
  void setScheme(const QString &name);
  [[nodiscard]] QString lastNotice() const;
  /// Restores the layout of the last session, or keeps the default.
  void restoreLayout();

protected:
  void closeEvent(QCloseEvent *event) override;
  void showEvent(QShowEvent *event) override;
  bool eventFilter(QObject *watched, QEvent *event) override;

private:
  static constexpr int kLayoutVersion = 3; ///< identifies the set of panels

  void buildPanels();
  void buildAttachment();
  QDockWidget *addPanel(const QString &name, QWidget *widget, Qt::DockWidgetArea area);
  void arrange();
  void share();
  void arrangeAnew();
  [[nodiscard]] QDockWidget *dock(const QString &name) const;

  // actions.cpp
  void buildMenus();
  void buildFileMenu();
  void buildEditMenu();
  void buildSceneMenu();
  void buildDebugMenu();
  void buildCompareMenu();
  void buildAttachMenu();
  void buildHelpMenu();
  QAction *add(QMenu *menu, const QString &text, const QKeySequence &keys,
               const std::function<void()> &action);
  void buildChoices(QMenu *menu);
  void addChoice(QMenu *menu, const QString &title, const QStringList &values,
                 const std::function<void(const QString &)> &chosen);
  void buildPanelMenu(QMenu *menu);
  void anyAction();
  void goToName();
  void bindKeys();

  // files.cpp
  void newFile();
  void openFile();
  bool save();
  bool saveAs();
  bool mayDiscard();
  bool openCopy(const QString &path);
  [[nodiscard]] QString userFolder();
  QString takeCompanions(const QString &folder);
  void exportPicture();
  void exportSequence();
  void askConflict(const QString &theirs);

  void showStatus();
  void showTitle();
  void notice(const QString &text);
  void buildStatus();

  Workbench m_bench;
  std::unique_ptr<Attachment> m_attachment;
  bool m_takesTrace = false, m_tracesApplication = false;
  CodeEditor *m_editor = nullptr;
  PicturePanel *m_picture = nullptr;
  ProblemsPanel *m_problems = nullptr;
  AttachPanel *m_attach = nullptr;
  DebugPanel *m_debug = nullptr;
  WordsPanel *m_words = nullptr;
  Gallery *m_gallery = nullptr;
  QList<QDockWidget *> m_docks;
  QList<QAction *> m_actions;
  StatusLine *m_status = nullptr; ///< the status bar's
  QByteArray m_madeLayout;
  bool m_isShared = false; ///< the docks have got their shares of the window
};

} // namespace arbiter::builder
