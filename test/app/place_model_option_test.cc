#include "rovio_sfm/app/place_model_option.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace rovio_sfm {
namespace {

TEST(ReadPlaceModel, IsNullForNone) { EXPECT_EQ(ReadPlaceModel("none"), nullptr); }

TEST(ReadPlaceModel, NamesAFileThatIsNotThere) {
  try {
    ReadPlaceModel("/no/such/model.places");
    FAIL() << "a missing file was accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string(error.what()).find("/no/such/model.places"), std::string::npos);
  }
}

}  // namespace
}  // namespace rovio_sfm
