#pragma once
#include <QListWidget>
#include <functional>

#include "apps/builder/model/panels/tool_run.h"
#include "apps/builder/model/workbench.h"

namespace arbiter::builder {

/// Lists the documents that come with the builder, each with a picture, and opens copies of them. A
/// process draws each picture once, and the user's cache keeps it.
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
