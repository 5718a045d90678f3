#include "rovio_sfm/tools/training_checkpoint.h"

#include <stdexcept>

#include "rovio_sfm/io/text_file.h"
#include "rovio_sfm/io/write_file.h"
#include "rovio_sfm/util/binary_fields.h"

namespace rovio_sfm {
namespace {

constexpr uintmax_t kMaxBytes = uintmax_t{2} << 30;
constexpr uint32_t kMaxKeyBytes = 1u << 24, kMaxRows = 1u << 24, kMaxLength = 512;

void Write(const Descriptors& descriptors, FieldWriter* writer) {
  writer->Write(static_cast<uint8_t>(descriptors.type));
  writer->Write(descriptors.length);
  writer->Write(static_cast<uint32_t>(descriptors.Count()));
  writer->WriteAll(descriptors.data);
}

Descriptors ReadDescriptors(FieldReader* reader) {
  Descriptors descriptors;
  descriptors.type = static_cast<DescriptorType>(reader->ReadBetween<uint8_t>("type", 1, 4));
  descriptors.length = reader->ReadBetween<uint32_t>("length", 1, kMaxLength);
  const auto num_rows = reader->ReadBetween<uint32_t>("rows", 0, kMaxRows);
  descriptors.data = reader->ReadAll<uint8_t>("rows", size_t{num_rows} * descriptors.length);
  return descriptors;
}

void Write(const std::vector<Descriptors>& all, FieldWriter* writer) {
  writer->Write(static_cast<uint32_t>(all.size()));
  for (const Descriptors& one : all) Write(one, writer);
}

std::vector<Descriptors> ReadAllDescriptors(FieldReader* reader) {
  std::vector<Descriptors> all;
  const auto count = reader->Read<uint32_t>("count");
  for (uint32_t i = 0; i < count; ++i) all.push_back(ReadDescriptors(reader));
  return all;
}

// Reads what stands in the file after the key; nothing if there is no file, another key, or less
// than there should be.
template <typename Function>
auto Load(const std::filesystem::path& path, const std::string& key, Function read)
    -> std::optional<decltype(read(static_cast<FieldReader*>(nullptr)))> {
  if (!std::filesystem::exists(path)) return std::nullopt;
  try {
    const std::vector<uint8_t> bytes = ReadBytes(path, kMaxBytes);
    FieldReader reader(bytes.data(), bytes.size(), path.string());
    if (reader.ReadText("key", kMaxKeyBytes) != key) return std::nullopt;
    auto value = read(&reader);
    reader.RequireEnd();
    return value;
  } catch (const std::runtime_error&) {
    return std::nullopt;
  }
}

TrainingFeatures ReadFeatures(FieldReader* reader) {
  TrainingFeatures features;
  features.images = ReadAllDescriptors(reader);
  features.second_looks = ReadAllDescriptors(reader);
  const auto num_images = static_cast<uint32_t>(features.images.size());
  if (num_images == 0) reader->Fail("no images");
  for (size_t i = 0; i < features.second_looks.size(); ++i) {
    features.looked_at.push_back(reader->ReadBetween<uint32_t>("looked at", 0, num_images - 1));
  }
  return features;
}

ClusterState ReadWords(FieldReader* reader) {
  ClusterState state;
  state.num_iterations = reader->Read<uint32_t>("iterations");
  state.converged = reader->ReadBetween<uint8_t>("converged", 0, 1) != 0;
  state.mean_squared_distance = reader->Read<double>("mean squared distance");
  state.words = ReadDescriptors(reader);
  return state;
}

}  // namespace

TrainingCheckpoint::TrainingCheckpoint(const std::filesystem::path& folder) : folder_(folder) {
  std::filesystem::create_directories(folder);
}

std::optional<TrainingFeatures> TrainingCheckpoint::LoadFeatures(const std::string& key) const {
  return Load(folder_ / "features.bin", key, ReadFeatures);
}

void TrainingCheckpoint::SaveFeatures(const std::string& key,
                                      const TrainingFeatures& features) const {
  FieldWriter writer;
  writer.WriteText(key);
  Write(features.images, &writer);
  Write(features.second_looks, &writer);
  writer.WriteAll(features.looked_at);
  WriteFile(folder_ / "features.bin", writer.Bytes(), Overwrite::kAllow);
}

std::optional<ClusterState> TrainingCheckpoint::LoadWords(const std::string& key) const {
  return Load(folder_ / "words.bin", key, ReadWords);
}

void TrainingCheckpoint::SaveWords(const std::string& key, const ClusterState& state) const {
  FieldWriter writer;
  writer.WriteText(key);
  writer.Write(state.num_iterations);
  writer.Write(static_cast<uint8_t>(state.converged));
  writer.Write(state.mean_squared_distance);
  Write(state.words, &writer);
  WriteFile(folder_ / "words.bin", writer.Bytes(), Overwrite::kAllow);
}

}  // namespace rovio_sfm
