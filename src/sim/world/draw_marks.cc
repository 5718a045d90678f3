#include "rovio_sfm/sim/world/draw_marks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <opencv2/imgproc.hpp>

#include "rovio_sfm/sim/world/draw_prints.h"
#include "rovio_sfm/util/check.h"

namespace rovio_sfm::sim {
namespace {

// How many marks of about this area fit, times the density.
int Count(const TextureSpec& spec, double mark_area_px) {
  const double area = static_cast<double>(spec.width_px) * spec.height_px;
  return static_cast<int>(spec.density * area / mark_area_px);
}

cv::Point RandomPoint(const cv::Mat& image, Rng& rng) {
  const int x = static_cast<int>(rng.UniformInt(static_cast<uint32_t>(image.cols)));
  return {x, static_cast<int>(rng.UniformInt(static_cast<uint32_t>(image.rows)))};
}

int Between(Rng& rng, int low, int high) {
  return low + static_cast<int>(rng.UniformInt(static_cast<uint32_t>(high - low + 1)));
}

cv::Scalar Shade(const cv::Vec3b& color, double gain) {
  return {color[0] * gain, color[1] * gain, color[2] * gain};
}

void DrawShapes(const TextureSpec& spec, Rng& rng, cv::Mat* image) {
  for (int i = Count(spec, 6000.0); i > 0; --i) {
    const cv::Point center = RandomPoint(*image, rng);
    const int radius = Between(rng, 6, 50);
    const cv::Scalar color = RandomColor(rng);
    const int thickness = rng.Uniform() < 0.5 ? cv::FILLED : Between(rng, 2, 5);
    std::vector<cv::Point> corners;
    const int sides = Between(rng, 3, 9);
    const double turn = rng.Uniform(0.0, 2.0 * M_PI);
    for (int k = 0; k < sides; ++k) {
      const double angle = turn + 2.0 * M_PI * k / sides;
      const double reach = radius * rng.Uniform(0.6, 1.0);
      corners.emplace_back(center.x + cvRound(reach * std::cos(angle)),
                           center.y + cvRound(reach * std::sin(angle)));
    }
    if (thickness == cv::FILLED) {
      cv::fillPoly(*image, corners, color, cv::LINE_AA);
    } else {
      cv::polylines(*image, corners, true, color, thickness, cv::LINE_AA);
    }
  }
}

void DrawChips(const TextureSpec& spec, Rng& rng, cv::Mat* image) {
  for (int i = Count(spec, 220.0); i > 0; --i) {
    // Sizes follow a power law, as pebbles do.
    const double size = std::min(2.0 / std::sqrt(1.0 - 0.99 * rng.Uniform()), 16.0);
    const cv::Size axes(std::max(1, cvRound(size)), std::max(1, cvRound(size * 0.6)));
    const double gain = rng.Uniform(0.45, 1.5);
    const cv::Point center = RandomPoint(*image, rng);
    cv::ellipse(*image, center, axes, rng.Uniform(0.0, 180.0), 0, 360, Shade(spec.accent, gain),
                cv::FILLED, cv::LINE_AA);
  }
}

void DrawScratches(const TextureSpec& spec, Rng& rng, cv::Mat* image) {
  for (int i = Count(spec, 5000.0); i > 0; --i) {
    cv::Point from = RandomPoint(*image, rng);
    double angle = rng.Uniform(0.0, M_PI);
    const cv::Scalar color = Shade(spec.accent, rng.Uniform(0.4, 1.6));
    const int thickness = rng.Uniform() < 0.8 ? 1 : 2;
    for (int k = Between(rng, 1, 6); k > 0; --k) {
      const double length = rng.Uniform(8.0, 40.0);
      const cv::Point to(from.x + cvRound(length * std::cos(angle)),
                         from.y + cvRound(length * std::sin(angle)));
      cv::line(*image, from, to, color, thickness, cv::LINE_AA);
      from = to;
      angle += rng.Uniform(-0.7, 0.7);
    }
  }
}

void DrawDials(const TextureSpec& spec, Rng& rng, cv::Mat* image) {
  for (int i = Count(spec, 9000.0); i > 0; --i) {
    const cv::Point center = RandomPoint(*image, rng);
    const int radius = Between(rng, 7, 30);
    cv::circle(*image, center, radius, RandomColor(rng), cv::FILLED, cv::LINE_AA);
    cv::circle(*image, center, radius, Shade(spec.accent, 0.4), 2, cv::LINE_AA);
    const double needle = rng.Uniform(0.0, 2.0 * M_PI);
    for (int k = 0; k < 10; ++k) {
      const double angle = needle + 0.55 * k;
      const double inner = k == 0 ? 0.0 : 0.75 * radius;
      const cv::Point2d direction(std::cos(angle), std::sin(angle));
      const cv::Point2d middle(center);
      cv::line(*image, middle + inner * direction, middle + 0.95 * radius * direction,
               k == 0 ? cv::Scalar(200, 30, 20) : cv::Scalar(20, 20, 25), k == 0 ? 2 : 1,
               cv::LINE_AA);
    }
  }
}

void DrawCircuit(const TextureSpec& spec, Rng& rng, cv::Mat* image) {
  for (int i = Count(spec, 2600.0); i > 0; --i) {
    cv::Point from = RandomPoint(*image, rng);
    const cv::Scalar color = RandomColor(rng);
    for (int k = Between(rng, 2, 5); k > 0; --k) {
      const int length = Between(rng, -60, 60);
      const cv::Point to = from + (k % 2 == 0 ? cv::Point(length, 0) : cv::Point(0, length));
      cv::line(*image, from, to, color, Between(rng, 1, 3), cv::LINE_AA);
      from = to;
    }
    cv::circle(*image, from, Between(rng, 2, 5), color, cv::FILLED, cv::LINE_AA);
  }
}

void DrawHoles(const TextureSpec& spec, Rng&, cv::Mat* image) {
  const int period = cvRound(spec.period_px);
  for (int y = period / 2; y < image->rows; y += period) {
    for (int x = period / 2; x < image->cols; x += period) {
      cv::circle(*image, {x, y}, std::max(1, period / 4), Shade(spec.accent, 0.4), cv::FILLED,
                 cv::LINE_AA);
    }
  }
}

void DrawTiles(const TextureSpec& spec, Rng&, cv::Mat* image) {
  const int period = cvRound(spec.period_px);
  const int joint = std::max(1, period / 40);
  for (int y = 0; y < image->rows; y += period) {
    cv::line(*image, {0, y}, {image->cols, y}, Shade(spec.accent, 0.6), joint, cv::LINE_AA);
  }
  for (int x = 0; x < image->cols; x += period) {
    cv::line(*image, {x, 0}, {x, image->rows}, Shade(spec.accent, 0.6), joint, cv::LINE_AA);
  }
}

// Courses of bricks, each of its own shade.
void DrawBricks(const TextureSpec& spec, Rng& rng, cv::Mat* image) {
  const int width = cvRound(spec.period_px), height = std::max(2, width / 3);
  for (int y = 0, course = 0; y < image->rows; y += height, ++course) {
    for (int x = course % 2 == 0 ? 0 : -width / 2; x < image->cols; x += width) {
      const cv::Rect brick = cv::Rect(x, y, width, height) & cv::Rect({}, image->size());
      if (brick.empty()) continue;
      cv::Mat area = (*image)(brick);
      area *= rng.Uniform(0.9, 1.1);
      cv::rectangle(*image, brick, Shade(spec.accent, 1.08), std::max(1, width / 25), cv::LINE_AA);
    }
  }
}

using Drawer = void (*)(const TextureSpec&, Rng&, cv::Mat*);

const std::map<std::string, Drawer>& Drawers() {
  static const std::map<std::string, Drawer> drawers = {
      {"text", DrawText},           {"posters", DrawPosters}, {"shapes", DrawShapes},
      {"labels", DrawLabels},       {"dials", DrawDials},     {"books", DrawBooks},
      {"scratches", DrawScratches}, {"holes", DrawHoles},     {"tiles", DrawTiles},
      {"bricks", DrawBricks},       {"chips", DrawChips},     {"circuit", DrawCircuit}};
  return drawers;
}

}  // namespace

void DrawMarks(const std::string& mark, const TextureSpec& spec, Rng& rng, cv::Mat* image) {
  const auto drawer = Drawers().find(mark);
  ROVIO_CHECK(drawer != Drawers().end());
  drawer->second(spec, rng, image);
}

}  // namespace rovio_sfm::sim
