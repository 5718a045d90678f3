#pragma once

#include <string>

#include "rovio_sfm/util/option_table.h"

// Options as people and YAML read them.
namespace rovio_sfm {

// The shortest text that reads back as the same value; lists in brackets.
std::string TextOf(const OptionValue& value);
std::string TextOf(double value);

// The same for YAML: numbers that may be fractions have a point, texts that YAML would not take as
// such stand in quotes.
std::string YamlTextOf(const OptionValue& value);

// "1 to 5", "0 or more", "sift or orb"; empty where anything fits.
std::string RangeText(const OptionRow& row);

// "px" of max_error_px, "m/s" of min_speed_m_per_s; empty without a unit.
std::string UnitOf(const std::string& name);

}  // namespace rovio_sfm
