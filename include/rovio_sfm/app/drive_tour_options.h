#pragma once

#include <yaml-cpp/yaml.h>

#include <string>

#include "rovio_sfm/rovio/tour_plan.h"
#include "rovio_sfm/util/option_table.h"

namespace rovio_sfm {

// For what the robot waits at a stop.
enum class TourLook { kNothing, kImage, kFrame };

// The private parameters of drive_tour.
struct DriveTourOptions {
  std::string tour;
  TourLook look = TourLook::kImage;
  double look_timeout_s = 15.0;
  int max_looks = 4;
  double ready_timeout_s = 60.0;
  double stop_timeout_s = 20.0;
  double max_odom_age_s = 1.0;
  SteerOptions steer;

  void DescribeOptions(OptionTable& table) {
    table.AddText("tour", tour, "path of a YAML file of way-points, as config/tours/visionlab.yaml",
                  OptionUse::kRequired);
    table.AddRule("tour", !tour.empty(), "a YAML file of way-points");
    table.AddChoice(
        "look", look,
        {{"image", TourLook::kImage}, {"frame", TourLook::kFrame}, {"nothing", TourLook::kNothing}},
        "for what it waits at a stop: a camera_info, its FrameEvent");
    table.AddNumber("look_timeout_s", look_timeout_s, 0.1, 3600.0, "then it stirs and looks again");
    table.AddNumber("max_looks", max_looks, 1, 100, "at a stop; then it goes on, to exit status 1");
    table.AddNumber("ready_timeout_s", ready_timeout_s, 0.1, 3600.0, "for odometry and a picture");
    table.AddNumber("stop_timeout_s", stop_timeout_s, 0.1, 3600.0,
                    "to reach one stop; then it looks from where it is");
    table.AddNumber("max_odom_age_s", max_odom_age_s, 0.1, 3600.0, "older: it stands and waits");
    table.AddGroup("steer", steer, "");
  }
};

// Reads the parameters and logs the effective ones; throws std::runtime_error naming the first that
// does not fit.
DriveTourOptions LoadDriveTourOptions(const YAML::Node& parameters);

}  // namespace rovio_sfm
