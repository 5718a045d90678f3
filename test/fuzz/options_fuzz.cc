// Option YAML of every node.
#include <yaml-cpp/yaml.h>

#include <stdexcept>

#include "fuzz/fuzz_input.h"
#include "rovio_sfm/app/driver_options.h"
#include "rovio_sfm/app/frontend_node_options.h"
#include "rovio_sfm/app/load_options.h"
#include "rovio_sfm/app/mapping_node_options.h"
#include "rovio_sfm/app/place_recognition_node_options.h"

namespace {

template <typename Options>
void Load(const YAML::Node& node) {
  Options options;
  try {
    rovio_sfm::LoadOptions(node, "fuzz", &options);
  } catch (const std::runtime_error&) {  // refused, and says why (YAML's errors are such too)
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace rovio_sfm;  // NOLINT: a fuzz target is a main
  YAML::Node node;
  try {
    node = YAML::Load(std::string(FuzzInput(data, size).Rest()));
  } catch (const YAML::Exception&) {
    return 0;
  }
  Load<DriverOptions>(node);
  Load<FrontendNodeOptions>(node);
  Load<MappingNodeOptions>(node);
  Load<PlaceRecognitionNodeOptions>(node);
  return 0;
}
