#pragma once
#include <QListWidget>
#include <functional>

#include "builder/model/panels/tool_run.h"
#include "builder/model/workbench.h"

namespace arbiter::builder {

/// The documents that come with the builder, each with its picture, opened as copies. Pictures are
/// drawn once, in a process, and kept in the user's cache.
class Gallery : public QListWidget {
public:
  /// \param open is called with a document's path
  Gallery(Workbench &bench, std::function<void(const QString &)> open);

protected:
  void showEvent(QShowEvent *event) override;

private:
  void fill();
  void nextPicture();

  Workbench &m_bench;
  ToolRun m_tool;
  QList<int> m_wanted; ///< rows
};

} // namespace arbiter::builder
