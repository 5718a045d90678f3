#include "rovio_sfm/places/place_model.h"

#include <algorithm>
#include <array>
#include <utility>

#include "rovio_sfm/util/binary_fields.h"
#include "rovio_sfm/util/check_options.h"
#include "rovio_sfm/util/checksum.h"

namespace rovio_sfm {
namespace {

constexpr std::array<char, 8> kMagic = {'R', 'O', 'V', 'I', 'O', 'P', 'L', 'C'};
constexpr uint32_t kMaxWords = 1u << 16, kMaxLength = 512, kMaxBags = 1u << 16;
constexpr uint32_t kMaxProvenance = 4096;

void WriteTree(const ChowLiuTree& tree, FieldWriter* writer) {
  for (const ChowLiuNode& node : tree) {
    writer->Write(node.parent);
    writer->Write(node.p_z);
    writer->Write(node.p_z_given_parent_true);
    writer->Write(node.p_z_given_parent_false);
  }
}

ChowLiuTree ReadTree(uint32_t num_words, FieldReader* reader) {
  ChowLiuTree tree;
  for (uint32_t word = 0; word < num_words; ++word) {
    ChowLiuNode node;
    node.parent = reader->Read<uint32_t>("tree parent");
    node.p_z = reader->Read<double>("tree p_z");
    node.p_z_given_parent_true = reader->Read<double>("tree p_z_given_parent_true");
    node.p_z_given_parent_false = reader->Read<double>("tree p_z_given_parent_false");
    tree.push_back(node);
  }
  return tree;
}

std::string EncodePayload(const PlaceModel& model) {
  const Descriptors& words = model.vocabulary.Words();
  FieldWriter writer;
  writer.WriteText(model.provenance);
  writer.Write(static_cast<uint8_t>(words.type));
  writer.Write(words.length);
  writer.Write(static_cast<uint32_t>(words.Count()));
  writer.WriteAll(words.data);
  WriteTree(model.tree, &writer);
  writer.Write(model.detector.p_z_given_e);
  writer.Write(model.detector.p_z_given_not_e);
  writer.Write(static_cast<uint32_t>(model.training_bags.size()));
  for (const WordBag& bag : model.training_bags) {
    writer.Write(static_cast<uint32_t>(bag.size()));
    writer.WriteAll(bag);
  }
  return writer.Bytes();
}

Vocabulary ReadVocabulary(FieldReader* reader) {
  Descriptors words;
  const auto type = reader->ReadBetween<uint8_t>("descriptor type", 1, 4);
  words.type = static_cast<DescriptorType>(type);
  words.length = reader->ReadBetween<uint32_t>("descriptor length", 1, kMaxLength);
  const auto num_words = reader->ReadBetween<uint32_t>("words", 1, kMaxWords);
  words.data = reader->ReadAll<uint8_t>("words", size_t{num_words} * words.length);
  return Vocabulary(std::move(words));
}

std::vector<WordBag> ReadBags(uint32_t num_words, FieldReader* reader) {
  std::vector<WordBag> bags;
  const auto num_bags = reader->ReadBetween<uint32_t>("training bags", 0, kMaxBags);
  for (uint32_t i = 0; i < num_bags; ++i) {
    const auto size = reader->ReadBetween<uint32_t>("size of a training bag", 0, num_words);
    bags.push_back(reader->ReadAll<uint32_t>("words of a training bag", size));
  }
  return bags;
}

PlaceModel ReadPayload(FieldReader* reader) {
  PlaceModel model;
  model.provenance = reader->ReadText("provenance", kMaxProvenance);
  model.vocabulary = ReadVocabulary(reader);
  const auto num_words = static_cast<uint32_t>(model.vocabulary.NumWords());
  model.tree = ReadTree(num_words, reader);
  model.detector.p_z_given_e = reader->Read<double>("p_z_given_e");
  model.detector.p_z_given_not_e = reader->Read<double>("p_z_given_not_e");
  model.training_bags = ReadBags(num_words, reader);
  reader->RequireEnd();
  return model;
}

// Reads the header and leaves the reader at a payload that is whole.
void CheckHeader(FieldReader* reader) {
  const std::vector<char> magic = reader->ReadAll<char>("magic", kMagic.size());
  if (!std::equal(magic.begin(), magic.end(), kMagic.begin())) {
    reader->Fail("magic: not a place model");
  }
  const auto version = reader->Read<uint32_t>("version");
  if (version != kPlaceModelVersion) {
    reader->Fail("version = " + std::to_string(version) + ": expected " +
                 std::to_string(kPlaceModelVersion));
  }
  const auto checksum = reader->Read<uint32_t>("checksum");
  const auto size = reader->Read<uint64_t>("payload size");
  if (size != reader->Left()) {
    reader->Fail("payload size = " + std::to_string(size) + ": the file holds " +
                 std::to_string(reader->Left()));
  }
  const uint32_t actual = Checksum(reader->Position(), reader->Left());
  if (actual != checksum) {
    reader->Fail("checksum = " + std::to_string(checksum) + ": the bytes give " +
                 std::to_string(actual));
  }
}

bool Complain(const std::string& complaint, std::string* error) {
  if (error != nullptr) *error = complaint;
  return false;
}

bool IsBag(const WordBag& bag, size_t num_words) {
  for (size_t i = 1; i < bag.size(); ++i) {
    if (bag[i - 1] >= bag[i]) return false;
  }
  return bag.empty() || bag.back() < num_words;
}

}  // namespace

bool PlaceModel::IsValid(std::string* error) const {
  const size_t num_words = vocabulary.NumWords();
  if (num_words == 0 || num_words > kMaxWords) {
    return Complain("words = " + std::to_string(num_words) + ": expected 1 to 65536", error);
  }
  if (tree.size() != num_words) {
    return Complain("tree nodes = " + std::to_string(tree.size()) + ": expected one of each of " +
                        std::to_string(num_words) + " words",
                    error);
  }
  if (provenance.size() > kMaxProvenance) return Complain("provenance: over 4096 bytes", error);
  if (!IsValidTree(tree, error) || !rovio_sfm::IsValid(detector, error)) return false;
  for (size_t i = 0; i < training_bags.size(); ++i) {
    if (IsBag(training_bags[i], num_words)) continue;
    return Complain("training bag " + std::to_string(i) + ": words not ascending or too great",
                    error);
  }
  return true;
}

std::string EncodePlaceModel(const PlaceModel& model) {
  const std::string payload = EncodePayload(model);
  const auto* data = reinterpret_cast<const uint8_t*>(payload.data());
  FieldWriter header;
  header.WriteAll(std::vector<char>(kMagic.begin(), kMagic.end()));
  header.Write(kPlaceModelVersion);
  header.Write(Checksum(data, payload.size()));
  header.Write(static_cast<uint64_t>(payload.size()));
  return header.Bytes() + payload;
}

PlaceModel DecodePlaceModel(const std::vector<uint8_t>& bytes, const std::string& file) {
  FieldReader reader(bytes.data(), bytes.size(), file);
  CheckHeader(&reader);
  PlaceModel model = ReadPayload(&reader);
  std::string error;
  if (!model.IsValid(&error)) reader.Fail(error);
  return model;
}

}  // namespace rovio_sfm
