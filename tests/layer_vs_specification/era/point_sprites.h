#pragma once
#include "../fixture.h"

namespace api {

class EraPointSprites : public ApiTest {
protected:
  void SetUp() override {
    ApiTest::SetUp();
    NEEDS("GL_NV_point_sprite");
  }
};

inline GLint rMode() {
  GLint value = -1;
  glGetIntegerv(GL_POINT_SPRITE_R_MODE_NV, &value);
  return value;
}

inline GLint replaces() {
  GLint value = -1;
  glGetTexEnviv(GL_POINT_SPRITE_NV, GL_COORD_REPLACE_NV, &value);
  return value;
}

} // namespace api
