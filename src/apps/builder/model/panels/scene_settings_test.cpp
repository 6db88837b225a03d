#include "apps/builder/model/panels/scene_settings.h"

#include "apps/builder/model/panels/clauses.h"
#include "apps/builder/model/panels/parameters.h"
#include "apps/builder/model/panels/textures.h"
#include "apps/builder/testing/model_test.h"

namespace arbiter::builder {

namespace {

const QString kText =
    QString::fromUtf8("!!ARBfp1.0\r\n"
                      "#@ profile r300, size 320 200, mesh torus parts 32 at 0 0.5 0\r\n"
                      "#@ title \"gr\xc3\xb6\xc3\x9f"
                      "er, na\", camera orbit pitch 20 distance 4, keep\r\n"
                      "#@ vertex surface.vp\r\n"
                      "#@ then ink.fp\r\n"
                      "#@ local[2] \"turn\" = 1 0 0\r\n"
                      "END\r\n");

QString applied(QString text, const Edit &edit) {
  EXPECT_EQ(text.mid(edit.at, edit.removed.size()), edit.removed);
  return text.replace(edit.at, edit.removed.size(), edit.added);
}

QString applied(QString text, const QList<Edit> &edits) {
  for (const Edit &edit : edits)
    text = applied(text, edit);
  return text;
}

} // namespace

TEST(Clauses, AreFoundWithTheirPlaces) {
  const QList<Clause> all = clausesOf(kText);
  QStringList words;
  for (const Clause &clause : all) {
    words << clause.word;
    EXPECT_EQ(kText.mid(clause.valueBegin, clause.end - clause.valueBegin), clause.value);
  }
  EXPECT_EQ(words.join(u' '),
            QStringLiteral("profile size mesh title camera keep vertex then local"));
  EXPECT_EQ(clauseOf(kText, QStringLiteral("title"))->value,
            QString::fromUtf8("\"gr\xc3\xb6\xc3\x9f"
                              "er, na\""))
      << "a comma in quotes ends no clause";
  EXPECT_EQ(clauseOf(kText, QStringLiteral("camera"))->value,
            QStringLiteral("orbit pitch 20 distance 4"));
}

TEST(Clauses, OneIsSetAddedAndTakenAwayAndNoOtherByteChanges) {
  QString wanted = kText;
  EXPECT_EQ(applied(kText, setClause(kText, QStringLiteral("size"), QStringLiteral("64 64"))),
            wanted.replace(QStringLiteral("320 200"), QStringLiteral("64 64")));
  const QString more =
      applied(kText, setClause(kText, QStringLiteral("blend"), QStringLiteral("add")));
  EXPECT_TRUE(more.contains(QStringLiteral("1 0 0\r\n#@ blend add\r\nEND"))) << more.toStdString();
  const auto without = [](const char *word) {
    return applied(kText, removeClause(kText, *clauseOf(kText, QString::fromLatin1(word))));
  };
  EXPECT_TRUE(without("profile").contains(QStringLiteral("#@ size 320 200, mesh")));
  EXPECT_TRUE(without("size").contains(QStringLiteral("#@ profile r300, mesh")));
  EXPECT_TRUE(without("keep").contains(QStringLiteral("distance 4\r\n")));
  EXPECT_TRUE(without("then").contains(QStringLiteral("surface.vp\r\n#@ local")));
  EXPECT_EQ(quotedName(QStringLiteral("a-b.png")), QStringLiteral("a-b.png"));
  EXPECT_EQ(quotedName(QStringLiteral("a b.png")), QStringLiteral("\"a b.png\""));
  EXPECT_EQ(quotedName(QStringLiteral("noise")), QStringLiteral("\"noise\""))
      << "without a dot it is a generator's word";
}

TEST(SceneSettings, AreRead) {
  const SceneSettings settings = sceneOf(kText);
  EXPECT_EQ(settings.width, 320);
  EXPECT_EQ(settings.height, 200);
  EXPECT_EQ(settings.shape, QStringLiteral("torus"));
  EXPECT_EQ(settings.mesh, QStringLiteral("torus parts 32 at 0 0.5 0"));
  EXPECT_EQ(settings.camera, QStringLiteral("orbit"));
  EXPECT_TRUE(settings.keep);
  EXPECT_EQ(settings.vertex, QStringLiteral("surface.vp"));
  EXPECT_EQ(settings.then, QStringList{QStringLiteral("ink.fp")});
  EXPECT_EQ(settings.blend, QString());
  EXPECT_TRUE(wordsFor(QStringLiteral("mesh")).contains(QStringLiteral("sphere")));
  EXPECT_TRUE(wordsFor(QStringLiteral("stencil")).contains(QStringLiteral("lit")));
}

TEST(SceneSettings, ANumberIsRewrittenOrAdded) {
  const auto set = [](const char *setting, const char *name, double value) {
    return applied(
        kText, setArgument(kText, QString::fromLatin1(setting), QString::fromLatin1(name), value));
  };
  EXPECT_TRUE(set("mesh", "parts", 8).contains(QStringLiteral("torus parts 8 at 0 0.5 0")));
  EXPECT_TRUE(set("camera", "pitch", -5).contains(QStringLiteral("orbit pitch -5 distance 4,")));
  EXPECT_TRUE(set("camera", "yaw", 30).contains(QStringLiteral("distance 4 yaw 30, keep")));
  EXPECT_TRUE(set("camera", "pitch", 500).contains(QStringLiteral("pitch 90 "))) << "clamped";
  EXPECT_TRUE(setArgument(kText, QStringLiteral("camera"), QStringLiteral("none"), 1).isEmpty());
}

TEST(SceneSettings, ATurnOfTheCameraIsWrittenInDegrees) {
  const QString turned = applied(kText, turnCamera(kText, 190, 80, 0.5));
  EXPECT_TRUE(turned.contains(QStringLiteral("orbit pitch 90 distance 2 yaw -170")))
      << turned.toStdString();
  EXPECT_TRUE(turnCamera(kText, 0, 0, 1).isEmpty());
  QString still = kText;
  still.replace(QStringLiteral("orbit pitch 20 distance 4"), QStringLiteral("none"));
  EXPECT_TRUE(turnCamera(still, 10, 0, 1).isEmpty());
}

TEST(Parameters, RangeAndAnimationAreEditsOfOneLine) {
  const QString before = QStringLiteral("!!ARBfp1.0\n"
                                        "#@ local[0].x \"a\" = 0.5 in 0..2 animate sine 5s\n"
                                        "#@ local[1] = 1 2 3 color\nEND\n");
  Document document;
  document.open(before);
  Parameters parameters(document);
  EXPECT_EQ(parameters.lines()[0].motion, QStringLiteral("sine"));
  EXPECT_EQ(parameters.lines()[0].period, 5);
  parameters.setRange(0, -1, 2);
  EXPECT_TRUE(document.text().contains(QStringLiteral("in -1..2 animate sine 5s\n")));
  document.undo();
  EXPECT_EQ(document.text(), before) << "one step";
  parameters.setRange(0, 2, 2);
  EXPECT_EQ(document.text(), before) << "an empty range is none";
  parameters.setMotion(0, QStringLiteral("saw"), 2.5);
  EXPECT_TRUE(document.text().contains(QStringLiteral("in 0..2 animate saw 2.5s\n")));
  parameters.setMotion(0, {}, 1);
  EXPECT_TRUE(document.text().contains(QStringLiteral("\"a\" = 0.5 in 0..2\n")));
  parameters.setRange(1, 0, 4);
  parameters.setMotion(1, QStringLiteral("turn"), 3);
  EXPECT_TRUE(document.text().contains(QStringLiteral("= 1 2 3 color in 0..4 animate turn 3s\n")));
  EXPECT_TRUE(parameters.motionsOf(1).contains(QStringLiteral("turn")));
  EXPECT_FALSE(parameters.motionsOf(0).contains(QStringLiteral("turn")));
  parameters.setRange(9, 0, 1);
  parameters.setMotion(-1, QStringLiteral("sine"), 1);
  parameters.add();
  EXPECT_TRUE(document.text().contains(QStringLiteral("#@ local[2].x \"value 2\" = 0.5 in 0..1\n")))
      << document.text().toStdString();
  EXPECT_EQ(parameters.lines().size(), 3);
}

TEST(Textures, AFilterIsAWordOfTheLine) {
  const QString text = QStringLiteral("!!ARBfp1.0\n#@ texture 1 = noise 8 8, nearest\nEND\n");
  const auto set = [&](Sampler kind, const char *word) {
    return applied(text, setSampler(text, 1, kind, QString::fromLatin1(word)));
  };
  EXPECT_TRUE(set(Sampler::Filter, "mipmap").contains(QStringLiteral("noise 8 8, mipmap\n")));
  EXPECT_TRUE(set(Sampler::Wrap, "edge").contains(QStringLiteral("noise 8 8, nearest, edge\n")));
  EXPECT_TRUE(setSampler(text, 0, Sampler::Wrap, QStringLiteral("edge")).isEmpty());
  EXPECT_TRUE(samplerWords(Sampler::Wrap).contains(QStringLiteral("mirror")));
}

} // namespace arbiter::builder
