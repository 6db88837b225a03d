#include "apps/builder/view/panels/cube_dialog.h"

#include <QBoxLayout>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

#include "apps/builder/model/panels/clauses.h"
#include "apps/builder/view/panels/beside.h"

namespace arbiter::builder {

namespace {

constexpr std::size_t kFaces = 6;
constexpr const char *kFaceNames[kFaces] = {"+x", "-x", "+y", "-y", "+z", "-z"};
/// Names of faces that tools use; longer ones come first, as "posx" ends with "x" too.
constexpr const char *kNamings[][kFaces] = {
    {"right", "left", "top", "bottom", "front", "back"},
    {"right", "left", "up", "down", "front", "back"},
    {"posx", "negx", "posy", "negy", "posz", "negz"},
    {"rt", "lf", "up", "dn", "ft", "bk"},
    {"px", "nx", "py", "ny", "pz", "nz"},
};

} // namespace

QString imageFilter() { return QObject::tr("Images (*.png *.jpg *.jpeg *.dds)"); }

std::array<QString, 6> facesLike(const QString &path) {
  std::array<QString, 6> files;
  const QFileInfo info(path);
  const QString base = info.completeBaseName();
  for (const auto &naming : kNamings)
    for (const char *face : naming) {
      const QLatin1StringView word(face);
      if (!base.endsWith(word, Qt::CaseInsensitive))
        continue;
      for (std::size_t i = 0; i < kFaces; ++i) {
        const QString name = base.left(base.size() - word.size()) + QLatin1StringView(naming[i]) +
                             u'.' + info.suffix();
        if (info.dir().exists(name))
          files[i] = info.dir().filePath(name);
      }
      return files;
    }
  return files;
}

CubeDialog::CubeDialog(Workbench &bench, int unit, QWidget *parent)
    : QDialog(parent), m_bench(bench) {
  setObjectName(QStringLiteral("cube-dialog"));
  setWindowTitle(tr("Cube map of unit %1").arg(unit));
  auto *layout = new QVBoxLayout(this);
  auto *hint = new QLabel(tr("Six square images of one size. Files that are named alike "
                             "(px, nx, ...; right, left, ...) are found by one of them."));
  hint->setWordWrap(true);
  layout->addWidget(hint);
  auto *form = new QFormLayout;
  for (std::size_t i = 0; i < kFaces; ++i) {
    auto *row = new QHBoxLayout;
    m_names[i] = new QLineEdit;
    m_names[i]->setObjectName(QStringLiteral("face-%1").arg(i));
    m_names[i]->setAccessibleName(tr("Image of the face %1").arg(QLatin1StringView(kFaceNames[i])));
    auto *browse = new QPushButton(tr("Browse..."));
    row->addWidget(m_names[i], 1);
    row->addWidget(browse);
    form->addRow(QLatin1StringView(kFaceNames[i]), row);
    connect(browse, &QPushButton::clicked, this, [this, i] { pick(i); });
    connect(m_names[i], &QLineEdit::textChanged, this, [this] { check(); });
    connect(m_names[i], &QLineEdit::editingFinished, this, [this, i] {
      const QString name = m_names[i]->text();
      if (!name.isEmpty())
        setFace(i, QDir(m_bench.file().folder()).absoluteFilePath(name));
    });
  }
  layout->addLayout(form);
  auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
  m_ok = buttons->button(QDialogButtonBox::Ok);
  layout->addWidget(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  resize(460, sizeHint().height());
  // The fields start with the unit's present files.
  const QString text = bench.document().text();
  if (const auto clause = clauseOf(text, QStringLiteral("texture")); clause) {
    for (const Clause &each : clausesOf(text))
      if (each.word == u"texture" &&
          each.value.startsWith(QStringLiteral("%1 = cube ").arg(unit))) {
        const QStringList names =
            each.value.section(QStringLiteral("cube "), 1).split(u' ', Qt::SkipEmptyParts);
        for (std::size_t i = 0; i < kFaces && qsizetype(i) < names.size(); ++i)
          m_names[i]->setText(QString(names[qsizetype(i)]).remove(u'"'));
      }
  }
  check();
}

void CubeDialog::pick(std::size_t face) {
  const QString path = QFileDialog::getOpenFileName(
      this, tr("Image of the face %1").arg(QLatin1StringView(kFaceNames[face])),
      m_bench.file().folder(), imageFilter());
  const QString name = path.isEmpty() ? QString() : nameBeside(this, m_bench, path);
  if (name.isEmpty())
    return;
  m_names[face]->setText(name);
  setFace(face, QDir(m_bench.file().folder()).absoluteFilePath(name));
}

/// Sets a face, and the empty faces by files with matching names.
void CubeDialog::setFace(std::size_t face, const QString &path) {
  const auto files = facesLike(path);
  const QDir folder(m_bench.file().folder());
  for (std::size_t i = 0; i < kFaces; ++i)
    if (i != face && m_names[i]->text().isEmpty() && !files[i].isEmpty())
      m_names[i]->setText(folder.relativeFilePath(files[i]));
}

void CubeDialog::check() {
  bool all = true;
  for (const QLineEdit *name : m_names)
    all = all && !name->text().trimmed().isEmpty();
  m_ok->setEnabled(all);
}

QString CubeDialog::source() const {
  QString words = QStringLiteral("cube");
  for (const QLineEdit *name : m_names)
    words += u' ' + quotedName(name->text().trimmed());
  return words;
}

} // namespace arbiter::builder
