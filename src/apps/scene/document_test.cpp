#include "apps/scene/document.h"

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <map>
#include <sys/stat.h>
#include <unistd.h>

namespace arbiter::scene {
namespace {

using testing::HasSubstr;

/// Returns a reader of files in memory.
ReadText from(std::map<std::string, std::string> files) {
  return [files = std::move(files)](const std::string &path) -> Result<std::string, DocumentError> {
    const auto found = files.find(path);
    if (found == files.end())
      return DocumentError{path + ": No such file"};
    return found->second;
  };
}

TEST(Document, PassesHaveTheirProgramsAndWhatTheFirstOneSays) {
  const Document document =
      assemble("d/main.fp",
               "!!ARBfp1.0\n#@ size 64 32, vertex a.vp, then b.fp, then b.fp\n"
               "#@ target t 16 8, mesh sphere, camera orbit\nEND\n",
               from({{"d/a.vp", "!!ARBvp1.0\n#@ local[0] = 1\nEND"},
                     {"d/b.fp", "!!ARBfp1.0\n#@ mesh quad, camera none\n#@ local[0..3] = camera t\n"
                                "#@ texture 0 = picture t\nEND"}}));
  EXPECT_TRUE(document.ok());
  ASSERT_EQ(document.passes.size(), 3u);
  EXPECT_EQ(document.files.size(), 3u) << "a file that is named twice is read once";
  EXPECT_EQ(document.passes[0].vertex, 1);
  EXPECT_EQ(document.passes[1].fragment, 2);
  EXPECT_EQ(document.passes[1].vertex, -1);
  EXPECT_EQ(document.sizeOf(document.passes[0]), std::pair(16, 8));
  EXPECT_EQ(document.sizeOf(document.passes[2]), std::pair(64, 32));
  EXPECT_EQ(document.depthOf(document.passes[0]), Depth::Less);
  EXPECT_EQ(document.depthOf(document.passes[1]), Depth::Off);
  EXPECT_EQ(document.rows(document.passes[0], 1, 0).size(), 1u);
  EXPECT_EQ(document.rows(document.passes[1], 2, 0).size(), 4u);
}

TEST(Document, AFurtherPassKeepsMeshAndCameraOfTheFirst) {
  const Document document =
      assemble("m.fp", "!!ARBfp1.0\n#@ mesh torus, camera orbit, then n.fp\nEND",
               from({{"n.fp", "!!ARBfp1.0\nEND"}}));
  EXPECT_EQ(document.meshOf(document.passes[1])[0].shape.value, Shape::Torus);
  EXPECT_EQ(document.cameraOf(document.passes[1])->kind.value, CameraKind::Orbit);
}

struct Wrong {
  const char *text;
  const char *said;
};

TEST(Document, WrongLinesAreToldInTheFileThatHasThem) {
  const auto files = from({{"f.fp", "!!ARBfp1.0\nEND"}});
  for (const Wrong &wrong :
       {Wrong{"!!ARBfp1.0\n#@ vertex none.vp\n", "none.vp: No such file"},
        Wrong{"!!ARBfp1.0\n#@ vertex f.fp\n", "f.fp is no vertex program"},
        Wrong{"!!ARBfp1.0\n#@ texture 0 = picture q\n", "no pass draws into a target 'q'"},
        Wrong{"!!ARBfp1.0\n#@ local[0..3] = camera q\n", "no pass draws into a target 'q'"},
        Wrong{"!!ARBfp1.0\n#@ target q 4 4, texture 0 = picture q\n",
              "reads the target that it"}}) {
    const Document document = assemble("x.fp", wrong.text, files);
    EXPECT_FALSE(document.ok()) << wrong.text;
    ASSERT_EQ(document.panel().diagnostics.size(), 1u) << wrong.text;
    EXPECT_THAT(document.panel().diagnostics[0].message, HasSubstr(wrong.said));
  }
  std::string many = "!!ARBfp1.0\n";
  for (int i = 0; i < 40; ++i)
    many += "#@ then f.fp\n";
  const Document document = assemble("x.fp", many, files);
  EXPECT_EQ(document.passes.size(), 16u);
  EXPECT_FALSE(document.ok());
}

TEST(Document, AProfileIsANameOrAFileBesideIt) {
  const auto files =
      from({{"d/mine.toml", "inherits = 'nv30'\n"}, {"d/bad.toml", "inherits = 3\n"}});
  const auto made = [&](const std::string &name) {
    return assemble("d/x.fp", "!!ARBfp1.0\n#@ profile " + name + "\nEND\n", files);
  };
  EXPECT_EQ(made("nv30").profile(), "nv30");
  EXPECT_EQ(made("mine.toml").profile(), "d/mine.toml");
  EXPECT_TRUE(made("mine.toml").ok());
  for (const auto &[name, said] :
       {std::pair<const char *, const char *>{"bad.toml", "d/bad.toml:1:"},
        {"none.toml", "d/none.toml: No such file"},
        {"\"../up.toml\"", "leads out of the document's folder"}}) {
    const Document document = made(name);
    EXPECT_FALSE(document.ok()) << name;
    ASSERT_EQ(document.panel().diagnostics.size(), 1u) << name;
    EXPECT_THAT(document.panel().diagnostics[0].message, HasSubstr(said));
    EXPECT_EQ(document.panel().diagnostics[0].span.begin, 22u) << name;
  }
  const Document unknown = made("nv31");
  EXPECT_TRUE(unknown.ok()) << "a word without a meaning is kept";
  EXPECT_EQ(unknown.profile(), "");
  ASSERT_EQ(unknown.panel().diagnostics.size(), 1u);
  EXPECT_EQ(unknown.panel().diagnostics[0].severity, fp::Severity::Warning);
}

TEST(Document, AFolderIsOpenedByItsProgram) {
  namespace fs = std::filesystem;
  std::string folder = (fs::temp_directory_path() / "arbiter-document-XXXXXX").string();
  ASSERT_NE(::mkdtemp(folder.data()), nullptr);
  const auto write = [&](const char *name) {
    std::ofstream(folder + "/" + name) << "!!ARBfp1.0\nEND\n";
  };
  EXPECT_FALSE(loadDocument(folder)) << "there is none";
  write("one.fp");
  ASSERT_TRUE(loadDocument(folder));
  EXPECT_EQ(loadDocument(folder + "/").value().files[0].name, folder + "/one.fp");
  write("two.fp");
  EXPECT_THAT(loadDocument(folder).error().message, HasSubstr("no document"));
  write("main.fp");
  EXPECT_EQ(loadDocument(folder).value().files[0].name, folder + "/main.fp");
  EXPECT_FALSE(loadDocument(folder + "/none.fp"));
  ASSERT_EQ(::mkfifo((folder + "/pipe.fp").c_str(), 0600), 0);
  EXPECT_THAT(loadDocument(folder + "/pipe.fp").error().message, HasSubstr("no regular file"));
  fs::remove_all(folder);
}

} // namespace
} // namespace arbiter::scene
