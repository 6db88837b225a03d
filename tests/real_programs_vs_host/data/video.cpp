// Plays a film by Qt Multimedia in a QGraphicsView over GL: on a host without GLSL, Qt converts its
// colors in an ARB fragment program. The shown frames depend on the clock, so that only recordings
// of it are compared.
#include <QApplication>
#include <QGLWidget>
#include <QGraphicsScene>
#include <QGraphicsVideoItem>
#include <QGraphicsView>
#include <QMediaPlayer>
#include <QTimer>
#include <QUrl>

int main(int argc, char **argv) {
  QApplication application(argc, argv);
  if (argc < 2)
    return 2;
  QGraphicsScene scene(0, 0, 320, 240);
  QGraphicsView view(&scene);
  view.setViewport(new QGLWidget);
  view.setFrameStyle(QFrame::NoFrame);
  view.setFixedSize(340, 260);
  QGraphicsVideoItem item;
  item.setSize(QSizeF(320, 240));
  scene.addItem(&item);
  view.show();
  QMediaPlayer player;
  player.setVideoOutput(&item);
  player.setMedia(QUrl::fromLocalFile(QString::fromLocal8Bit(argv[1])));
  player.play();
  QTimer::singleShot(6000, &application, &QCoreApplication::quit);
  return application.exec();
}
