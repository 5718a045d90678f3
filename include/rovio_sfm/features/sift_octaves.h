#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace rovio_sfm {

constexpr int kSiftLayers = 3;      // scales at which an octave finds features
constexpr double kSiftSigma = 1.6;  // blur of an octave's first image, its pixels
constexpr int kSiftBorder = 5;      // pixels of an octave at each edge without features

// The picture at half the size of the octave before, blurred more and more: image i by
// kSiftSigma 2^(i / kSiftLayers) of its pixels, kSiftLayers + 3 of them (CV_32F, grey levels).
struct SiftOctave {
  std::vector<cv::Mat> images;
  float pixel_px = 1.0f;   // its pixel, in those of the picture
  float origin_px = 0.0f;  // of its pixel (0, 0) in the picture, in both axes
};

// Lowe's scale space of a picture (CV_8U), of the doubled picture first where `upsample`.
std::vector<SiftOctave> BuildSiftOctaves(const cv::Mat& grey, bool upsample);

}  // namespace rovio_sfm
