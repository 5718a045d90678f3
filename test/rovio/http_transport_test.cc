#include "rovio_sfm/rovio/http_transport.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

TEST(HttpResponse, IsOkOnlyAsAWholeAnswerWithStatus200) {
  HttpResponse response;
  EXPECT_FALSE(response.IsOk());
  response.status = 200;
  EXPECT_TRUE(response.IsOk());
  response.fault = HttpFault::kInterrupted;
  EXPECT_FALSE(response.IsOk());
}

TEST(HttpFault, HasAWordForEachKind) {
  EXPECT_STREQ(NameOf(HttpFault::kConnect), "no connection");
  EXPECT_STREQ(NameOf(HttpFault::kCancelled), "cancelled");
}

}  // namespace
}  // namespace rovio_sfm
