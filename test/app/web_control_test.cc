#include "rovio_sfm/app/web_control.h"

#include <gtest/gtest.h>

namespace rovio_sfm {
namespace {

std::string ErrorOf(const std::string& service, const std::string& json) {
  std::string error;
  return ParseOrder(service, json, &error) ? "none" : error;
}

TEST(ParseOrder, ReadsEachOrder) {
  std::string error;
  const auto finish = ParseOrder("finish_session", R"({"robot": "rovio1"})", &error);
  ASSERT_TRUE(finish) << error;
  EXPECT_EQ(std::get<FinishSessionOrder>(*finish).robot, "rovio1");
  const auto merge =
      ParseOrder("merge_sessions", R"({"session_a": 1, "session_b": 2, "force": true})", &error);
  ASSERT_TRUE(merge) << error;
  EXPECT_EQ(std::get<MergeSessionsOrder>(*merge).session_a, 1u);
  EXPECT_EQ(std::get<MergeSessionsOrder>(*merge).session_b, 2u);
  EXPECT_TRUE(std::get<MergeSessionsOrder>(*merge).force);
  const auto unmerge = ParseOrder("unmerge_session", R"({"session": 4294967295})", &error);
  ASSERT_TRUE(unmerge) << error;
  EXPECT_EQ(std::get<UnmergeSessionOrder>(*unmerge).session, 4294967295u);
  const auto save = ParseOrder("save_map", R"({"name": "friday.db"})", &error);
  ASSERT_TRUE(save) << error;
  EXPECT_EQ(std::get<SaveMapOrder>(*save).name, "friday.db");
  EXPECT_FALSE(std::get<SaveMapOrder>(*save).overwrite);
}

TEST(ParseOrder, NamesWhatDoesNotFit) {
  EXPECT_EQ(ErrorOf("reset", "{}"),
            "expected one of finish_session, merge_sessions, save_map, unmerge_session");
  for (const char* body : {"", "{", "[1]", "1", "\"robot\"", "{\"robot\": \"a\"} x"}) {
    EXPECT_EQ(ErrorOf("finish_session", body), "body: expected a JSON object") << body;
  }
  EXPECT_EQ(ErrorOf("finish_session", "{}"), "robot = null: expected a text");
  EXPECT_EQ(ErrorOf("finish_session", R"({"robot": 3})"), "robot = 3: expected a text");
  EXPECT_EQ(ErrorOf("finish_session", R"({"robot": "../x"})"),
            "robot = \"../x\": expected a name as rovio1");
  EXPECT_EQ(ErrorOf("finish_session", R"({"robot": "rovio1", "speed": 1})"),
            "\"speed\": unknown field");
  for (const char* number : {"0", "-1", "1.5", "4294967296", "\"1\"", "null"}) {
    EXPECT_EQ(ErrorOf("unmerge_session", std::string("{\"session\": ") + number + "}"),
              std::string("session = ") + number + ": expected the number of a session, from 1");
  }
  EXPECT_EQ(ErrorOf("merge_sessions", R"({"session_a": 1, "session_b": 2, "force": 1})"),
            "force = 1: expected true or false");
  EXPECT_EQ(ErrorOf("save_map", R"({"name": ""})"),
            "name = \"\": expected 1 to 64 characters, as friday.db");
}

TEST(ParseOrder, MessagesStayShort) {
  const std::string longest(3000, 'x');
  EXPECT_LT(ErrorOf("save_map", R"({"name": ")" + longest + "\"}").size(), 200u);
  EXPECT_LT(ErrorOf("save_map", R"({"name": "a.db", ")" + longest + "\": 1}").size(), 200u);
}

TEST(IsOrder, KnowsItsServices) {
  EXPECT_TRUE(IsOrder("save_map"));
  EXPECT_FALSE(IsOrder("reset"));
}

}  // namespace
}  // namespace rovio_sfm
