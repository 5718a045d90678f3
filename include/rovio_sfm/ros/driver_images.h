#pragma once

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <thread>

#include "rovio_sfm/ros/driver_image_publisher.h"
#include "rovio_sfm/rovio/image_statistics.h"
#include "rovio_sfm/util/mutex.h"
#include "rovio_sfm/util/worker.h"

namespace rovio_sfm {

// What the images' side has to say in diagnostics.
struct ImagesState {
  ImageLink link = ImageLink::kConnecting;
  std::string reason;
  ImageFigures figures;  // since the last call of TakeState
  uint64_t num_published = 0;
  uint64_t num_dropped = 0;       // nobody had time to publish them
  uint64_t num_without_time = 0;  // no /clock
  bool is_calibrated = true;      // the newest
};

// The images of one robot: a reader on its own thread, a choice of images in stationary mode, and a
// worker that publishes. The destructor ends both threads.
class DriverImages {
 public:
  DriverImages(const ros::NodeHandle& handle, const DriverOptions& options,
               const Credentials& credentials);
  ~DriverImages();

  // Tells the stationary mode whether the robot moves, at this steady time. Any thread.
  void NoteMotion(bool is_moving, int64_t now_ns) EXCLUDES(mutex_);

  // The robot answers, or is away: it may come back with other settings. Any thread, steady time.
  void NoteLink(bool is_up, int64_t now_ns) EXCLUDES(mutex_);
  // The camera has these settings; until they are known no image of another size is taken. Any
  // thread.
  void NoteSettings(const SomeSettings& settings) EXCLUDES(mutex_);
  // Call now and then: a robot that says nothing of its settings is taken as it is after a while.
  void CheckSettings(int64_t now_ns) EXCLUDES(mutex_);

  ImagesState TakeState() EXCLUDES(mutex_);
  const ImageCounters& Counters() const { return reader_.Counters(); }
  uint64_t NumPublished() const { return publisher_.NumPublished(); }
  uint64_t NumDropped() const;
  ImageLink Link() const EXCLUDES(mutex_);

 private:
  ImageReader::Callbacks MakeCallbacks();
  void OnImage(CameraImage image) EXCLUDES(mutex_);
  void OnLink(ImageLink link, const std::string& reason) EXCLUDES(mutex_);
  void BeginReading() REQUIRES(mutex_);
  bool IsOfOldSize(const CameraImage& image) const REQUIRES(mutex_);

  const bool is_stationary_;
  const bool keeps_settings_;  // asks for some, and asks again when the robot was away
  const int64_t start_ns_;     // steady, as the times below
  mutable Mutex mutex_;
  size_t resolution_ GUARDED_BY(mutex_);  // wished for, or what the robot has instead
  bool may_read_ GUARDED_BY(mutex_);      // settings came once, or were waited for
  bool has_settings_ GUARDED_BY(mutex_);  // they came since the robot did, or never will
  std::optional<int64_t> settings_ns_ GUARDED_BY(mutex_);  // when NoteSettings came
  std::optional<int64_t> heard_ns_ GUARDED_BY(mutex_);     // when the robot came, if it is there
  StationaryTrigger trigger_ GUARDED_BY(mutex_);
  ImageStatistics statistics_ GUARDED_BY(mutex_);
  ImageLink link_ GUARDED_BY(mutex_) = ImageLink::kConnecting;
  std::string reason_ GUARDED_BY(mutex_) = "no image yet";
  std::atomic<uint64_t> num_of_old_size_{0};  // images that were not taken
  CurlTransport transport_;
  ReaderGate gate_;
  DriverImagePublisher publisher_;
  // One image waits; an older one is dropped: a slow subscriber gets the newest.
  Worker<CameraImage> publish_worker_;
  ImageReader reader_;
  std::thread reader_thread_;  // last: starts when all others exist
};

}  // namespace rovio_sfm
