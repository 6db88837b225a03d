// Reads images from good and hostile files. The test makes JPEG files by the library, DDS files by
// hand.
#include <csetjmp>
#include <cstdio>
// This include must follow cstdio.
#include <jpeglib.h>

#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <random>
#include <unistd.h>

#include "apps/scene/testing/rounds.h"
#include "apps/scene/texture/dds_format.h"
#include "apps/scene/texture/generate.h"
#include "apps/scene/texture/read_image.h"

namespace arbiter::scene {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string jpegOf(int width, int height, bool progressive) {
  jpeg_compress_struct info = {};
  jpeg_error_mgr errors = {};
  info.err = jpeg_std_error(&errors);
  jpeg_create_compress(&info);
  unsigned char *bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&info, &bytes, &size);
  info.image_width = JDIMENSION(width);
  info.image_height = JDIMENSION(height);
  info.input_components = 3;
  info.in_color_space = JCS_RGB;
  jpeg_set_defaults(&info);
  jpeg_set_quality(&info, 95, TRUE);
  if (progressive)
    jpeg_simple_progression(&info);
  jpeg_start_compress(&info, TRUE);
  for (int y = 0; y < height; ++y) {
    // The picture is red above and blue below.
    std::vector<unsigned char> row;
    for (int x = 0; x < width; ++x)
      row.insert(row.end(), {std::uint8_t(y * 2 < height ? 255 : 0), 0,
                             std::uint8_t(y * 2 < height ? 0 : 255)});
    JSAMPROW rows = row.data();
    jpeg_write_scanlines(&info, &rows, 1);
  }
  jpeg_finish_compress(&info);
  std::string text(reinterpret_cast<char *>(bytes), size);
  std::free(bytes);
  jpeg_destroy_compress(&info);
  return text;
}

TEST(Jpeg, BaselineAndProgressive) {
  for (const bool progressive : {false, true}) {
    const auto picture = decodeJpeg(jpegOf(32, 16, progressive));
    ASSERT_TRUE(picture) << picture.error().message;
    EXPECT_EQ(picture.value().width, 32);
    EXPECT_EQ(picture.value().height, 16);
    ASSERT_EQ(picture.value().bytes.size(), 32u * 16 * 4);
    EXPECT_GT(picture.value().bytes[0], 240) << "the topmost row first";
    EXPECT_GT(picture.value().bytes[picture.value().bytes.size() - 2], 240);
    EXPECT_EQ(picture.value().bytes[3], 255);
  }
}

TEST(Jpeg, HostileFilesAreErrors) {
  for (const bool progressive : {false, true}) {
    const std::string whole = jpegOf(64, 48, progressive);
    for (std::size_t size = 0; size < whole.size() - 2; size += 1 + size / 40)
      EXPECT_FALSE(decodeJpeg(std::string_view(whole).substr(0, size))) << size;
    std::minstd_rand random(3);
    for (int i = 0; i < hostileRounds(400); ++i) {
      std::string changed = whole;
      for (int k = 0; k < 3; ++k)
        changed[random() % changed.size()] = char(random());
      (void)decodeJpeg(changed);
    }
  }
  std::string huge = jpegOf(8, 8, false);
  const std::size_t frame = huge.find("\xff\xc0");
  ASSERT_NE(frame, std::string::npos);
  for (std::size_t i = 5; i < 9; ++i)
    huge[frame + i] = '\xff'; // height and width 65535
  const auto picture = decodeJpeg(huge);
  ASSERT_FALSE(picture);
  EXPECT_THAT(picture.error().message, HasSubstr("this JPEG cannot be read: "));
}

void put(std::string &bytes, std::size_t at, std::uint32_t value) {
  for (unsigned i = 0; i < 4; ++i)
    bytes[at + i] = char(value >> 8 * i);
}

/// Returns a header without texels.
std::string header(std::uint32_t width, std::uint32_t height, std::uint32_t levels = 0) {
  std::string bytes(128, '\0');
  bytes.replace(0, 4, "DDS ");
  put(bytes, 4, 124);
  put(bytes, 12, height);
  put(bytes, 16, width);
  put(bytes, 28, levels);
  put(bytes, 76, 32);
  return bytes;
}

std::string coded(const char *code, std::string bytes) {
  put(bytes, 80, 0x4);
  bytes.replace(84, 4, code);
  return bytes;
}

/// Sets a format of 32 bits: blue, green, red, alpha.
std::string plain(std::string bytes) {
  put(bytes, 80, 0x41);
  put(bytes, 88, 32);
  put(bytes, 92, 0xFF0000);
  put(bytes, 96, 0xFF00);
  put(bytes, 100, 0xFF);
  put(bytes, 104, 0xFF000000);
  return bytes;
}

