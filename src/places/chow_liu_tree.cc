#include "rovio_sfm/places/chow_liu_tree.h"

#include <algorithm>
#include <cmath>

#include "rovio_sfm/util/check.h"

namespace rovio_sfm {
namespace {

// Which images show each word, as bits, and how many do.
class WordOccurrences {
 public:
  WordOccurrences(const std::vector<WordBag>& bags, size_t num_words)
      : num_images_(bags.size()),
        stride_((bags.size() + 63) / 64),
        bits_(num_words * stride_, 0),
        counts_(num_words, 0) {
    for (size_t image = 0; image < bags.size(); ++image) {
      for (const uint32_t word : bags[image]) {
        ROVIO_CHECK(word < num_words);
        bits_[word * stride_ + image / 64] |= uint64_t{1} << (image % 64);
        ++counts_[word];
      }
    }
  }

  size_t NumWords() const { return counts_.size(); }
  size_t NumImages() const { return num_images_; }
  size_t Count(size_t word) const { return counts_[word]; }
  size_t CountBoth(size_t a, size_t b) const {
    size_t count = 0;
    for (size_t i = 0; i < stride_; ++i) {
      const uint64_t both = bits_[a * stride_ + i] & bits_[b * stride_ + i];
      count += static_cast<size_t>(__builtin_popcountll(both));
    }
    return count;
  }

 private:
  size_t num_images_;
  size_t stride_;
  std::vector<uint64_t> bits_;
  std::vector<size_t> counts_;
};

// Mutual information of pairs of words, in nats, times the number of images.
class MutualInformation {
 public:
  explicit MutualInformation(const WordOccurrences& occurrences) : occurrences_(occurrences) {
    for (size_t n = 0; n <= occurrences.NumImages(); ++n) {
      n_log_n_.push_back(n == 0 ? 0.0 : static_cast<double>(n) * std::log(static_cast<double>(n)));
    }
    for (size_t word = 0; word < occurrences.NumWords(); ++word) {
      single_.push_back(Split(occurrences.Count(word), occurrences.NumImages()));
    }
  }

  double Of(size_t a, size_t b) const {
    const size_t both = occurrences_.CountBoth(a, b), with_a = occurrences_.Count(a);
    const size_t with_b = occurrences_.Count(b), without_a = occurrences_.NumImages() - with_a;
    return Split(both, with_a) + Split(with_b - both, without_a) - single_[a] - single_[b] +
           n_log_n_.back();
  }

 private:
  // n log n of a part and of the rest.
  double Split(size_t part, size_t whole) const { return n_log_n_[part] + n_log_n_[whole - part]; }

  const WordOccurrences& occurrences_;
  std::vector<double> n_log_n_;
  std::vector<double> single_;
};

size_t MostFrequentWord(const WordOccurrences& occurrences) {
  size_t best = 0;
  for (size_t word = 1; word < occurrences.NumWords(); ++word) {
    if (occurrences.Count(word) > occurrences.Count(best)) best = word;
  }
  return best;
}

// Each word's parent in the maximum spanning tree, by Prim's algorithm from the root on.
std::vector<uint32_t> FindParents(const WordOccurrences& occurrences) {
  const MutualInformation information(occurrences);
  const size_t num_words = occurrences.NumWords();
  std::vector<uint32_t> parents(num_words, kNoParent), outside;
  std::vector<double> best(num_words, -1.0);  // information shared with the parent, so far
  auto newest = static_cast<uint32_t>(MostFrequentWord(occurrences));
  for (uint32_t word = 0; word < num_words; ++word) {
    if (word != newest) outside.push_back(word);
  }
  while (!outside.empty()) {
    size_t chosen = 0;
    for (size_t i = 0; i < outside.size(); ++i) {
      const uint32_t word = outside[i];
      const double shared = std::max(0.0, information.Of(newest, word));  // rounding
      if (shared > best[word]) {
        best[word] = shared;
        parents[word] = newest;
      }
      if (best[word] > best[outside[chosen]]) chosen = i;
    }
    newest = outside[chosen];
    outside.erase(outside.begin() + static_cast<std::ptrdiff_t>(chosen));
  }
  return parents;
}

// Counts with the pseudo images mixed in: independent words, each in the mean share of images, so
// that p(z) remains the sum over the parent's states of p(z | parent) p(parent).
class SmoothedCounts {
 public:
  SmoothedCounts(const WordOccurrences& occurrences, double pseudo_images)
      : occurrences_(occurrences), pseudo_images_(pseudo_images) {
    double sum = 0.5;  // never 0 …
    const auto num_images = static_cast<double>(occurrences.NumImages());
    const auto num_words = static_cast<double>(occurrences.NumWords());
    for (size_t word = 0; word < occurrences.NumWords(); ++word) {
      sum += static_cast<double>(occurrences.Count(word));
    }
    mean_share_ = sum / (num_images * num_words + 1.0);  // … nor 1
  }

