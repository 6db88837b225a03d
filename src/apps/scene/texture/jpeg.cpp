#include <csetjmp>
#include <cstddef>
#include <cstdio>
// This include must follow cstdio.
#include <jpeglib.h>

#include <jerror.h>

#include "apps/scene/picture.h"
#include "apps/scene/texture/read_image.h"

namespace arbiter::scene {

namespace {

/// A progressive file may have a scan in a few bytes, each as costly as the whole picture.
constexpr int kMaxScans = 100;

/// The error handler. The library's own struct comes first, as the library passes a pointer to it.
struct Failure {
  jpeg_error_mgr base;
  std::jmp_buf jump;
  char text[JMSG_LENGTH_MAX];
};

Failure &failureOf(j_common_ptr info) { return *reinterpret_cast<Failure *>(info->err); }

[[noreturn]] void leave(j_common_ptr info) {
  info->err->format_message(info, failureOf(info).text);
  std::longjmp(failureOf(info).jump, 1);
}

/// Handles a message. Warnings (level -1) that leave the picture intact are ignored.
void warn(j_common_ptr info, int level) {
  const int code = info->err->msg_code;
  if (level < 0 && code != JWRN_EXTRANEOUS_DATA && code != JWRN_ADOBE_XFORM &&
      code != JWRN_JFIF_MAJOR)
    leave(info);
}

void countScans(j_common_ptr info) {
  if (reinterpret_cast<j_decompress_ptr>(info)->input_scan_number <= kMaxScans)
    return;
  Failure &failure = failureOf(info);
  std::snprintf(failure.text, sizeof failure.text, "more than %d scans", kMaxScans);
  std::longjmp(failure.jump, 1);
}

/// Decodes a file. No object with a destructor may be made between run() and the library's calls,
/// as errors use longjmp.
class Decoder {
public:
  Decoder() {
    m_info.err = jpeg_std_error(&m_failure.base);
    m_failure.base.error_exit = leave;
    m_failure.base.emit_message = warn;
    m_progress.progress_monitor = countScans;
  }
  Decoder(const Decoder &) = delete;
  Decoder &operator=(const Decoder &) = delete;
  ~Decoder() { jpeg_destroy_decompress(&m_info); }

  bool run(std::string_view bytes) {
    if (setjmp(m_failure.jump) != 0)
      return false;
    jpeg_create_decompress(&m_info);
    m_info.progress = &m_progress;
    jpeg_mem_src(&m_info, reinterpret_cast<const unsigned char *>(bytes.data()),
                 static_cast<unsigned long>(bytes.size()));
    jpeg_read_header(&m_info, TRUE);
    if (m_info.image_width > kMaxSide || m_info.image_height > kMaxSide) {
      std::snprintf(m_failure.text, sizeof m_failure.text, "more than 8192 pixels a side");
      return false;
    }
    m_info.out_color_space = JCS_EXT_RGBA;
    jpeg_start_decompress(&m_info);
    readRows();
    jpeg_finish_decompress(&m_info);
    return true;
  }

  [[nodiscard]] const char *reason() const { return m_failure.text; }
  [[nodiscard]] Picture &picture() { return m_picture; }

private:
  void readRows() {
    m_picture.width = int(m_info.output_width);
    m_picture.height = int(m_info.output_height);
    const std::size_t stride = std::size_t(4) * m_info.output_width;
    m_picture.bytes.resize(stride * m_info.output_height);
    while (m_info.output_scanline < m_info.output_height) {
      JSAMPROW row = &m_picture.bytes[stride * m_info.output_scanline];
      jpeg_read_scanlines(&m_info, &row, 1);
    }
  }

  jpeg_decompress_struct m_info = {};
  jpeg_progress_mgr m_progress = {};
  Failure m_failure = {};
  Picture m_picture;
};

} // namespace

Result<Picture, PictureError> decodeJpeg(std::string_view bytes) {
  Decoder decoder;
  if (decoder.run(bytes))
    return std::move(decoder.picture());
  return PictureError{std::string("this JPEG cannot be read: ") + decoder.reason()};
}

} // namespace arbiter::scene
