#include "rovio_sfm/places/chow_liu_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "places/random_place_model.h"
#include "rovio_sfm/util/check_options.h"

namespace rovio_sfm {
namespace {

bool Has(const WordBag& bag, uint32_t word) {
  return std::find(bag.begin(), bag.end(), word) != bag.end();
}

double MutualInformationOf(const std::vector<WordBag>& bags, uint32_t a, uint32_t b) {
  double counts[2][2] = {{0, 0}, {0, 0}};
  for (const WordBag& bag : bags) counts[Has(bag, a)][Has(bag, b)] += 1.0;
  const double n = static_cast<double>(bags.size());
  double sum = 0.0;
  for (int i : {0, 1}) {
    for (int j : {0, 1}) {
      const double p = counts[i][j] / n;
      const double p_a = (counts[i][0] + counts[i][1]) / n;
      const double p_b = (counts[0][j] + counts[1][j]) / n;
      if (p > 0.0) sum += p * std::log(p / (p_a * p_b));
    }
  }
  return sum;
}

double InformationOfParents(const std::vector<WordBag>& bags,
                            const std::vector<uint32_t>& parents) {
  double sum = 0.0;
  for (uint32_t word = 0; word < parents.size(); ++word) {
    if (parents[word] != kNoParent) sum += MutualInformationOf(bags, word, parents[word]);
  }
  return sum;
}

std::vector<uint32_t> ParentsOf(const ChowLiuTree& tree) {
  std::vector<uint32_t> parents;
  for (const ChowLiuNode& node : tree) parents.push_back(node.parent);
  return parents;
}

ChowLiuTree TreeWithParents(const std::vector<uint32_t>& parents) {
  ChowLiuTree tree(parents.size());
  for (size_t i = 0; i < parents.size(); ++i) tree[i].parent = parents[i];
  return tree;
}

TEST(LearnChowLiuTree, FindsTheBestOfAllTrees) {
  Rng rng(3);
  constexpr uint32_t kWords = 5;
  const std::vector<WordBag> bags = RandomBags(40, kWords, &rng);
  const double found = InformationOfParents(bags, ParentsOf(LearnChowLiuTree(bags, kWords, {})));
  double best = 0.0;
  for (int code = 0; code < 5 * 5 * 5 * 5; ++code) {  // parents of words 1 to 4; 0 is the root
    std::vector<uint32_t> parents = {kNoParent};
    for (int digits = code; parents.size() < kWords; digits /= 5) {
      parents.push_back(static_cast<uint32_t>(digits % 5));
    }
    if (!IsValidTree(TreeWithParents(parents), nullptr)) continue;
    best = std::max(best, InformationOfParents(bags, parents));
  }
  EXPECT_NEAR(found, best, 1e-12);
}

TEST(LearnChowLiuTree, BindsWordsThatOccurTogether) {
  std::vector<WordBag> bags;
  for (int i = 0; i < 20; ++i) {
    bags.push_back(i % 2 == 0 ? WordBag{0, 2} : WordBag{1, 3});
    if (i % 3 == 0) bags.back().push_back(4);
  }
  const ChowLiuTree tree = LearnChowLiuTree(bags, 5, {});
  const bool bound =
      tree[2].parent == 0 || tree[0].parent == 2 || tree[2].parent == 1 || tree[2].parent == 3;
  EXPECT_TRUE(bound);
  ASSERT_NE(tree[3].parent, kNoParent);
  EXPECT_GT(std::abs(tree[3].p_z_given_parent_true - tree[3].p_z_given_parent_false), 0.8);
}

TEST(LearnChowLiuTree, KeepsTheShareOfEachWord) {
  Rng rng(4);
  const std::vector<WordBag> bags = RandomBags(60, 12, &rng);
  const ChowLiuTree tree = LearnChowLiuTree(bags, 12, {});
  for (const ChowLiuNode& node : tree) {
    if (node.parent == kNoParent) continue;
    const double p_parent = tree[node.parent].p_z;
    EXPECT_NEAR(
        node.p_z_given_parent_true * p_parent + node.p_z_given_parent_false * (1.0 - p_parent),
        node.p_z, 1e-12);
  }
}

TEST(LearnChowLiuTree, MakesAValidTreeOfWordsNeverAndAlwaysSeen) {
  const std::vector<WordBag> bags = {{0}, {0}, {0, 2}};  // 0 always, 1 never
  const ChowLiuTree tree = LearnChowLiuTree(bags, 3, {});
  std::string error;
  EXPECT_TRUE(IsValidTree(tree, &error)) << error;
  EXPECT_EQ(tree[0].parent, kNoParent);
  EXPECT_GT(tree[0].p_z, 0.7);
  EXPECT_LT(tree[1].p_z, 0.2);
}

TEST(LearnChowLiuTree, TakesASingleWord) {
  const ChowLiuTree tree = LearnChowLiuTree({{0}, {}}, 1, {});
  ASSERT_EQ(tree.size(), 1u);
  EXPECT_EQ(tree[0].parent, kNoParent);
}

TEST(LearnChowLiuTree, MovesTowardsIndependenceWithMorePseudoImages) {
  Rng rng(5);
  const std::vector<WordBag> bags = RandomBags(30, 8, &rng);
  const auto contrast = [&](double pseudo_images) {
    double sum = 0.0;
    for (const ChowLiuNode& node : LearnChowLiuTree(bags, 8, {pseudo_images})) {
      sum += std::abs(node.p_z_given_parent_true - node.p_z_given_parent_false);
    }
    return sum;
  };
  EXPECT_GT(contrast(0.1), contrast(5.0));
  EXPECT_GT(contrast(5.0), contrast(100.0));
}

TEST(ChowLiuOptions, RefusesNoPseudoImages) {
  std::string error;
  EXPECT_FALSE((IsValid(ChowLiuOptions{0.0}, &error)));
  EXPECT_EQ(error, "pseudo_images = 0: expected 0.01 to 1000");
}

TEST(IsValidTree, RefusesRingsTwoRootsMissingParentsAndCertainty) {
  std::string error;
  EXPECT_TRUE(IsValidTree(TreeWithParents({kNoParent, 0, 1}), &error));
  EXPECT_FALSE(IsValidTree(TreeWithParents({kNoParent, 2, 1}), &error));
  EXPECT_EQ(error, "tree node 1: its ancestors form a ring");
  EXPECT_FALSE(IsValidTree(TreeWithParents({kNoParent, kNoParent, 1}), &error));
  EXPECT_EQ(error, "tree node 0: 2 roots in the tree");
  EXPECT_FALSE(IsValidTree(TreeWithParents({kNoParent, 3, 1}), &error));
  EXPECT_EQ(error, "tree node 1: parent 3 of 3 words");
  ChowLiuTree certain = TreeWithParents({kNoParent, 0});
  certain[1].p_z_given_parent_true = 1.0;
  EXPECT_FALSE(IsValidTree(certain, &error));
  EXPECT_EQ(error, "tree node 1: probability outside (0, 1)");
}

}  // namespace
}  // namespace rovio_sfm