  ChowLiuNode NodeOf(size_t word, uint32_t parent) const {
    const double both_share = pseudo_images_ * mean_share_ * mean_share_;
    ChowLiuNode node;
    node.parent = parent;
    node.p_z = CountOf(word) / Total();
    node.p_z_given_parent_true = node.p_z_given_parent_false = node.p_z;
    if (parent == kNoParent) return node;
    const double both = static_cast<double>(occurrences_.CountBoth(word, parent)) + both_share;
    node.p_z_given_parent_true = both / CountOf(parent);
    node.p_z_given_parent_false = (CountOf(word) - both) / (Total() - CountOf(parent));
    return node;
  }

 private:
  double Total() const { return static_cast<double>(occurrences_.NumImages()) + pseudo_images_; }
  double CountOf(size_t word) const {
    return static_cast<double>(occurrences_.Count(word)) + pseudo_images_ * mean_share_;
  }

  const WordOccurrences& occurrences_;
  double pseudo_images_;
  double mean_share_ = 0.0;
};

bool RefuseTree(size_t word, const std::string& reason, std::string* error) {
  if (error != nullptr) *error = "tree node " + std::to_string(word) + ": " + reason;
  return false;
}

bool HasProbabilities(const ChowLiuNode& node) {
  for (const double p : {node.p_z, node.p_z_given_parent_true, node.p_z_given_parent_false}) {
    if (!(p > 0.0 && p < 1.0)) return false;
  }
  return true;
}

// Steps from each node towards the root, each node once: 0 unknown, 1 on the way, 2 reaches it.
bool AllReachRoot(const ChowLiuTree& tree, std::string* error) {
  std::vector<uint8_t> states(tree.size(), 0);
  for (uint32_t start = 0; start < tree.size(); ++start) {
    std::vector<uint32_t> path;
    uint32_t word = start;
    while (word != kNoParent && states[word] == 0) {
      states[word] = 1;
      path.push_back(word);
      word = tree[word].parent;
    }
    if (word != kNoParent && states[word] == 1)
      return RefuseTree(word, "its ancestors form a ring", error);
    for (const uint32_t passed : path) states[passed] = 2;
  }
  return true;
}

}  // namespace

ChowLiuTree LearnChowLiuTree(const std::vector<WordBag>& bags, size_t num_words,
                             const ChowLiuOptions& options) {
  ROVIO_CHECK(!bags.empty() && num_words > 0);
  const WordOccurrences occurrences(bags, num_words);
  const std::vector<uint32_t> parents = FindParents(occurrences);
  const SmoothedCounts counts(occurrences, options.pseudo_images);
  ChowLiuTree tree;
  for (size_t word = 0; word < num_words; ++word)
    tree.push_back(counts.NodeOf(word, parents[word]));
  return tree;
}

bool IsValidTree(const ChowLiuTree& tree, std::string* error) {
  size_t num_roots = 0;
  for (size_t word = 0; word < tree.size(); ++word) {
    const ChowLiuNode& node = tree[word];
    if (node.parent == kNoParent) ++num_roots;
    if (node.parent != kNoParent && node.parent >= tree.size()) {
      return RefuseTree(
          word,
          "parent " + std::to_string(node.parent) + " of " + std::to_string(tree.size()) + " words",
          error);
    }
    if (!HasProbabilities(node)) return RefuseTree(word, "probability outside (0, 1)", error);
  }
  if (num_roots != 1) return RefuseTree(0, std::to_string(num_roots) + " roots in the tree", error);
  return AllReachRoot(tree, error);
}

}  // namespace rovio_sfm
