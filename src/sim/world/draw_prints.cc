#include "rovio_sfm/sim/world/draw_prints.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace rovio_sfm::sim {
namespace {

int Between(Rng& rng, int low, int high) {
  return low + static_cast<int>(rng.UniformInt(static_cast<uint32_t>(high - low + 1)));
}

std::string RandomWord(Rng& rng, int min_length, int max_length) {
  static const std::string kLetters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789abcdefghkmnprstuvwxyz";
  std::string word;
  for (int i = Between(rng, min_length, max_length); i > 0; --i) {
    word += kLetters[rng.UniformInt(static_cast<uint32_t>(kLetters.size()))];
  }
  return word;
}

void PutWord(const std::string& word, cv::Point at, double height_px, const cv::Scalar& color,
             Rng& rng, cv::Mat* image) {
  static const int kFonts[] = {cv::FONT_HERSHEY_SIMPLEX, cv::FONT_HERSHEY_DUPLEX,
                               cv::FONT_HERSHEY_COMPLEX, cv::FONT_HERSHEY_TRIPLEX};
  const int thickness = std::max(1, cvRound(height_px / 9.0));
  cv::putText(*image, word, at, kFonts[rng.UniformInt(4)], height_px / 21.0, color, thickness,
              cv::LINE_AA);
}

// Lines of words that fill a rectangle from its top.
void FillWithText(const cv::Rect& area, double height_px, const cv::Scalar& color, Rng& rng,
                  cv::Mat* image) {
  cv::Mat block = (*image)(area & cv::Rect({}, image->size()));
  const int step = std::max(5, cvRound(1.5 * height_px));
  for (int y = step; y < block.rows - 2; y += step) {
    for (int x = 4; x < block.cols - 2 * step;) {
      const std::string word = RandomWord(rng, 2, 8);
      PutWord(word, {x, y}, height_px, color, rng, &block);
      x += cvRound((static_cast<double>(word.size()) + 1.0) * 0.9 * height_px);
    }
  }
}

cv::Rect RandomRect(const cv::Mat& image, int min_px, int max_px, Rng& rng) {
  const int width = std::min(Between(rng, min_px, max_px), image.cols);
  const int height = std::min(Between(rng, min_px, max_px), image.rows);
  return {Between(rng, 0, image.cols - width), Between(rng, 0, image.rows - height), width, height};
}

int Count(const TextureSpec& spec, double mark_area_px) {
  const double area = static_cast<double>(spec.width_px) * spec.height_px;
  return static_cast<int>(std::ceil(spec.density * area / mark_area_px));
}

// A picture: blobs and bars within a frame of its own.
void DrawPicture(const cv::Rect& frame, Rng& rng, cv::Mat* image) {
  cv::Mat block = (*image)(frame & cv::Rect({}, image->size()));
  block.setTo(RandomColor(rng));
  for (int i = Between(rng, 3, 9); i > 0; --i) {
    const cv::Rect part = RandomRect(block, 4, std::max(5, block.cols / 2), rng);
    const cv::Scalar color = RandomColor(rng);
    if (rng.Uniform() < 0.5) {
      cv::rectangle(block, part, color, cv::FILLED);
    } else {
      const cv::Point middle(part.x + part.width / 2, part.y + part.height / 2);
      const cv::Size axes(part.width / 2, part.height / 2);
      cv::ellipse(block, middle, axes, rng.Uniform(0.0, 180.0), 0, 360, color, cv::FILLED,
                  cv::LINE_AA);
    }
  }
}

}  // namespace

cv::Scalar RandomColor(Rng& rng) {
  const double level = rng.Uniform(20.0, 230.0);
  const double spread = rng.Uniform(0.0, 90.0);
  return {level + rng.Uniform(-spread, spread), level + rng.Uniform(-spread, spread),
          level + rng.Uniform(-spread, spread)};
}

void DrawText(const TextureSpec& spec, Rng& rng, cv::Mat* image) {
  for (int i = Count(spec, 40000.0); i > 0; --i) {
    const cv::Rect area = RandomRect(*image, 60, 240, rng);
    const cv::Scalar color(spec.accent[0] * 0.5, spec.accent[1] * 0.5, spec.accent[2] * 0.5);
    FillWithText(area, rng.Uniform(6.0, 18.0), color, rng, image);
  }
}

void DrawPosters(const TextureSpec& spec, Rng& rng, cv::Mat* image) {
  for (int i = Count(spec, 45000.0); i > 0; --i) {
    const cv::Rect paper = RandomRect(*image, 120, 340, rng);
    cv::rectangle(*image, paper, RandomColor(rng), cv::FILLED);
    const cv::Rect title(paper.x + 6, paper.y + 4, paper.width - 12, paper.height / 5);
    FillWithText(title, rng.Uniform(14.0, 26.0), RandomColor(rng), rng, image);
    const cv::Rect picture(paper.x + 8, paper.y + paper.height / 5 + 6, paper.width - 16,
                           paper.height / 3);
    DrawPicture(picture, rng, image);
    const int text_y = picture.y + picture.height + 4;
    const cv::Rect text(paper.x + 6, text_y, paper.width - 12, paper.y + paper.height - text_y - 4);
    if (text.height > 8) {
      FillWithText(text, rng.Uniform(6.0, 11.0), RandomColor(rng), rng, image);
    }
  }
}

void DrawLabels(const TextureSpec& spec, Rng& rng, cv::Mat* image) {
  for (int i = Count(spec, 30000.0); i > 0; --i) {
    const cv::Rect label = RandomRect(*image, 24, 90, rng);
    const double level = rng.Uniform(170.0, 250.0);
    cv::rectangle(*image, label, cv::Scalar(level, level, level - 15.0), cv::FILLED);
    FillWithText(label, rng.Uniform(6.0, 13.0), cv::Scalar(25, 25, 40), rng, image);
    for (int x = label.x + 3; x < label.x + label.width - 3; x += Between(rng, 2, 6)) {
      cv::line(*image, {x, label.y + label.height - 9}, {x, label.y + label.height - 3},
               cv::Scalar(20, 20, 20), Between(rng, 1, 2));
    }
  }
}

void DrawBooks(const TextureSpec& spec, Rng& rng, cv::Mat* image) {
  const int shelf_px = std::max(40, cvRound(spec.period_px));
  for (int y = 0; y < image->rows; y += shelf_px) {
    for (int x = 0; x < image->cols;) {
      const int width = Between(rng, 7, 26);
      const int height = Between(rng, shelf_px * 6 / 10, shelf_px * 9 / 10);
      const cv::Rect spine =
          cv::Rect(x, y + shelf_px - height, width, height - 4) & cv::Rect({}, image->size());
      x += width + (rng.Uniform() < 0.08 ? Between(rng, 5, 30) : 0);
      if (spine.width < 3 || spine.height < 10) continue;
      cv::rectangle(*image, spine, RandomColor(rng), cv::FILLED);
      cv::Mat title = cv::Mat(spine.width, spine.height, CV_8UC3, RandomColor(rng));
      cv::Mat area = (*image)(spine);
      cv::transpose(area, title);
      PutWord(RandomWord(rng, 4, 12), {Between(rng, 2, 12), spine.width - 3},
              std::max(5.0, 0.55 * spine.width), RandomColor(rng), rng, &title);
      cv::transpose(title, area);
      cv::rectangle(*image, spine, cv::Scalar(25, 22, 20), 1);
    }
  }
}

}  // namespace rovio_sfm::sim
