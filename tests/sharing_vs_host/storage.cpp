// Tests objects that share storage or that shaders write: sharing-storage SCENE, or
// `sharing-storage --list`. Each scene draws to one object with a fragment program and samples the
// other. The samples are written as records, which comparisons.py compares. Exits with 77 if the
// host lacks the scene's feature.

#include "storage.h"

namespace storage {

namespace {

void views() {
  const GLuint original = makeTexture(true);
  fill(original, 40);
  show(original, "the original, before");
  const GLuint view = viewOf(original);
  show(view, "the view, as it was made");
  fill(original, 80);
  show(view, "the view, after the original was drawn to");
  fill(view, 120);
  show(original, "the original, after the view was drawn to");
  const std::vector<unsigned char> half(std::size_t(kEdge) * kEdge * 2, 200);
  glBindTexture(GL_TEXTURE_2D, view);
  glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kEdge, kEdge / 2, GL_RGBA, GL_UNSIGNED_BYTE, half.data());
  show(original, "the original, after texels of the view were replaced");
  fill(original, 30);
  const GLuint second = viewOf(view);
  fill(second, 60);
  show(original, "the original, after a view of the view was drawn to");
  fill(original, 90);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, framebufferOf(original));
  glBindTexture(GL_TEXTURE_2D, second);
  glCopyTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, 0, 0, kEdge / 2, kEdge);
  show(view, "the view, after a copy to another one");
}

/// Tests the content of a deleted view, and of the next object with its name.
void deletedViews() {
  const GLuint original = makeTexture(true);
  GLuint view = viewOf(original);
  fill(view, 70);
  glDeleteTextures(1, &view);
  show(original, "the original, after its view was deleted");
  const GLuint next = makeTexture(false);
  for (int i = 0; i < 40; ++i) {
    fill(next, 50 + i);
    show(next, "a texture of its own, perhaps of the view's name");
  }
  fill(original, 110);
  show(next, "that texture, after the original was drawn to");
}

/// Tests views of one level and one layer.
void partialViews() {
  const GLuint plain = makeTexture(false);
  fill(plain, 15); // the rasterizer has been used by now
  show(plain, "a texture that no other has texels of");
  GLuint names[2];
  glGenTextures(2, names);
  glBindTexture(GL_TEXTURE_2D, names[0]);
  glTexStorage2D(GL_TEXTURE_2D, 2, GL_RGBA8, 2 * kEdge, 2 * kEdge);
  glTextureView(names[1], GL_TEXTURE_2D, names[0], GL_RGBA8, 1, 1, 0, 1);
  unfiltered(names[1]);
  glBindTexture(GL_TEXTURE_2D, names[0]);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_BASE_LEVEL, 1);
  unfiltered(names[0]);
  fill(names[1], 90);
  show(names[0], "level 1, after its view was drawn to");
  GLuint array = 0, layer = 0;
  glGenTextures(1, &array);
  glGenTextures(1, &layer);
  glBindTexture(GL_TEXTURE_2D_ARRAY, array);
  glTexStorage3D(GL_TEXTURE_2D_ARRAY, 1, GL_RGBA8, kEdge, kEdge, 3);
  glTextureView(layer, GL_TEXTURE_2D, array, GL_RGBA8, 0, 1, 1, 1);
  unfiltered(layer);
  fill(layer, 35);
  show(layer, "a layer's view");
  GLuint framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, array, 0, 1);
  drawFilled(145);
  show(layer, "a layer's view, after the layer was drawn to");
}

/// Tests views made in a context of the group that bypasses the layer.
void viewsOfOthers() {
  const GLuint original = makeTexture(true);
  fill(original, 40);
  show(original, "the original");
  GLuint view = 0;
  inCoreContext([&] { view = viewOf(original); });
  fill(original, 80);
  show(view, "the view, after the original was drawn to");
  fill(view, 120);
  show(original, "the original, after the view was drawn to");
}

