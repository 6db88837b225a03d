#include "state/core/errors.h"

#include <gtest/gtest.h>

#include "state/testing/current_context.h"

namespace arbiter::state {
namespace {

using namespace testing;

TEST(Errors, TheHostsPendingErrorCameFirst) {
  FakeHost host;
  const CurrentContext context(host);
  host.error = GL_INVALID_ENUM;
  raise(*context, GL_INVALID_OPERATION, "test");
  EXPECT_EQ(takeError(*context), GLenum(GL_INVALID_ENUM));
  EXPECT_EQ(takeError(*context), GLenum(GL_NO_ERROR)) << "one error is recorded, not two";
}

TEST(Errors, TheLayersCameFirst) {
  FakeHost host;
  const CurrentContext context(host);
  raise(*context, GL_INVALID_VALUE, "test");
  raise(*context, GL_INVALID_OPERATION, "test");
  host.error = GL_INVALID_ENUM;
  EXPECT_EQ(takeError(*context), GLenum(GL_INVALID_VALUE));
  EXPECT_EQ(takeError(*context), GLenum(GL_NO_ERROR));
}

TEST(Errors, AScopeKeepsWhatWaitedAndDropsItsOwn) {
  FakeHost host;
  const CurrentContext context(host);
  host.error = GL_INVALID_ENUM;
  {
    HostErrorScope scope(*context->host, context->errors.pending);
    EXPECT_FALSE(scope.failed());
    host.error = GL_OUT_OF_MEMORY;
    EXPECT_TRUE(scope.failed());
    EXPECT_TRUE(scope.failed()) << "asked twice";
    host.error = GL_OUT_OF_MEMORY;
  }
  EXPECT_EQ(takeError(*context), GLenum(GL_INVALID_ENUM));
  EXPECT_EQ(takeError(*context), GLenum(GL_NO_ERROR));
}

TEST(Errors, BuildingAHostProgramLeavesNone) {
  FakeHost host;
  const CurrentContext context(host);
  use(*context, "!!ARBfp1.0\nMOV result.color, 1;\nEND");
  host.linkFails = true;
  host.error = GL_STACK_OVERFLOW; // the application's, raised before
  EXPECT_FALSE(draw(*context));
  EXPECT_EQ(takeError(*context), GLenum(GL_STACK_OVERFLOW));
  EXPECT_EQ(takeError(*context), GLenum(GL_NO_ERROR));
}

} // namespace
} // namespace arbiter::state
