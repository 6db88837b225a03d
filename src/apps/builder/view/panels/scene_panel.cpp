#include "apps/builder/view/panels/scene_panel.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>

#include "apps/builder/model/panels/clauses.h"
#include "apps/builder/view/panels/flow_row.h"
#include "apps/builder/view/panels/number_box.h"

namespace arbiter::builder {

namespace {

constexpr int kMaxSide = 8192;

/// Returns a mesh clause for the new shape; a shape that needs another keeps the old one inside.
QString meshWith(const QString &shape, const QString &before) {
  if (shape == u"shells" || shape == u"volume")
    return shape + QStringLiteral(" of ") +
           (before.isEmpty() || before.contains(u" of ") ? QStringLiteral("sphere") : before);
  for (const char *word : {" at ", " scale "})
    if (const qsizetype at = before.indexOf(QLatin1StringView(word)); at > 0)
      return shape + before.mid(at);
  return shape;
}

QString depthValue(const QString &word, bool write) {
  return write ? word
               : (word.isEmpty() ? QStringLiteral("less") : word) + QStringLiteral(" write off");
}

} // namespace

ScenePanel::ScenePanel(Workbench &bench, std::function<void(const QString &)> open)
    : m_bench(bench), m_open(std::move(open)) {
  setWidgetResizable(true);
  setFrameShape(NoFrame);
  setAccessibleName(tr("Scene"));
  connect(&bench.parameters(), &Parameters::linesChanged, this, [this] { read(); });
  m_settings = sceneOf(bench.document().text());
  build();
}

/// True if only numbers and words changed; the widgets then stay, and with them the focus.
bool ScenePanel::sameWidgets(const SceneSettings &other) const {
  return m_settings.shape == other.shape && m_settings.camera == other.camera &&
         m_settings.cameraArguments.size() == other.cameraArguments.size() &&
         m_settings.vertex == other.vertex && m_settings.then == other.then;
}

void ScenePanel::read() {
  const SceneSettings settings = sceneOf(m_bench.document().text());
  const bool same = sameWidgets(settings);
  m_settings = settings;
  if (same)
    showValues();
  else
    build();
}

void ScenePanel::showValues() {
  for (const auto &refresh : m_refresh)
    refresh();
}

/// Rebuilds the widgets, and gives the focus back to the one that had it.
void ScenePanel::build() {
  const QWidget *focus = widget() ? widget()->focusWidget() : nullptr;
  const QString focused = focus && focus->hasFocus() ? focus->objectName() : QString();
  m_refresh.clear();
  auto *inside = new QWidget;
  auto *form = new QFormLayout(inside);
  form->setContentsMargins(8, 6, 8, 6);
  form->setVerticalSpacing(4);
  form->setRowWrapPolicy(QFormLayout::DontWrapRows);
  form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
  addPicture(form);
  addMesh(form);
  addCamera(form);
  addState(form);
  addPasses(form);
  if (QWidget *old = takeWidget())
    old->deleteLater(); // one of its signals may have led here
  setWidget(inside);
  showValues();
  if (!focused.isEmpty())
    if (auto *again = inside->findChild<QWidget *>(focused))
      again->setFocus();
}

void ScenePanel::write(const QString &word, const QString &value) {
  const Edit edit = setClause(m_bench.document().text(), word, value);
  if (edit.removed != edit.added)
    m_bench.document().apply({edit}, tr("scene: %1").arg(word));
}

void ScenePanel::take(const QString &word) {
  const QString &text = m_bench.document().text();
  if (const auto clause = clauseOf(text, word))
    m_bench.document().apply({removeClause(text, *clause)}, tr("scene: %1").arg(word));
}

void ScenePanel::addPicture(QFormLayout *form) {
  auto *row = new FlowRow;
  auto *width = new NumberBox(1, kMaxSide, tr("Width in pixels"));
  auto *height = new NumberBox(1, kMaxSide, tr("Height in pixels"));
  auto *rate = new NumberBox(1, 1000, tr("Frames a second"));
  width->setObjectName(QStringLiteral("scene-width"));
  height->setObjectName(QStringLiteral("scene-height"));
  rate->setObjectName(QStringLiteral("scene-rate"));
  width->setDecimals(0);
  height->setDecimals(0);
  row->add({width, new QLabel(QStringLiteral("\u00d7")), height});
  row->add({rate, new QLabel(tr("frames/s"))});
  const auto size = [this, width, height] {
    write(QStringLiteral("size"),
          QStringLiteral("%1 %2").arg(int(width->value())).arg(int(height->value())));
  };
  connect(width, &QDoubleSpinBox::valueChanged, this, size);
  connect(height, &QDoubleSpinBox::valueChanged, this, size);
  connect(rate, &QDoubleSpinBox::valueChanged, this,
          [this](double value) { write(QStringLiteral("rate"), Parameters::numberText(value)); });
  m_refresh << [this, width, height, rate] {
    const QSignalBlocker a(width), b(height), c(rate);
    width->setValue(m_settings.width);
    height->setValue(m_settings.height);
    rate->setValue(m_settings.rate);
  };
  form->addRow(tr("Picture"), row);
}

/// Makes the fields of the numbers behind a word, each with its name.
QWidget *ScenePanel::arguments(const QString &setting, const QList<ArgumentValue> &all) {
  auto *row = new FlowRow;
  for (qsizetype i = 0; i < all.size(); ++i) {
    const QString name = all[i].name;
    auto *box = new NumberBox(all[i].low, all[i].high, setting + u' ' + name);
    box->setObjectName(QStringLiteral("scene-%1-%2").arg(setting, name));
    auto *label = new QLabel(name);
    label->setBuddy(box);
    row->add({label, box});
    connect(box, &QDoubleSpinBox::valueChanged, this, [this, setting, name](double value) {
      const Edit edit = setArgument(m_bench.document().text(), setting, name, value);
      if (edit.removed != edit.added)
        m_bench.document().apply({edit}, tr("%1: %2").arg(setting, name));
    });
    m_refresh << [this, setting, box, i] {
      const auto &now = setting == u"mesh" ? m_settings.shapeArguments : m_settings.cameraArguments;
      const QSignalBlocker block(box);
      if (i < now.size())
        box->setValue(now[i].value);
    };
  }
  return row;
}

/// Makes a choice of a table's words; the first entry stands for none.
QComboBox *ScenePanel::choice(const QString &setting, const std::function<QString()> &now,
                              const std::function<void(const QString &)> &chosen) {
  auto *box = new QComboBox;
  box->setObjectName(QStringLiteral("scene-") + setting);
  box->setAccessibleName(setting);
  box->setFocusPolicy(Qt::StrongFocus);
  box->setSizeAdjustPolicy(QComboBox::AdjustToContents);
  box->addItem(tr("not said"));
  box->addItems(wordsFor(setting));
  connect(box, &QComboBox::activated, this, [this, box, setting, chosen](int at) {
    if (at == 0)
      take(setting);
    else
      chosen(box->itemText(at));
  });
  m_refresh << [box, now] { box->setCurrentIndex(std::max(0, box->findText(now()))); };
  return box;
}

void ScenePanel::addMesh(QFormLayout *form) {
  const QString setting = QStringLiteral("mesh");
  auto *row = new QWidget;
  auto *layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  auto *words = new QLineEdit;
  words->setObjectName(QStringLiteral("scene-mesh-words"));
  words->setAccessibleName(tr("All words of the mesh"));
  words->setPlaceholderText(tr("torus at 0 0.3 0 and plane at 0 -0.6 0"));
  layout->addWidget(choice(
      setting, [this] { return m_settings.shape; },
      [this, setting](const QString &shape) { write(setting, meshWith(shape, m_settings.mesh)); }));
  layout->addWidget(words, 1);
  connect(words, &QLineEdit::editingFinished, this, [this, words, setting] {
    const QString value = words->text().trimmed();
    if (value == m_settings.mesh)
      return;
    if (value.isEmpty())
      take(setting);
    else
      write(setting, QString(value).remove(u'\n').remove(u','));
  });
  m_refresh << [this, words] {
    const QSignalBlocker block(words);
    words->setText(m_settings.mesh);
  };
  form->addRow(tr("Mesh"), row);
  if (!m_settings.shapeArguments.isEmpty())
    form->addRow(QString(), arguments(setting, m_settings.shapeArguments));
}

void ScenePanel::addCamera(QFormLayout *form) {
  const QString setting = QStringLiteral("camera");
  auto *row = new QWidget;
  auto *layout = new QHBoxLayout(row);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(choice(
      setting, [this] { return m_settings.camera; },
      [this, setting](const QString &word) { write(setting, word); }));
  auto *hint = new QLabel(tr("the right button turns it"));
  hint->setForegroundRole(QPalette::PlaceholderText);
  hint->setVisible(m_settings.camera == u"orbit");
  layout->addWidget(hint, 1);
  form->addRow(tr("Camera"), row);
  if (!m_settings.cameraArguments.isEmpty())
    form->addRow(QString(), arguments(setting, m_settings.cameraArguments));
}

QWidget *ScenePanel::check(const QString &title, const char *name, const std::function<bool()> &now,
                           const std::function<void(bool)> &chosen) {
  auto *box = new QCheckBox(title);
  box->setObjectName(QLatin1StringView(name));
  connect(box, &QCheckBox::clicked, this, chosen);
  m_refresh << [box, now] { box->setChecked(now()); };
  return box;
}

void ScenePanel::addState(QFormLayout *form) {
  const auto add = [this](FlowRow *row, const QString &title, const QString &setting,
                          QString SceneSettings::*member) {
    auto *label = new QLabel(title);
    QComboBox *box = choice(
        setting, [this, member] { return m_settings.*member; },
        [this, setting](const QString &word) {
          write(setting, setting == u"depth" ? depthValue(word, m_settings.depthWrite) : word);
        });
    label->setBuddy(box);
    row->add({label, box});
  };
  auto *state = new FlowRow;
  add(state, tr("blend"), QStringLiteral("blend"), &SceneSettings::blend);
  add(state, tr("depth"), QStringLiteral("depth"), &SceneSettings::depth);
  add(state, tr("cull"), QStringLiteral("cull"), &SceneSettings::cull);
  add(state, tr("stencil"), QStringLiteral("stencil"), &SceneSettings::stencil);
  form->addRow(tr("State"), state);
  auto *writes = new FlowRow;
  writes->add({check(
      tr("depth is written"), "scene-depth-write", [this] { return m_settings.depthWrite; },
      [this](bool on) {
        write(
            QStringLiteral("depth"),
            depthValue(m_settings.depth.isEmpty() ? QStringLiteral("less") : m_settings.depth, on));
      })});
  writes->add({check(
      tr("colours are written"), "scene-color", [this] { return m_settings.colorWrite; },
      [this](bool on) {
        write(QStringLiteral("color"), on ? QStringLiteral("on") : QStringLiteral("off"));
      })});
  writes->add({check(
      tr("draws over the last pass"), "scene-keep", [this] { return m_settings.keep; },
      [this](bool on) {
        if (on)
          write(QStringLiteral("keep"), {});
        else
          take(QStringLiteral("keep"));
      })});
  auto *clear = new QPushButton(tr("Background..."));
  clear->setObjectName(QStringLiteral("scene-clear"));
  connect(clear, &QPushButton::clicked, this, [this, clear] {
    const auto &c = m_settings.clear;
    const QColor picked =
        QColorDialog::getColor(QColor::fromRgbF(float(c[0]), float(c[1]), float(c[2]), float(c[3])),
                               clear, QString(), QColorDialog::ShowAlphaChannel);
    QStringList numbers;
    for (const float each : {picked.redF(), picked.greenF(), picked.blueF(), picked.alphaF()})
      numbers << Parameters::numberText(std::round(double(each) * 1000) / 1000);
    if (picked.isValid())
      write(QStringLiteral("clear"), numbers.join(u' '));
  });
  m_refresh << [this, clear] {
    QPixmap swatch(24, 12);
    const auto &c = m_settings.clear;
    swatch.fill(QColor::fromRgbF(float(c[0]), float(c[1]), float(c[2])));
    clear->setIcon(swatch);
  };
  writes->add({clear});
  form->addRow(QString(), writes);
}

} // namespace arbiter::builder