void copiedImages() {
  const GLuint from = makeTexture(true), to = makeTexture(false);
  fill(to, 20);
  show(to, "before");
  fill(from, 160);
  glFlush(); // Mesa 22.3.6 copies before it draws the rectangles that it has collected
  glCopyImageSubData(from, GL_TEXTURE_2D, 0, 0, 0, 0, to, GL_TEXTURE_2D, 0, 3, 3, 0, 9, 9, 1);
  show(to, "after a part was copied");
  const unsigned char color[4] = {9, 99, 199, 255};
  glClearTexSubImage(to, 0, 5, 5, 0, 3, 3, 1, GL_RGBA, GL_UNSIGNED_BYTE, color);
  show(to, "after a part was cleared");
}

constexpr const char *kStoresTexels =
    "#version 430 compatibility\nlayout(rgba8) uniform writeonly image2D to;\nvoid main() {\n"
    "  ivec2 at = ivec2(gl_FragCoord.xy);\n"
    "  if (at.x > at.y) imageStore(to, at, vec4(at, 7, 16) / 16.0);\n"
    "  gl_FragColor = vec4(0);\n}\n";

void storedTexels() {
  const GLuint texture = makeTexture(true);
  const GLuint program = makeShaders(kStoresTexels);
  glBindImageTexture(0, texture, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA8);
  for (const bool sampledBefore : {true, false}) {
    fill(texture, 60);
    if (sampledBefore)
      show(texture, "before the stores");
    runShaders(program, [] {});
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
    show(texture, "after the stores");
  }
}

constexpr const char *kStoresVertices =
    "#version 430 compatibility\nlayout(std430, binding = 0) buffer To { vec2 to[]; };\n"
    "void main() {\n"
    "  if (ivec2(gl_FragCoord.xy) == ivec2(0)) to[1] = vec2(1.0, 1.0);\n"
    "  gl_FragColor = vec4(0);\n}\n";
constexpr const char *kStoresVerticesAsTexels =
    "#version 430 compatibility\nlayout(rg32f) uniform writeonly imageBuffer to;\nvoid main() {\n"
    "  if (ivec2(gl_FragCoord.xy) == ivec2(0)) imageStore(to, 1, vec4(1.0, 1.0, 0, 0));\n"
    "  gl_FragColor = vec4(0);\n}\n";

/// Tests vertices that shaders have written.
void storedVertices(bool byTexture) {
  const GLfloat triangle[6] = {-1, -1, 0, -1, -1, 1};
  GLuint buffer = 0, texture = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, sizeof triangle, triangle, GL_STATIC_DRAW);
  glVertexPointer(2, GL_FLOAT, 0, nullptr);
  glEnableClientState(GL_VERTEX_ARRAY);
  const GLuint program = makeShaders(byTexture ? kStoresVerticesAsTexels : kStoresVertices);
  const GLuint result = makeTexture(false);
  const auto draw = [&](const char *name) {
    fill(result, 10);
    glColor4ub(250, 150, 50, 255);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    show(result, name);
  };
  for (int i = 0; i < 6; ++i) // often enough that vertices may be cached
    draw("before the store");
  runShaders(program, [&] {
    if (byTexture) {
      glGenTextures(1, &texture);
      glBindTexture(GL_TEXTURE_BUFFER, texture);
      glTexBuffer(GL_TEXTURE_BUFFER, GL_RG32F, buffer);
      glBindImageTexture(0, texture, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RG32F);
    } else {
      glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, buffer);
    }
    for (int i = 0; i < 6; ++i)
      draw("bound, before the store");
  });
  glMemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT);
  draw("after the store");
}

struct Scene {
  const char *name;
  void (*draw)();
  void (*open)() = storage::open;
};
constexpr Scene kScenes[] = {
    {"views", views},
    {"deleted-views", deletedViews},
    {"partial-views", partialViews},
    {"views-of-others", viewsOfOthers},
    {"copied-images", copiedImages},
    {"stored-texels", storedTexels},
    {"stored-vertices", [] { storedVertices(false); }},
    {"buffer-texture", [] { storedVertices(true); }},
    {"imported-memory", importedMemory},
    {"bound-pixmap", boundPixmap, openScreen},
};

} // namespace
} // namespace storage

int main(int argc, char **argv) {
  const storage::Scene *const scene = software::rowNamed(storage::kScenes, argc, argv);
  if (!scene)
    return 2;
  scene->open();
  scene->draw();
  software::record("errors" + software::takeErrors(), {});
  return 0;
}
