#pragma once
#include <QWidget>

#include "builder/model/panels/textures.h"
#include "builder/model/workbench.h"

class QComboBox;
class QListWidget;
class QMenu;
class QSpinBox;

namespace arbiter::builder {

/// The texture image units of the document, each with its image small, and where it comes from; a
/// file, six for a cube, or a generator is given to one, and how it is filtered and wrapped. Each
/// change is an edit of the `#@ texture` line. The images are drawn as documents are, in a process.
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
  QHash<QString, QImage> m_thumbnails; ///< by source; null: being drawn, or not to be drawn
  QStringList m_wanted;
};

} // namespace arbiter::builder
