#pragma once

#include <jpeglib.h>

#include <cstdio>  // jpeglib.h needs it before
#include <cstdlib>
#include <string>
#include <vector>

namespace rovio_sfm {

// A whole grey JPEG of this size; `pattern` chooses what it shows.
inline std::string JpegSample(int width_px, int height_px, char pattern = 'x') {
  jpeg_compress_struct codec;
  jpeg_error_mgr errors;
  codec.err = jpeg_std_error(&errors);
  jpeg_create_compress(&codec);
  unsigned char* data = nullptr;
  unsigned long size = 0;  // NOLINT: libjpeg's type
  jpeg_mem_dest(&codec, &data, &size);
  codec.image_width = static_cast<JDIMENSION>(width_px);
  codec.image_height = static_cast<JDIMENSION>(height_px);
  codec.input_components = 1;
  codec.in_color_space = JCS_GRAYSCALE;
  jpeg_set_defaults(&codec);
  jpeg_start_compress(&codec, TRUE);
  std::vector<JSAMPLE> row(static_cast<size_t>(width_px));
  for (int y = 0; y < height_px; ++y) {
    for (int x = 0; x < width_px; ++x) {
      row[static_cast<size_t>(x)] = static_cast<JSAMPLE>((x * pattern / 16 + y * 5) % 256);
    }
    JSAMPROW rows[1] = {row.data()};
    jpeg_write_scanlines(&codec, rows, 1);
  }
  jpeg_finish_compress(&codec);
  jpeg_destroy_compress(&codec);
  std::string bytes(reinterpret_cast<const char*>(data), size);
  std::free(data);  // NOLINT: libjpeg allocated it
  return bytes;
}

// The same bytes with another size in the frame header.
inline std::string WithJpegSize(std::string jpeg, int width_px, int height_px) {
  size_t at = jpeg.find("\xFF\xC0") + 5;
  for (const int value : {height_px, width_px}) {
    jpeg[at++] = static_cast<char>(value / 256);
    jpeg[at++] = static_cast<char>(value % 256);
  }
  return jpeg;
}

}  // namespace rovio_sfm
