#pragma once

#include <memory>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "rovio_sfm/scene/events.h"

namespace rovio_sfm {

// Images of a camera that moves sideways past two textured walls, one nearer (the lower half), and
// perhaps turns; the same for the same arguments. 320 x 240 px, focal length 256 px.
class MovingImages {
 public:
  MovingImages() {
    cv::RNG rng(11);
    for (cv::Mat* wall : {&far_, &near_}) {
      wall->create(400, 1600, CV_32FC3);
      wall->setTo(cv::Scalar::all(128));
      for (int cell = 3; cell <= 48; cell *= 2) {
        cv::Mat noise(400 / cell + 2, 1600 / cell + 2, CV_32FC3), scaled;
        rng.fill(noise, cv::RNG::NORMAL, 0.0, 18.0);
        cv::resize(noise, scaled, wall->size(), 0, 0, cv::INTER_CUBIC);
        *wall += scaled;
      }
      wall->convertTo(*wall, CV_8UC3);
    }
  }

  static Camera TheCamera() {
    Camera camera;
    camera.fx = camera.fy = 256.0;
    camera.cx = 160.0;
    camera.cy = 120.0;
    camera.width = 320;
    camera.height = 240;
    return camera;
  }

  // The image after the far wall has moved by shift_px and the near one by twice that.
  cv::Mat At(double shift_px) const {
    cv::Mat image = Shifted(far_, shift_px);
    Shifted(near_, 2.0 * shift_px).rowRange(120, 240).copyTo(image.rowRange(120, 240));
    return image;
  }

  static ImageEvent Event(const cv::Mat& image, int index) {
    std::vector<uint8_t> bytes;
    cv::imencode(".png", image, bytes);
    ImageEvent event;
    event.stamp_ns = 1'000'000'000 + 33'000'000LL * index;
    event.name = std::to_string(index);
    event.encoded = std::make_shared<const std::vector<uint8_t>>(std::move(bytes));
    event.camera = TheCamera();
    return event;
  }

 private:
  static cv::Mat Shifted(const cv::Mat& wall, double shift_px) {
    cv::Mat image;
    cv::warpAffine(wall, image, cv::Matx23d(1, 0, -200 - shift_px, 0, 1, -80), cv::Size(320, 240),
                   cv::INTER_CUBIC);
    return image;
  }

  cv::Mat far_, near_;
};

}  // namespace rovio_sfm
