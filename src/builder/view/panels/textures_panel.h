#pragma once
#include <QWidget>

#include "builder/model/panels/textures.h"
#include "builder/model/workbench.h"

class QListWidget;
class QPushButton;
class QSpinBox;

namespace arbiter::builder {

/// The texture image units of the document, each with its image small, and where it comes from; a
/// file or a generator is given to one by a menu. The images are drawn as documents are, in a
/// process.
class TexturesPanel : public QWidget {
public:
  explicit TexturesPanel(Workbench &bench);

private:
  void read();
  void nextThumbnail();
  void setSource(const QString &source);
  void chooseFile();
  [[nodiscard]] int unit() const;

  Workbench &m_bench;
  ToolRun m_tool;
  QListWidget *m_list;
  QSpinBox *m_unit;
  QList<TextureLine> m_lines;
  QHash<QString, QImage> m_thumbnails; ///< by source; null: being drawn, or not to be drawn
  QStringList m_wanted;
};

} // namespace arbiter::builder
