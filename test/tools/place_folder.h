#pragma once

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>

namespace rovio_sfm {

// Writes a data-set folder: `count` views of a textured wall of its own (by the seed), each moved
// sideways by 12 px and 0.1 m, neighbours named as overlaps. 320 x 240 px.
inline void WritePlaceFolder(const std::filesystem::path& folder, int count, int seed) {
  std::filesystem::create_directories(folder / "images");
  cv::RNG rng(static_cast<uint64_t>(seed));
  cv::Mat small(60, 160, CV_8UC3), wall;
  rng.fill(small, cv::RNG::UNIFORM, 0, 255);
  cv::resize(small, wall, cv::Size(960, 360), 0, 0, cv::INTER_CUBIC);
  std::ofstream times(folder / "times.txt"), poses(folder / "groundtruth.txt");
  std::ofstream overlaps(folder / "overlaps.txt");
  for (int i = 0; i < count; ++i) {
    char name[32];
    std::snprintf(name, sizeof(name), "images/%06d.png", i);
    cv::imwrite((folder / name).string(), wall(cv::Rect(100 + 12 * i, 60, 320, 240)));
    times << 1 + i << ".0 " << name << "\n";
    poses << 1 + i << ".0 " << 0.1 * i << " 0 0 0 0 0 1\n";
    for (int j = 0; j < i; ++j) overlaps << j << " " << i << " " << 1.0 - 0.1 * (i - j) << " 0\n";
  }
  std::ofstream(folder / "calibration.txt") << "300 300 160 120 0 0 0 0 0 320 240\n";
}

}  // namespace rovio_sfm
