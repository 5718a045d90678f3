#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "rovio_sfm/scene/feature_link.h"

namespace rovio_sfm {

// Links that are kept as long as the map, in a third of their memory: each field as its step from
// the link before, in as many bytes as the step needs. Neighbours in a sorted list differ little.
class LinkList {
 public:
  LinkList() = default;
  LinkList(const std::vector<FeatureLink>& links);  // NOLINT: a vector is a list of links

  // In the order in which they came.
  std::vector<FeatureLink> List() const;
  size_t size() const { return size_; }
  bool empty() const { return size_ == 0; }

  friend bool operator==(const LinkList& x, const LinkList& y) { return x.steps_ == y.steps_; }

 private:
  std::string steps_;
  size_t size_ = 0;
};

}  // namespace rovio_sfm
