#include "rovio_sfm/app/option_files.h"

#include "rovio_sfm/app/drive_tour_options.h"
#include "rovio_sfm/app/driver_options.h"
#include "rovio_sfm/app/frontend_node_options.h"
#include "rovio_sfm/app/map_web_options.h"
#include "rovio_sfm/app/mapping_node_options.h"
#include "rovio_sfm/app/option_pages.h"
#include "rovio_sfm/app/place_recognition_node_options.h"

namespace rovio_sfm {
namespace {

constexpr const char* kIntroduction = R"(# Options

Written by `scripts/write_options`, like the files of `config/` that are named here: do not edit
them. An option is said once, in the struct of the stage that uses it. From its row in
`DescribeOptions` come loading (unknown keys, other types and values out of range stop a node at its
start, by name), the lines "option …" in its log, `~thresholds` of dynamic_reconfigure (options that
are **live**), the shipped YAML and this page. `scripts/count_option_lines` counts what that costs.

## A new option in five lines

1. The field with its default, in the stage's struct: `int max_weak_frames = 3;` (`MapperOptions`).
2. Its row in `DescribeOptions` below it, unit in the name; `AddLiveNumber` if it may change live:
   `table.AddNumber("max_weak_frames", max_weak_frames, 0, 100, "more in a row end the session");`
   (`AddFlag`, `AddText`, `AddChoice`, `AddDegrees`, `AddGroup` …; `AddRule` ties it to others).
3. The code that reads the field, and a test that turns it.
4. `scripts/write_options` writes `config/` and this page anew; commit what it changed.
5. Nothing else: if a file was forgotten, `app_test` says which.
)";

template <typename Options>
std::string YamlText(const std::string& header) {
  Options options;
  YamlTable table;
  options.DescribeOptions(table);
  return "# " + header + ", with their defaults; written by scripts/write_options.\n" +
         "# docs/options.md has units and ranges.\n" + table.Text();
}

template <typename Options>
std::string PageText(const std::string& title, const std::set<std::string>& omitted = {}) {
  Options options;
  MarkdownTable table(omitted);
  options.DescribeOptions(table);
  return "\n## " + title + "\n" + table.Text();
}

std::string OptionsPage() {
  return kIntroduction + PageText<FrontendOptions>("`config/frontend.yaml`") +
         PageText<MapOptions>("`config/mapping.yaml`") +
         PageText<PlaceRecognizerOptions>("`config/place_recognition.yaml`") +
         PageText<DriverOptions>("`config/rovio_driver.yaml`") +
         PageText<DriveTourOptions>("`config/drive_tour.yaml`") +
         PageText<FrontendNodeOptions>("Parameters of `frontend`", {"frontend"}) +
         PageText<MappingNodeOptions>("Parameters of `mapping`", {"mapper"}) +
         PageText<PlaceRecognitionNodeOptions>("Parameters of `place_recognition`",
                                               {"places", "frontend"}) +
         PageText<MapWebOptions>("Parameters of `map_web`");
}

}  // namespace

std::vector<OptionFile> WriteOptionFiles() {
  return {{"config/frontend.yaml", YamlText<FrontendOptions>("Options of the frontend")},
          {"config/mapping.yaml", YamlText<MapOptions>("Options of the mapper")},
          {"config/place_recognition.yaml",
           YamlText<PlaceRecognizerOptions>("Options of place recognition")},
          {"config/rovio_driver.yaml",
           YamlText<DriverOptions>("Parameters of rovio_driver beside host")},
          {"config/drive_tour.yaml",
           YamlText<DriveTourOptions>("Parameters of drive_tour beside tour")},
          {"docs/options.md", OptionsPage()}};
}

}  // namespace rovio_sfm
