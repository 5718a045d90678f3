#pragma once

#include <map>
#include <utility>

namespace rovio_sfm {

// Disjoint sets of ids whose root is the smallest id of the set; ids never seen are their own root.
template <typename Id>
class UnionFind {
 public:
  Id Find(Id id) const {
    for (auto it = parent_.find(id); it != parent_.end(); it = parent_.find(id)) id = it->second;
    return id;
  }

  // Returns the root of the united set.
  Id Union(Id a, Id b) {
    a = Find(a);
    b = Find(b);
    if (b < a) std::swap(a, b);
    if (a < b) parent_[b] = a;
    return a;
  }

 private:
  std::map<Id, Id> parent_;
};

}  // namespace rovio_sfm
