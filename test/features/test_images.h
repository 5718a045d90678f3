#pragma once

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "rovio_sfm/geometry/camera.h"

namespace rovio_sfm {

// A grey-brown image with soft random structure at several scales; the same for the same seed.
inline cv::Mat TexturedImage(int width, int height, uint64_t seed) {
  cv::RNG rng(seed);
  cv::Mat sum(height, width, CV_32FC3, cv::Scalar::all(0));
  for (int cell = 3; cell <= 96; cell *= 2) {
    cv::Mat noise(height / cell + 2, width / cell + 2, CV_32FC3), scaled;
    rng.fill(noise, cv::RNG::NORMAL, 0.0, 18.0);
    cv::resize(noise, scaled, sum.size(), 0, 0, cv::INTER_CUBIC);
    sum += scaled;
  }
  cv::Mat image;
  sum.convertTo(image, CV_8UC3, 1.0, 128.0);
  return image;
}

inline Camera TestCamera(int width, int height) {
  Camera camera;
  camera.fx = camera.fy = 0.8 * width;
  camera.cx = 0.5 * width;
  camera.cy = 0.5 * height;
  camera.width = width;
  camera.height = height;
  return camera;
}

inline cv::Mat TexturedGrey(int width, int height, uint64_t seed) {
  cv::Mat grey;
  cv::cvtColor(TexturedImage(width, height, seed), grey, cv::COLOR_BGR2GRAY);
  return grey;
}

}  // namespace rovio_sfm