std::vector<Image> decoded(const std::string &bytes) {
  auto images = decodeDds(bytes);
  EXPECT_TRUE(images) << images.error().message;
  return images ? std::move(images).value() : std::vector<Image>(1, Image(1, 1));
}

std::array<int, 4> texel(const Image &image, int x, int y) {
  const std::size_t first = 4 * (std::size_t(y) * std::size_t(image.width) + std::size_t(x));
  std::array<int, 4> values = {};
  for (std::size_t i = 0; i < 4; ++i)
    values[i] = image.texels[first + i];
  return values;
}

/// Returns red (31, 0, 0) and blue (0, 0, 31). Their order decides whether the block has four
/// colors or three.
std::string colors(bool redFirst, const char (&indices)[5]) {
  return (redFirst ? std::string("\x00\xf8\x1f\x00", 4) : std::string("\x1f\x00\x00\xf8", 4)) +
         std::string(indices, 4);
}

TEST(Dds, BlocksOfTheThreeKinds) {
  // Each row of a block has indices 0 1 2 3, from the lowest bits up.
  const auto four = decoded(coded("DXT1", header(4, 4)) + colors(true, "\xe4\0\x55\xff"))[0];
  EXPECT_THAT(texel(four, 0, 0), ElementsAre(255, 0, 0, 255));
  EXPECT_THAT(texel(four, 1, 0), ElementsAre(0, 0, 255, 255));
  EXPECT_THAT(texel(four, 2, 0), ElementsAre(170, 0, 85, 255));
  EXPECT_THAT(texel(four, 3, 0), ElementsAre(85, 0, 170, 255));
  EXPECT_THAT(texel(four, 0, 2), ElementsAre(0, 0, 255, 255));
  const auto three = decoded(coded("DXT1", header(4, 4)) + colors(false, "\xe4\0\0\0"))[0];
  EXPECT_THAT(texel(three, 2, 0), ElementsAre(128, 0, 128, 255));
  EXPECT_THAT(texel(three, 3, 0), ElementsAre(0, 0, 0, 0));
  const std::string nibbles("\x10\x32\x54\x76\x98\xba\xdc\xfe", 8);
  const auto stepped =
      decoded(coded("DXT3", header(4, 4)) + nibbles + colors(false, "\xff\0\0\0"))[0];
  EXPECT_THAT(texel(stepped, 0, 0), ElementsAre(170, 0, 85, 0)) << "four colours, in any order";
  EXPECT_EQ(texel(stepped, 3, 3)[3], 255);
  EXPECT_EQ(texel(stepped, 1, 0)[3], 17);
  // The bytes 0x88 0xc6 0xfa are the indices 0 to 7 of three bits each.
  const std::string eight("\xff\x00\x88\xc6\xfa\0\0\0", 8), six("\x00\xff\x88\xc6\xfa\0\0\0", 8);
  const auto mixed = decoded(coded("DXT5", header(4, 4)) + eight + colors(true, "\0\0\0\0"))[0];
  EXPECT_EQ(texel(mixed, 1, 0)[3], 0);
  EXPECT_EQ(texel(mixed, 2, 0)[3], 219);
  EXPECT_EQ(texel(mixed, 3, 1)[3], 36);
  const auto fewer = decoded(coded("DXT5", header(4, 4)) + six + colors(true, "\0\0\0\0"))[0];
  EXPECT_EQ(texel(fewer, 2, 0)[3], 51);
  EXPECT_EQ(texel(fewer, 2, 1)[3], 0);
  EXPECT_EQ(texel(fewer, 3, 1)[3], 255);
}

TEST(Dds, PlainTexelsByTheirMasks) {
  EXPECT_THAT(texel(decoded(plain(header(1, 1)) + "\x01\x02\x03\x04")[0], 0, 0),
              ElementsAre(3, 2, 1, 4));
  std::string short565 = header(1, 1);
  put(short565, 80, 0x40);
  put(short565, 88, 16);
  put(short565, 92, 0xF800);
  put(short565, 96, 0x7E0);
  put(short565, 100, 0x1F);
  EXPECT_THAT(texel(decoded(short565 + "\x1f\xf8")[0], 0, 0), ElementsAre(255, 0, 255, 255));
  std::string grey = header(1, 1);
  put(grey, 80, 0x20000);
  put(grey, 88, 8);
  put(grey, 92, 0xFF);
  EXPECT_THAT(texel(decoded(grey + "\x80")[0], 0, 0), ElementsAre(128, 128, 128, 255));
}

