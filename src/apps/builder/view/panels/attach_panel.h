#pragma once
#include <QWidget>

#include "apps/builder/model/attach/attachment.h"

class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;
class QTabWidget;

namespace arbiter::builder {

class AttachedText;
class AttachedValues;
class PictureView;
class Table;

/// Shows a running application: its programs with their cost, its frame and its textures. The
/// selected program's text and parameters can be edited live.
class AttachPanel : public QWidget {
public:
  explicit AttachPanel(Attachment &attachment);

  [[nodiscard]] PictureView &picture() { return *m_picture; }
  [[nodiscard]] AttachedText &text() { return *m_text; }
  /// Updates the list of processes.
  void listProcesses();
  void attachOrDetach();
  /// Attaches to the process of that number, if it listens.
  void attachTo(qint64 process);
  void askExport();

protected:
  void showEvent(QShowEvent *event) override;
  void hideEvent(QHideEvent *event) override;

private:
  QWidget *buildBar();
  void showState();
  void showPrograms();
  void showTextures();
  void choose(int row);
  void say(const QString &text);

  Attachment &m_attachment;
  QList<ListeningProcess> m_processes;
  QComboBox *m_process = nullptr;
  QPushButton *m_attach = nullptr, *m_measure = nullptr, *m_export = nullptr;
  Table *m_programs = nullptr;
  PictureView *m_picture = nullptr;
  QTabWidget *m_tabs = nullptr;
  AttachedText *m_text = nullptr;
  AttachedValues *m_values = nullptr;
  QListWidget *m_textures = nullptr;
  QLabel *m_said = nullptr;
  bool m_saidBusy = false;
};

} // namespace arbiter::builder
