#pragma once
#include <QWidget>

#include "apps/builder/model/panels/textures.h"
#include "apps/builder/model/workbench.h"

class QComboBox;
class QListWidget;
class QMenu;
class QSpinBox;

namespace arbiter::builder {

/// Lists the document's texture units, each with a thumbnail and its source. A file, six files for
/// a cube, or a generator can be assigned, and filter and wrap be set. Each change is an edit of
/// the `#@ texture` line. A process draws the images like documents.
class TexturesPanel : public QWidget {
public:
  explicit TexturesPanel(Workbench &bench);

private:
  void read();
  void nextThumbnail();
  void setSource(const QString &source);
  void chooseFile();
  void chooseCube();
  void fillMenu(QMenu *menu);
  QComboBox *samplerBox(Sampler kind, const char *name);
  void showSampler();
  [[nodiscard]] int unit() const;
  [[nodiscard]] const TextureLine *lineOfUnit() const;

  Workbench &m_bench;
  ToolRun m_tool;
  QListWidget *m_list;
  QSpinBox *m_unit;
  QComboBox *m_filter, *m_wrap;
  QList<TextureLine> m_lines;
  QHash<QString, QImage> m_thumbnails; ///< by source; null: being drawn, or impossible to draw
  QStringList m_wanted;
};

} // namespace arbiter::builder