TEST(Dds, LevelsAndCutBlocks) {
  const std::string block = colors(true, "\0\0\0\0"), other = colors(false, "\0\0\0\0");
  const auto image = decoded(coded("DXT1", header(6, 2, 3)) + block + other + block + other)[0];
  EXPECT_EQ(image.width, 6);
  EXPECT_THAT(texel(image, 5, 1), ElementsAre(0, 0, 255, 255)) << "of the second block";
  ASSERT_EQ(image.smaller.size(), 2u);
  EXPECT_EQ(image.smaller[0].width, 3);
  EXPECT_EQ(image.smaller[1].height, 1);
  EXPECT_THAT(texel(image.smaller[1], 0, 0), ElementsAre(0, 0, 255, 255));
}

std::string cubeOf(const std::string &texels) {
  std::string bytes = plain(header(1, 1));
  put(bytes, 112, 0xFE00);
  return bytes + texels;
}

TEST(Dds, ACubeMapHasSixFaces) {
  std::string texels;
  for (int face = 0; face < 6; ++face)
    texels += std::string(3, '\0') + char(face);
  const auto faces = decoded(cubeOf(texels));
  ASSERT_EQ(faces.size(), 6u);
  EXPECT_EQ(texel(faces[5], 0, 0)[3], 5);
}

TEST(Dds, TheNewerHeader) {
  std::string bytes = coded("DX10", header(4, 4)) + std::string(20, '\0');
  put(bytes, 128, 77);
  put(bytes, 132, 3);
  put(bytes, 140, 1);
  const std::string block = std::string(8, '\xff') + colors(true, "\0\0\0\0");
  EXPECT_THAT(texel(decoded(bytes + block)[0], 0, 0), ElementsAre(255, 0, 0, 255));
  put(bytes, 136, 4);
  EXPECT_EQ(decoded(bytes + block + block + block + block + block + block).size(), 6u);
  put(bytes, 128, 98);
  EXPECT_THAT(decodeDds(bytes + block).error().message, HasSubstr("DXGI 98"));
}

struct Wrong {
  std::string bytes;
  const char *said;
};

TEST(Dds, HostileFilesAreErrorsBeforeMemoryIsAskedFor) {
  std::string volume = plain(header(1, 1)), faces = volume, wide = volume, bits = volume;
  put(volume, 112, 0x200000);
  put(faces, 112, 0x200 | 0x400);
  put(wide, 92, 0x3FF);
  put(bits, 88, 31);
  for (const Wrong &wrong :
       {Wrong{"DDS ", "no whole header"}, Wrong{header(4, 4).substr(0, 127), "no whole header"},
        Wrong{plain(header(0, 4)), "not 0x4"}, Wrong{plain(header(1, 1)), "ends too early"},
        Wrong{plain(header(0xFFFFFFFF, 0xFFFFFFFF)), "4294967295x4294967295"},
        Wrong{plain(header(8192, 8192)), "ends too early: 268435456 bytes of texels, and 0"},
        Wrong{coded("DXT1", header(8192, 8192, 14)), "more than 2^26 texels"},
        Wrong{plain(header(4, 4, 9)), "9 levels"}, Wrong{plain(header(4, 4, 0xFFFFFFFF)), "levels"},
        Wrong{coded("DXT2", header(4, 4)), "none of DXT1"}, Wrong{header(4, 4), "no colours"},
        Wrong{coded("DX10", header(4, 4)), "no whole header"}, Wrong{volume, "3D image"},
        Wrong{faces, "are missing"}, Wrong{wide, "at most 8 bits"}, Wrong{bits, "8, 16, 24 or"},
        Wrong{cubeOf("\1\2\3\4"), "ends too early: 24 bytes of texels, and 4"}}) {
    const auto images = decodeDds(wrong.bytes);
    ASSERT_FALSE(images) << wrong.said;
    EXPECT_THAT(images.error().message, HasSubstr(wrong.said));
  }
}

