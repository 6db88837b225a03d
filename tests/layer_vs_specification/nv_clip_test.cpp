// User clip planes with programs in NVIDIA's languages, by distances that they write, or not at
// all. Needs a profile that has the languages (nv40).
#include "nv_commands.h"

namespace api::nv {
namespace {

/// Writes distances in x: 1 at the right edge, -1 at the left.
constexpr char kClippedVp[] =
    "!!VP2.0\nMOV o[HPOS], v[OPOS];\nMOV o[COL0], v[COL0];\nMOV o[CLP1].x, v[OPOS].x;\nEND";
constexpr char kClippedOption[] =
    "!!ARBvp1.0\nOPTION NV_vertex_program2;\nMOV result.position, vertex.position;\n"
    "MOV result.color, vertex.color;\nMOV result.clip[1].x, vertex.position.x;\nEND";

TEST_F(NvTest, DistancesClipWhereTheirPlaneIsEnabled) {
  const GLdouble left[] = {-1, 0, 0, 0}; // ignored: the distances count
  glClipPlane(GL_CLIP_PLANE1, left);
  glColor4f(0, 0, 1, 1);
  for (const char *text : {kClippedVp, kClippedOption}) {
    use(kVertexNv, 26, text);
    (void)quad();
    EXPECT_EQ(readPixel(4, 16), kBluePixel) << text;
    glEnable(GL_CLIP_PLANE1);
    (void)quad();
    EXPECT_NE(readPixel(4, 16), kBluePixel) << text;
    EXPECT_EQ(readPixel(20, 16), kBluePixel) << text;
    glEnable(GL_CLIP_PLANE0); // no distance is written for it
    (void)quad();
    EXPECT_NE(readPixel(4, 16), kBluePixel) << text;
    EXPECT_EQ(readPixel(20, 16), kBluePixel) << text;
    glDisable(GL_CLIP_PLANE1);
    (void)quad();
    EXPECT_EQ(readPixel(4, 16), kBluePixel) << text;
    glDisable(GL_CLIP_PLANE0);
  }
}

TEST_F(NvTest, DistancesFollowPlanesThatListsEnable) {
  use(kVertexNv, 29, kClippedVp);
  glColor4f(0, 0, 1, 1);
  const GLuint lists = glGenLists(3);
  glNewList(lists, GL_COMPILE);
  glEnable(GL_CLIP_PLANE1);
  glEndList();
  glNewList(lists + 1, GL_COMPILE);
  glDisable(GL_CLIP_PLANE1);
  glEndList();
  glNewList(lists + 2, GL_COMPILE);
  glBegin(GL_QUADS);
  vertices();
  glEnd();
  glEndList();
  const auto clips = [&](bool listed) {
    clear();
    if (listed) {
      glCallList(lists + 2);
    } else {
      glBegin(GL_QUADS);
      vertices();
      glEnd();
    }
    EXPECT_EQ(readPixel(20, 16), kBluePixel);
    return readPixel(4, 16) != kBluePixel;
  };
  for (const bool listed : {false, true}) {
    EXPECT_FALSE(clips(listed)) << "compiled, not called";
    glCallList(lists);
    EXPECT_TRUE(clips(listed));
    glCallList(lists + 1);
    EXPECT_FALSE(clips(listed));
  }
  glPushAttrib(GL_ENABLE_BIT);
  glCallList(lists);
  EXPECT_TRUE(clips(false));
  glPopAttrib();
  EXPECT_FALSE(clips(false));
  // The plane is enabled in the list that draws.
  glNewList(lists + 2, GL_COMPILE);
  glEnable(GL_CLIP_PLANE1);
  glBegin(GL_QUADS);
  vertices();
  glEnd();
  glDisable(GL_CLIP_PLANE1);
  glEndList();
  EXPECT_TRUE(clips(true));
  EXPECT_FALSE(clips(false));
  glDeleteLists(lists, 3);
}

TEST_F(NvTest, PlanesDoNotClipNvidiasOwnPrograms) {
  const GLdouble right[] = {1, 0, 0, 0};
  glClipPlane(GL_CLIP_PLANE0, right);
  glEnable(GL_CLIP_PLANE0);
  glColor4f(0, 0, 1, 1);
  for (const std::string text :
       {kThroughVp, "!!VP1.1\nOPTION NV_position_invariant;\nMOV o[COL0], v[COL0];\nEND",
        "!!VP2.0\nMOV o[HPOS], v[OPOS];\nMOV o[COL0], v[COL0];\nEND"}) {
    use(kVertexNv, 27, text);
    (void)quad();
    EXPECT_EQ(readPixel(4, 16), kBluePixel) << text;
  }
  use(kVertexNv, 28,
      "!!ARBvp1.0\nOPTION NV_vertex_program2;\nOPTION ARB_position_invariant;\n"
      "MOV result.color, vertex.color;\nEND");
  (void)quad();
  EXPECT_NE(readPixel(4, 16), kBluePixel) << "fixed function's position is clipped as it is there";
  EXPECT_EQ(readPixel(20, 16), kBluePixel);
  glDisable(GL_CLIP_PLANE0);
}

} // namespace
} // namespace api::nv
