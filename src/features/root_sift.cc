#include "rovio_sfm/features/root_sift.h"

#include <algorithm>
#include <cmath>

#include "rovio_sfm/util/check.h"

namespace rovio_sfm {

Descriptors RootSiftFromSift(const cv::Mat& sift) {
  ROVIO_CHECK(sift.empty() || sift.type() == CV_32F);
  Descriptors descriptors;
  descriptors.type = DescriptorType::kSift;
  descriptors.metric = DescriptorMetric::kL2;
  descriptors.length = 128;
  descriptors.data.reserve(sift.total());
  for (int row = 0; row < sift.rows; ++row) {
    const float* values = sift.ptr<float>(row);
    float sum = 0.0f;
    for (int i = 0; i < sift.cols; ++i) sum += values[i];
    const float scale = sum > 0.0f ? 1.0f / sum : 0.0f;
    for (int i = 0; i < sift.cols; ++i) {
      const float root = 512.0f * std::sqrt(std::max(0.0f, values[i] * scale));
      descriptors.data.push_back(static_cast<uint8_t>(std::min(255.0f, std::round(root))));
    }
  }
  return descriptors;
}

}  // namespace rovio_sfm
