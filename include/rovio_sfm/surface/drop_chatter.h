#pragma once

namespace rovio_sfm {

// While one lives, what PCL's Poisson prints of its own octree ("Vertex pair not in list …", by
// hundreds, into the answers of tools) does not reach the standard output; all else that any thread
// prints does. Thread-safe; several may live at once.
class DropChatter {
 public:
  DropChatter();
  ~DropChatter();
  DropChatter(const DropChatter&) = delete;
  DropChatter& operator=(const DropChatter&) = delete;
};

}  // namespace rovio_sfm
