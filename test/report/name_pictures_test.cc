#include "rovio_sfm/report/name_pictures.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

// The names that the pictures of one drive get.
std::vector<std::string> NamesOf(const std::vector<std::string>& image_names) {
  MapModel model;
  model.images.resize(image_names.size());
  for (uint32_t i = 0; i < image_names.size(); ++i) model.images[i].id = {{"rovio", 5, 6}, i + 7};
  NamePictures(image_names, &model);
  std::vector<std::string> names;
  for (const ModelImage& image : model.images) names.push_back(image.name);
  return names;
}

TEST(NamePictures, KeepsTheNamesOfFiles) {
  EXPECT_EQ(NamesOf({"images/1305031102.175304.png", "b.JPG"}),
            (std::vector<std::string>{"rovio/1305031102.175304.png", "rovio/b.JPG"}));
}

TEST(NamePictures, NumbersWhatHasNoNameOfAPicture) {
  EXPECT_EQ(NamesOf({"000012", ""}),
            (std::vector<std::string>{"rovio/frame_000007.jpg", "rovio/frame_000008.jpg"}));
}

TEST(NamePictures, GivesNoNameTwice) {
  EXPECT_EQ(NamesOf({"a.jpg", "x/a.jpg", "frame_000007.jpg"}),
            (std::vector<std::string>{"rovio/frame_000007.jpg", "rovio/frame_000008.jpg",
                                      "rovio/frame_000009.jpg"}));
}

// Names come from messages.
TEST(NamePictures, LeadsNowhereElse) {
  for (const char* name : {"..", "../../.jpg", ".hidden.jpg", "a b.jpg", "a\n.jpg", "a\\b.jpg",
                           "x.sh", "\xc3\xa4.jpg"}) {
    EXPECT_EQ(NamesOf({name})[0], "rovio/frame_000007.jpg") << name;
  }
  EXPECT_EQ(NamesOf({"/etc/../etc/a.jpg"})[0], "rovio/a.jpg");
  EXPECT_EQ(NamesOf({std::string(500, 'a') + ".jpg"})[0], "rovio/frame_000007.jpg");
}

TEST(NamePictures, GivesEachDriveAFolder) {
  MapModel model;
  model.images.resize(2);
  model.images[0].id = {{"rovio", 5, 6}, 0};
  model.images[1].id = {{"rovio", 5, 7}, 0};
  NamePictures({"a.jpg", "a.jpg"}, &model);
  EXPECT_EQ(model.images[0].name, "rovio-5-6/a.jpg");
  EXPECT_EQ(model.images[1].name, "rovio-5-7/a.jpg");
}

}  // namespace
}  // namespace rovio_sfm
