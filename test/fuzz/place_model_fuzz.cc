// A place model whose header and checksum are right, so that what lies behind them is reached; and
// the bytes as they are.
#include <zlib.h>

#include <stdexcept>
#include <vector>

#include "fuzz/fuzz_input.h"
#include "rovio_sfm/places/place_model.h"

namespace {

template <typename T>
void Append(const T& value, std::vector<uint8_t>* bytes) {
  const auto* begin = reinterpret_cast<const uint8_t*>(&value);
  bytes->insert(bytes->end(), begin, begin + sizeof(T));
}

std::vector<uint8_t> WithHeader(const uint8_t* data, size_t size) {
  const std::string_view magic = "ROVIOPLC";
  std::vector<uint8_t> bytes(magic.begin(), magic.end());
  Append(rovio_sfm::kPlaceModelVersion, &bytes);
  Append(static_cast<uint32_t>(crc32_z(crc32_z(0, nullptr, 0), data, size)), &bytes);
  Append(static_cast<uint64_t>(size), &bytes);
  bytes.insert(bytes.end(), data, data + size);
  return bytes;
}

void Decode(const std::vector<uint8_t>& bytes) {
  try {
    rovio_sfm::DecodePlaceModel(bytes, "fuzz");
  } catch (const std::runtime_error&) {  // refused, and says why
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  Decode(WithHeader(data, size));
  Decode({data, data + size});
  return 0;
}
