#pragma once
#include <QScrollArea>
#include <functional>

#include "apps/builder/model/panels/scene_settings.h"
#include "apps/builder/model/workbench.h"

class QComboBox;
class QFormLayout;
class QListWidget;

namespace arbiter::builder {

/// Edits how a document is drawn, besides its textures and parameters: size, mesh, camera, state
/// and passes. Each change writes the `#@` line, as one undo step.
class ScenePanel : public QScrollArea {
public:
  /// \param open opens another file of the document
  ScenePanel(Workbench &bench, std::function<void(const QString &path)> open);

private:
  void read();
  void build();
  void showValues();
  void addPicture(QFormLayout *form);
  void addMesh(QFormLayout *form);
  void addCamera(QFormLayout *form);
  void addState(QFormLayout *form);
  void addPasses(QFormLayout *form);
  QWidget *arguments(const QString &setting, const QList<ArgumentValue> &all);
  QComboBox *choice(const QString &setting, const std::function<QString()> &now,
                    const std::function<void(const QString &)> &chosen);
  QWidget *check(const QString &title, const char *name, const std::function<bool()> &now,
                 const std::function<void(bool)> &chosen);
  void write(const QString &word, const QString &value);
  void take(const QString &word);
  void chooseFile(const QString &word);
  void removePass();
  void openPass();
  [[nodiscard]] bool sameWidgets(const SceneSettings &other) const;

  Workbench &m_bench;
  std::function<void(const QString &)> m_open;
  SceneSettings m_settings;
  QListWidget *m_passes = nullptr;
  QList<std::function<void()>> m_refresh; ///< update a widget's value from m_settings
};

} // namespace arbiter::builder
