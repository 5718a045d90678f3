// Bytes taken for a message on the wire: the first says of which kind.
#include <ros/serialization.h>
#include <rovio_sfm/FrameEventMsg.h>
#include <rovio_sfm/PlaceMatchMsg.h>

#include <algorithm>
#include <memory>

#include "fuzz/bounded_new.h"
#include "fuzz/fuzz_input.h"
#include "rovio_sfm/ros/frame_event_message.h"
#include "rovio_sfm/ros/place_match_message.h"

namespace {

template <typename Message>
void Convert(std::string_view bytes) {
  const auto copy = std::make_unique<uint8_t[]>(bytes.size());  // somewhere even where it is empty
  std::copy(bytes.begin(), bytes.end(), copy.get());
  Message message;
  try {
    ros::serialization::IStream stream(copy.get(), static_cast<uint32_t>(bytes.size()));
    ros::serialization::deserialize(stream, message);
  } catch (const std::exception&) {  // roscpp drops the message
    return;
  }
  std::string error;
  const auto converted = rovio_sfm::FromMessage(message, &error);
  if (converted) rovio_sfm::FromMessage(message, &error);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  rovio_sfm::FuzzInput input(data, size);
  const bool is_frame = input.Take<uint8_t>() % 2 == 0;
  is_frame ? Convert<rovio_sfm::FrameEventMsg>(input.Rest())
           : Convert<rovio_sfm::PlaceMatchMsg>(input.Rest());
  return 0;
}