// Sizes, levels, masks and formats do not fit the bytes that follow.
TEST(Dds, ChangedBytesAreErrorsOrImages) {
  const std::string texels(700, '\x5a');
  std::string newer = coded("DX10", header(8, 8, 4)) + std::string(20, '\0');
  put(newer, 128, 28);
  put(newer, 132, 3);
  put(newer, 140, 1);
  std::string cube = plain(header(4, 4, 3));
  put(cube, 112, 0xFE00);
  const std::string wholes[] = {coded("DXT5", header(8, 8, 4)) + texels.substr(0, 160),
                                coded("DXT1", header(7, 5)) + texels,
                                plain(header(9, 3, 4)) + texels, cube + texels, newer + texels};
  std::minstd_rand random(9);
  for (int i = 0; i < hostileRounds(5000); ++i) {
    const std::string &whole = wholes[std::size_t(i) % std::size(wholes)];
    std::string changed = whole.substr(0, random() % 2 ? whole.size() : random() % whole.size());
    for (int k = 0; k < 2 && !changed.empty(); ++k)
      changed[random() % std::min<std::size_t>(changed.size(), 148)] = char(random());
    const auto images = decodeDds(changed);
    if (!images)
      continue;
    EXPECT_TRUE(images.value().size() == 1 || images.value().size() == 6);
    for (const Image &image : images.value())
      EXPECT_EQ(image.texels.size(), std::size_t(4) * std::size_t(image.width * image.height));
  }
}

class ImageFiles : public testing::Test {
protected:
  void SetUp() override {
    m_folder = testing::TempDir() + "arbiter-images-" + std::to_string(::getpid()) + "/";
    std::filesystem::create_directory(m_folder);
  }
  void TearDown() override { std::filesystem::remove_all(m_folder); }

  void write(const std::string &name, const std::string &bytes) const {
    std::ofstream(m_folder + name, std::ios::binary) << bytes;
  }
  void writePicture(const std::string &name, int side, std::uint8_t low, std::uint8_t high) const {
    Picture picture{side, side, std::vector<std::uint8_t>(std::size_t(4 * side * side), high)};
    std::fill_n(picture.bytes.begin(), 4 * side, low); // the lowest row
    ASSERT_EQ(writePng(m_folder + name, picture), "");
  }
  Result<std::vector<Image>, TextureError> make(const std::string &words) const {
    const Panel panel = parsePanel("#@ texture 0 = " + words + "\n");
    EXPECT_TRUE(panel.diagnostics.empty()) << words;
    return generate(panel.textures.at(0).source, m_folder, 8, 8);
  }

  std::string m_folder;
};

TEST_F(ImageFiles, AreToldApartByTheirBytes) {
  write("a.png", jpegOf(16, 16, false));
  const auto jpeg = make("a.png");
  ASSERT_TRUE(jpeg) << jpeg.error().message;
  EXPECT_GT(texel(jpeg.value()[0], 0, 0)[2], 240) << "the lowest row first";
  write("b.dds", plain(header(1, 2)) + "\1\1\1\1\2\2\2\2");
  EXPECT_EQ(texel(make("b.dds").value()[0], 0, 0)[0], 2);
  write("c.dds", "no image");
  EXPECT_THAT(make("c.dds").error().message, HasSubstr(m_folder + "c.dds: "));
  EXPECT_EQ(make("normals strength 2 of b.dds").value()[0].width, 1);
}

/// Faces of cube maps are stored as seen from inside: the top row is t = 0.
TEST_F(ImageFiles, ACubeOfSixFilesOrOfOne) {
  for (int face = 0; face < 6; ++face)
    writePicture(std::to_string(face) + ".png", 2, 7, std::uint8_t(10 * face + 9));
  const auto faces = make("cube \"0.png\" \"1.png\" \"2.png\" \"3.png\" \"4.png\" \"5.png\"");
  ASSERT_TRUE(faces) << faces.error().message;
  ASSERT_EQ(faces.value().size(), 6u);
  EXPECT_EQ(texel(faces.value()[3], 0, 0)[0], 39);
  EXPECT_EQ(texel(faces.value()[3], 0, 1)[0], 7);
  std::string texels;
  for (int face = 0; face < 6; ++face)
    texels += std::string(4, char(face));
  write("sky.dds", cubeOf(texels));
  EXPECT_EQ(texel(make("cube sky.dds").value()[5], 0, 0)[0], 5);
  EXPECT_THAT(make("sky.dds").error().message, HasSubstr("'cube sky.dds' is one"));
  write("flat.dds", plain(header(1, 1)) + "\1\1\1\1");
  EXPECT_THAT(make("cube flat.dds").error().message, HasSubstr("no faces of a cube map"));
  writePicture("5.png", 3, 0, 0);
  EXPECT_THAT(
      make("cube \"0.png\" \"1.png\" \"2.png\" \"3.png\" \"4.png\" \"5.png\"").error().message,
      HasSubstr("5.png: the faces of a cube are squares of one size"));
}

} // namespace
} // namespace arbiter::scene
