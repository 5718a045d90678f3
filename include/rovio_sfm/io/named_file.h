#pragma once

#include <string>

namespace rovio_sfm {

// A file of an export that is still to be written.
struct NamedFile {
  std::string name;  // path below the export's folder
  std::string content;
};

}  // namespace rovio_sfm
