#pragma once

#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "rovio_sfm/sim/robot/robot_backend.h"

namespace rovio_sfm::sim {

// A robot of the tests: shows what it is told to, and writes down what it is asked to do. Its
// pictures are numbered texts between the marks of a JPEG.
class FakeRobot : public RobotBackend {
 public:
  NavReading nav;
  McuReading mcu;
  NavResponse drive_response = NavResponse::kSuccess;
  bool has_pictures = true;
  std::vector<int64_t> times_ns;  // of AdvanceTo

  std::string TakeLog() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return std::exchange(log_, "");
  }

  static std::string PictureText(int number) {
    return "\xFF\xD8 picture " + std::to_string(number) + " \xFF\xD9";
  }

  void AdvanceTo(int64_t time_ns) override { times_ns.push_back(time_ns); }
  NavResponse Drive(const DriveCommand& command) override {
    std::string text =
        "drive " + std::to_string(command.drive) + " speed " + std::to_string(command.speed);
    if (command.angle_steps) text += " steps " + std::to_string(*command.angle_steps);
    if (command.hold_ns == kHoldForever) text += " for ever";
    Log(text);
    return drive_response;
  }
  void Stop() override { Log("stop"); }
  void MoveHead(HeadPosition target) override {
    Log(target == HeadPosition::kUp     ? "head up"
        : target == HeadPosition::kDown ? "head down"
                                        : "head middle");
  }
  void SwitchHeadlight(bool on) override { Log(on ? "light on" : "light off"); }
  void SwitchInfrared(bool on) override { Log(on ? "IR on" : "IR off"); }
  McuReading ReadMcu() override {
    Log("read");
    McuReading reading = mcu;
    mcu.left = mcu.right = mcu.rear = {};
    return reading;
  }
  McuReading PeekMcu() const override { return mcu; }
  NavReading ReadNav() const override { return nav; }
  void AbortAutonomy() override { Log("abort"); }
  TruePose ReadTruth() const override {
    TruePose truth;
    truth.time_ns = 7;
    truth.world_from_base.translation = {1.5, -2.0, 0.0};
    return truth;
  }
  std::optional<CapturedImage> Capture(int64_t time_ns, const CameraSettings&) override {
    if (!has_pictures) return std::nullopt;
    const std::string text = PictureText(++num_pictures_);
    return CapturedImage{time_ns, {text.begin(), text.end()}};
  }

 private:
  void Log(const std::string& text) {
    const std::lock_guard<std::mutex> lock(mutex_);
    log_ += log_.empty() ? text : ", " + text;
  }

  std::mutex mutex_;
  std::string log_;  // guarded by mutex_
  int num_pictures_ = 0;
};

}  // namespace rovio_sfm::sim
