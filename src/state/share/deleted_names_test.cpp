#include "state/share/deleted_names.h"

#include <gtest/gtest.h>

namespace arbiter::state {
namespace {

using Kind = DeletedNames::Kind;

constexpr GLuint kName = 7;
constexpr std::uint32_t kHere = 1, kThere = 2; // two contexts of the group
constexpr GLuint kFramebuffer = 3;

void deleteName(DeletedNames &names, Kind kind, GLuint name, std::uint32_t serial) {
  names.add(kind, 1, &name, serial);
}

TEST(DeletedNames, ANameThatWasNeverDeletedIsOneObject) {
  DeletedNames names;
  EXPECT_TRUE(names.none());
  EXPECT_TRUE(names.isUniqueWhereBound(Kind::Texture, kName, kHere));
  EXPECT_TRUE(names.isAttached(kHere, kFramebuffer, GL_COLOR_ATTACHMENT0, Kind::Texture, kName));
}

TEST(DeletedNames, ADeletionUnbindsInItsOwnContextAlone) {
  DeletedNames names;
  deleteName(names, Kind::Texture, kName, kHere);
  EXPECT_FALSE(names.none());
  EXPECT_TRUE(names.isUniqueWhereBound(Kind::Texture, kName, kHere));
  EXPECT_FALSE(names.isUniqueWhereBound(Kind::Texture, kName, kThere))
      << "the old object may still be bound there";
  // The other context deletes the next object of that name. Now both contexts may have an old one
  // bound.
  deleteName(names, Kind::Texture, kName, kThere);
  EXPECT_FALSE(names.isUniqueWhereBound(Kind::Texture, kName, kHere));
  EXPECT_FALSE(names.isUniqueWhereBound(Kind::Texture, kName, kThere));
}

TEST(DeletedNames, NamesOfTexturesAndRenderbuffersAreApart) {
  DeletedNames names;
  deleteName(names, Kind::Renderbuffer, kName, kHere);
  EXPECT_TRUE(names.isUniqueWhereBound(Kind::Texture, kName, kThere));
  EXPECT_FALSE(names.isUniqueWhereBound(Kind::Renderbuffer, kName, kThere));
}

TEST(DeletedNames, AnAttachmentIsOfTheObjectThatHadTheNameThen) {
  DeletedNames names;
  const auto isAttached = [&] {
    return names.isAttached(kHere, kFramebuffer, GL_COLOR_ATTACHMENT0, Kind::Texture, kName);
  };
  // It is attached before the first deletion, so the framebuffer keeps the deleted object.
  names.attached(kHere, kFramebuffer, GL_COLOR_ATTACHMENT0, Kind::Texture, kName);
  deleteName(names, Kind::Texture, kName, kThere);
  EXPECT_FALSE(isAttached());
  names.attached(kHere, kFramebuffer, GL_COLOR_ATTACHMENT0, Kind::Texture, kName);
  EXPECT_TRUE(isAttached());
  // Other points, framebuffers and contexts are not affected.
  EXPECT_FALSE(names.isAttached(kHere, kFramebuffer, GL_COLOR_ATTACHMENT1, Kind::Texture, kName));
  EXPECT_FALSE(
      names.isAttached(kHere, kFramebuffer + 1, GL_COLOR_ATTACHMENT0, Kind::Texture, kName));
  EXPECT_FALSE(names.isAttached(kThere, kFramebuffer, GL_COLOR_ATTACHMENT0, Kind::Texture, kName));
  deleteName(names, Kind::Texture, kName, kHere);
  EXPECT_FALSE(isAttached());
}

TEST(DeletedNames, NothingIsDeletedByZeroOrByNoNames) {
  DeletedNames names;
  const GLuint zeros[2] = {0, 0};
  names.add(Kind::Texture, 2, zeros, kHere);
  names.add(Kind::Texture, 3, nullptr, kHere);
  names.add(Kind::Texture, -1, zeros, kHere);
  EXPECT_TRUE(names.none());
}

} // namespace
} // namespace arbiter::state
