#include "rovio_sfm/util/parse_arguments.h"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "util/temporary_folder.h"

namespace rovio_sfm {
namespace {

struct Values {
  uint64_t seed = 1;
  uint32_t map = 0;
  std::optional<size_t> most;
  size_t stride = 1;
  int delta = 0;
  double gap = 1.0;
  std::optional<double> share;
  std::vector<int> list;
  std::string out;  // what was printed

  std::optional<int> Parse(std::vector<const char*> words) {
    words.insert(words.begin(), "program");
    CLI::App app;
    app.add_option("--seed", seed);
    app.add_option("--most", most);
    app.add_option("--stride", stride)->check(CLI::Range(1, 1000000));
    app.add_option("--delta", delta);
    app.add_option("--list", list);
    app.add_option("--gap", gap)->check(CLI::Range(1e-6, 1e6));
    app.add_option("--share", share);
    app.add_flag("--flag", "of no value");
    app.add_subcommand("command", "has options too")->add_option("--map", map);
    std::ostringstream stream;
    const auto status = ParseArguments(&app, static_cast<int>(words.size()), words.data(), stream);
    out = stream.str();
    return status;
  }

  std::string Complaint(const std::vector<const char*>& words) {
    const std::string message = MessageOf([&] { Parse(words); });
    return message.substr(0, message.find('\n'));
  }
};

TEST(ParseArguments, ReadsWholeNumbers) {
  Values values;
  ASSERT_FALSE(
      values.Parse({"--seed", "18446744073709551615", "--most", "3", "--stride=1000000", "--delta",
                    "-4", "--list", "-1", "2", "--flag", "command", "--map", "4294967295"}));
  EXPECT_EQ(values.seed, 18446744073709551615u);
  EXPECT_EQ(values.most, 3u);
  EXPECT_EQ(values.stride, 1000000u);
  EXPECT_EQ(values.delta, -4);
  EXPECT_EQ(values.list, std::vector<int>({-1, 2}));
  EXPECT_EQ(values.map, 4294967295u);
}

TEST(ParseArguments, ReadsLeadingZerosAsDecimal) {
  Values values;
  ASSERT_FALSE(values.Parse({"--seed", "0777", "--delta", "-010", "--most", "000"}));
  EXPECT_EQ(values.seed, 777u);
  EXPECT_EQ(values.delta, -10);
  EXPECT_EQ(values.most, 0u);
}

TEST(ParseArguments, RefusesWhatWouldWrapRound) {
  Values values;
  const std::string expected = "expected a whole number, 0 to 18446744073709551615, not '-1'";
  EXPECT_EQ(values.Complaint({"--seed", "-1"}), "--seed: " + expected);
  EXPECT_EQ(values.Complaint({"--most=-1"}), "--most: " + expected);
  EXPECT_EQ(values.Complaint({"command", "--map", "-1"}), "--map: " + expected);
  EXPECT_EQ(values.Complaint({"--stride", "-1"}), "--stride: Value -1 not in range 1 to 1000000");
  EXPECT_EQ(values.Complaint({"--seed", "18446744073709551616"}),
            "--seed: expected a whole number of at most 64 bits, not '18446744073709551616'");
  EXPECT_NE(values.Complaint({"command", "--map", "4294967296"}), "");
  EXPECT_NE(values.Complaint({"--delta", "2147483648"}), "");
  EXPECT_EQ(values.seed, 1u);
}

TEST(ParseArguments, RefusesWhatIsNoWholeNumber) {
  for (const std::string value : {"3.5", "0x10", "1e3", "seven", "-", "+", "3 "}) {
    for (const std::string option : {"--seed", "--stride", "--delta", "--list"}) {
      const std::string word = option + "=" + value;
      EXPECT_EQ(Values().Complaint({word.c_str()}),
                option + ": expected a whole number, not '" + value + "'");
    }
  }
}

TEST(ParseArguments, ReadsFiniteNumbers) {
  Values values;
  ASSERT_FALSE(values.Parse({"--gap", "2.5e-3", "--share=+7"}));
  EXPECT_EQ(values.gap, 2.5e-3);
  EXPECT_EQ(values.share, 7.0);
  ASSERT_FALSE(values.Parse({"--share", "-.5"}));
  EXPECT_EQ(values.share, -0.5);
}

TEST(ParseArguments, RefusesWhatIsNoFiniteNumber) {
  for (const std::string value : {"nan", "-nan", "NaN", "nan(1)", "inf", "-inf", "1e999", "much"}) {
    for (const std::string option : {"--gap", "--share"}) {
      const std::string word = option + "=" + value;
      EXPECT_EQ(Values().Complaint({word.c_str()}),
                option + ": expected a finite number, not '" + value + "'");
    }
  }
  EXPECT_EQ(Values().Complaint({"--gap", "0"}),
            "--gap: Value 0 not in range 0.000001 to 1000000.000000");
}

TEST(ParseArguments, HelpsOnTheStreamAndEndsThere) {
  Values values;
  EXPECT_EQ(values.Parse({"--help"}), 0);
  EXPECT_NE(values.out.find("--stride"), std::string::npos) << values.out;
  EXPECT_EQ(values.Parse({"command", "--help"}), 0);
  EXPECT_NE(values.out.find("--map"), std::string::npos) << values.out;
  EXPECT_NE(MessageOf([&] { values.Parse({"--nonsense"}); }).find("--nonsense"), std::string::npos);
}

}  // namespace
}  // namespace rovio_sfm
