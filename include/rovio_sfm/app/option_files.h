#pragma once

#include <string>
#include <vector>

namespace rovio_sfm {

struct OptionFile {
  std::string path;  // below the package's root
  std::string text;
};

// What is written from the tables of options: the shipped files of config/ and docs/options.md.
std::vector<OptionFile> WriteOptionFiles();

}  // namespace rovio_sfm
