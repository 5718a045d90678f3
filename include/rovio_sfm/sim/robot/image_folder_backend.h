#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "rovio_sfm/sim/robot/robot_backend.h"

namespace rovio_sfm::sim {

// A robot that stands still and sees the pictures of a folder, one a capture, in the order of their
// names, as they are on disk (their size, not the asked one). After the last one no more come, or
// the first again.
class ImageFolderBackend : public RobotBackend {
 public:
  // The folder, or its sub-folder images/ if there is one. Null, with the reason, without JPEGs.
  static std::unique_ptr<ImageFolderBackend> Open(const std::string& folder, bool repeats,
                                                  std::string* error);

  size_t num_images() const { return paths_.size(); }

  void AdvanceTo(int64_t time_ns) override;
  NavResponse Drive(const DriveCommand& command) override;
  void Stop() override {}
  void MoveHead(HeadPosition target) override;
  void SwitchHeadlight(bool on) override;
  void SwitchInfrared(bool on) override;
  McuReading ReadMcu() override { return reading_; }
  McuReading PeekMcu() const override { return reading_; }
  NavReading ReadNav() const override { return {}; }
  TruePose ReadTruth() const override;
  std::optional<CapturedImage> Capture(int64_t time_ns, const CameraSettings& settings) override;

 private:
  ImageFolderBackend(std::vector<std::string> paths, bool repeats);

  const std::vector<std::string> paths_;
  const bool repeats_;
  McuReading reading_;
  int64_t time_ns_ = 0;
  size_t next_ = 0;  // of the capture thread alone
};

}  // namespace rovio_sfm::sim
