// Every dock is usable in small windows too, and keeps the size that the user gave it.
#include <QAbstractScrollArea>
#include <QDockWidget>
#include <QTableWidget>

#include "apps/builder/testing/window_test.h"

namespace arbiter::builder {

using testing::runAction;
using testing::serve;
using testing::waitFor;

namespace {

class Layout : public ::testing::TestWithParam<QSize> {
protected:
  Layout() {
    places = Places::standard();
    places.journals = m_folder.filePath(QStringLiteral("journals"));
    places.held = {};
  }
  static QDockWidget &dock(MainWindow &window, const char *name) {
    return *window.findChild<QDockWidget *>(QString::fromLatin1(name));
  }
  /// Returns the heights of the docks in the window's corners.
  static QList<int> heights(MainWindow &window) {
    QList<int> all;
    for (const char *name : {"Program", "Picture", "Parameters", "Problems"})
      all << dock(window, name).height();
    return all;
  }
  static bool holds(MainWindow &window, const std::function<bool()> &condition) {
    return waitFor([&] { return window.isVisible() && condition(); }, 5000);
  }

  QTemporaryDir m_folder;
  Places places;
};

} // namespace

TEST_P(Layout, EveryDockIsUsable) {
  MainWindow window(places);
  window.resize(GetParam());
  window.show();
  serve(50);
  EXPECT_EQ(window.size(), GetParam()) << "the panels do not fit";
  for (const QString &name : window.panelNames()) {
    window.showPanel(name);
    serve(10);
    auto *each = window.findChild<QDockWidget *>(name);
    EXPECT_GE(each->widget()->height(), 90) << name.toStdString();
    EXPECT_GE(each->widget()->width(), 300) << name.toStdString();
    for (const auto *table : each->widget()->findChildren<QTableWidget *>())
      if (table->isVisible() && name != u"Attach") {
        EXPECT_GE(table->viewport()->height(), 2 * table->fontMetrics().height())
            << name.toStdString() << ": its rows have no room";
      }
  }
  EXPECT_GE(window.picture().view().height(), 130);
  EXPECT_GE(window.editor().height(), 240);
}

TEST_P(Layout, StaysAsItWasLeft) {
  QList<int> left;
  {
    MainWindow window(places);
    window.resize(GetParam());
    window.show();
    serve(20);
    const QList<int> first = heights(window);
    window.resizeDocks({&dock(window, "Program"), &dock(window, "Problems")},
                       {first[0] - 110, first[3] + 110}, Qt::Vertical); // with its tab
    ASSERT_TRUE(holds(window, [&] { return heights(window)[3] >= first[3] + 30; }))
        << heights(window)[3] << " of " << first[3];
    left = heights(window);
    window.close();
  }
  MainWindow again(places);
  again.restoreLayout();
  again.show();
  serve(50);
  const QList<int> now = heights(again);
  for (int i = 0; i < left.size(); ++i)
    EXPECT_NEAR(now[i], left[i], 14) << i; // a window of the screen's height is made a little lower
  runAction(again, "Panels as at first");
  EXPECT_TRUE(holds(again, [&] { return heights(again)[3] <= left[3] - 30; }))
      << heights(again)[3] << " of " << left[3];
}

INSTANTIATE_TEST_SUITE_P(Sizes, Layout,
                         ::testing::Values(QSize(1280, 800), QSize(1024, 700), QSize(920, 620)),
                         [](const auto &size) {
                           return "Of" + std::to_string(size.param.width()) + "x" +
                                  std::to_string(size.param.height());
                         });

} // namespace arbiter::builder
