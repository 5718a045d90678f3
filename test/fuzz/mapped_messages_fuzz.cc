// Two drives and their place matches as they go over the wire, with changes: {message, offset,
// width, value} each. What is converted goes on into the mapper: whatever the border lets in must
// neither end it nor break a map.
#include <ros/serialization.h>

#include <cstdlib>
#include <vector>

#include "fuzz/bounded_new.h"
#include "fuzz/fuzz_input.h"
#include "merging/two_drives.h"
#include "rovio_sfm/app/mapping_engine.h"
#include "rovio_sfm/ros/frame_event_message.h"
#include "rovio_sfm/ros/place_match_message.h"

namespace rovio_sfm {
namespace {

using Bytes = std::vector<uint8_t>;

struct Wire {
  std::vector<Bytes> frames, matches;
};

template <typename Message>
Bytes Serialize(const Message& message) {
  Bytes bytes(ros::serialization::serializationLength(message));
  ros::serialization::OStream stream(bytes.data(), static_cast<uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, message);
  return bytes;
}

template <typename Message>
bool Deserialize(Bytes bytes, Message* message) {
  try {
    ros::serialization::IStream stream(bytes.data(), static_cast<uint32_t>(bytes.size()));
    ros::serialization::deserialize(stream, *message);
    return true;
  } catch (const std::exception&) {  // roscpp drops the message
    return false;
  }
}

// Of the same frame of both drives, with the pose that the border asks for.
PlaceMatch WholeOverlap(const TwoDrives& two, uint32_t frame) {
  PlaceMatch match = TrueOverlap(two, frame, frame);
  const auto& cams = two.world.cams_from_map;
  Rigid3& pose = match.pairs.front().query_from_other;
  pose = cams[CameraOf(true, frame)] * Inverse(cams[CameraOf(false, frame)]);
  pose.translation.normalize();
  return match;
}

Wire MakeWire() {
  SyntheticDriveOptions options;
  options.world.num_cams = 10;  // as few as still merge: it is fast executions that find
  options.world.step = 0.3;
  options.world.num_points = 80;
  const TwoDrives two = MakeTwoDrives(options);
  Wire wire;
  for (size_t i = 0; i < two.a.size(); ++i) {
    wire.frames.push_back(Serialize(ToMessage(two.a[i])));
    wire.frames.push_back(Serialize(ToMessage(two.b[i])));
  }
  for (const uint32_t frame : {2u, 4u}) {
    wire.matches.push_back(Serialize(ToMessage(WholeOverlap(two, frame), 1)));
  }
  return wire;
}

void ChangeOne(FuzzInput* input, Wire* wire) {
  const size_t number = input->Take<uint8_t>() % (wire->frames.size() + wire->matches.size());
  Bytes& bytes = number < wire->frames.size() ? wire->frames[number]
                                              : wire->matches[number - wire->frames.size()];
  const size_t offset = input->Take<uint32_t>() % bytes.size();
  const size_t width = std::min<size_t>(1 + input->Take<uint8_t>() % 8, bytes.size() - offset);
  const std::string_view value = input->TakeBytes(width);
  std::copy(value.begin(), value.end(), bytes.begin() + static_cast<std::ptrdiff_t>(offset));
}

// The number of merges that hold in the end.
size_t MapAll(const Wire& wire) {
  MapOptions options;
  MappingEngine engine(options);
  std::string error;
  const auto add_match = [&](const Bytes& bytes) {
    PlaceMatchMsg message;
    if (!Deserialize(bytes, &message)) return;
    if (const auto match = FromMessage(message, &error)) engine.Add(*match);
  };
  add_match(wire.matches.front());  // before its frames
  for (const Bytes& bytes : wire.frames) {
    FrameEventMsg message;
    if (!Deserialize(bytes, &message)) continue;
    const auto event = FromMessage(message, &error);
    if (!event) continue;
    engine.NextIndex(event->id);
    engine.Add(*event);
  }
  add_match(wire.matches.back());
  engine.Finish();
  return engine.Picture().merges->size();
}

}  // namespace
}  // namespace rovio_sfm

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace rovio_sfm;  // NOLINT: a fuzz target is a main
  static const Wire original = MakeWire();
  static const size_t num_merges = MapAll(original);
  if (num_merges == 0) std::abort();  // nothing would reach what it is to try
  Wire wire = original;
  FuzzInput input(data, size);
  while (!input.IsEmpty()) ChangeOne(&input, &wire);
  MapAll(wire);
  return 0;
}
