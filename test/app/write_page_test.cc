#include "rovio_sfm/app/write_page.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(PageText, HoldsAllThatItNeeds) {
  const std::string page = PageText(R"({"map": 7})");
  EXPECT_NE(page.find(R"({"map": 7})"), std::string::npos);
  for (const char* part :
       {"OrbitControls", "WebGLRenderer", "class MapView", "function barChart", "--paper"}) {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(page.find("<script src"), std::string::npos);
  EXPECT_EQ(page.find("<link rel=\"stylesheet"), std::string::npos);
}

TEST(PageText, NothingInItsDataEndsTheScript) {
  const std::string with = PageText(R"({"reason": "</script><b>"})"), without = PageText("{}");
  const auto count = [](const std::string& text) {
    size_t number = 0;
    for (size_t at = text.find("</script>"); at != std::string::npos;
         at = text.find("</script>", at + 1))
      ++number;
    return number;
  };
  EXPECT_EQ(count(with), count(without));
}

TEST(LivePageText, IsTheSamePageThatFetchesItsData) {
  const std::string report = PageText("{}"), live = LivePageText(R"({"live": true})");
  for (const char* part : {"class LivePage", "id=\"cameras\"", "data-service=\"save_map\""}) {
    EXPECT_NE(live.find(part), std::string::npos) << part;
    EXPECT_EQ(report.find(part), std::string::npos) << part;
  }
  EXPECT_NE(live.find("class MapView"), std::string::npos);
  EXPECT_NE(live.find(R"({"live": true})"), std::string::npos);
  for (const std::string& page : {report, live}) EXPECT_EQ(page.find("<!--"), std::string::npos);
}

}  // namespace
}  // namespace rovio_sfm
