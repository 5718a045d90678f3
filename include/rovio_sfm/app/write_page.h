#pragma once

#include <string>

namespace rovio_sfm {

// The page of a map (config/page), whole in one text: template, viewer, data (PageDataJson) and
// three.js with its OrbitControls from Debian's libjs-three. Throws std::runtime_error naming a
// file that is missing, and the package that has it.
std::string PageText(const std::string& data_json);

// The same page as map_web serves it: it fetches its data by itself, and knows `settings_json`.
std::string LivePageText(const std::string& settings_json);

}  // namespace rovio_sfm
