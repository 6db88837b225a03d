// Draws Clutter actors that rotate by a fixed step a frame: a picture, colors, a blur effect.
// Cogl's driver for fixed-function GL generates a fragment program for each material.
#include <clutter/clutter.h>
#include <vector>

namespace {

constexpr int kFrames = 16;
constexpr int kSide = 64;

struct Scene {
  ClutterActor *stage = nullptr;
  std::vector<ClutterActor *> actors;
  int frame = 0;
};

ClutterContent *makePicture() {
  std::vector<guint8> texels;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const bool light = (x / 8 + y / 8) % 2 == 0;
      texels.insert(texels.end(), {guint8(light ? 250 : 40), guint8(x * 4), guint8(y * 4),
                                   guint8(light ? 255 : 180)});
    }
  }
  ClutterContent *picture = clutter_image_new();
  clutter_image_set_data(CLUTTER_IMAGE(picture), texels.data(), COGL_PIXEL_FORMAT_RGBA_8888, kSide,
                         kSide, kSide * 4, nullptr);
  return picture;
}

void addActor(Scene &scene, float x, float y, ClutterContent *content, ClutterEffect *effect) {
  ClutterActor *actor = clutter_actor_new();
  clutter_actor_set_size(actor, 90, 90);
  clutter_actor_set_position(actor, x, y);
  clutter_actor_set_pivot_point(actor, 0.5F, 0.5F);
  if (content) {
    clutter_actor_set_content(actor, content);
  } else {
    const ClutterColor color = {200, 90, 40, 160};
    clutter_actor_set_background_color(actor, &color);
  }
  if (effect)
    clutter_actor_add_effect(actor, effect);
  clutter_actor_add_child(scene.stage, actor);
  scene.actors.push_back(actor);
}

gboolean step(gpointer data) {
  Scene &scene = *static_cast<Scene *>(data);
  if (++scene.frame > kFrames) {
    clutter_main_quit();
    return G_SOURCE_REMOVE;
  }
  double angle = 11.0 * scene.frame;
  for (ClutterActor *actor : scene.actors) {
    clutter_actor_set_rotation_angle(actor, CLUTTER_Z_AXIS, angle);
    clutter_actor_set_rotation_angle(actor, CLUTTER_Y_AXIS, angle / 3);
    angle = -angle * 0.8;
  }
  return G_SOURCE_CONTINUE;
}

} // namespace

int main(int argc, char **argv) {
  if (clutter_init(&argc, &argv) != CLUTTER_INIT_SUCCESS)
    return 1;
  Scene scene;
  scene.stage = clutter_stage_new();
  clutter_actor_set_size(scene.stage, 320, 240);
  ClutterContent *picture = makePicture();
  addActor(scene, 30, 30, picture, nullptr);
  addActor(scene, 150, 40, nullptr, nullptr);
  const ClutterColor tint = {120, 200, 255, 255};
  addActor(scene, 60, 130, picture, clutter_colorize_effect_new(&tint));
  addActor(scene, 190, 130, picture, clutter_desaturate_effect_new(0.7));
  clutter_actor_show(scene.stage);
  g_timeout_add(120, step, &scene);
  clutter_main();
  return 0;
}
