#pragma once

#include <geometry_msgs/Pose.h>
#include <geometry_msgs/Transform.h>
#include <nav_msgs/Odometry.h>
#include <ros/time.h>
#include <rovio_sfm/CameraMsg.h>
#include <rovio_sfm/DriveIdMsg.h>
#include <rovio_sfm/FrameIdMsg.h>
#include <rovio_sfm/OdometrySampleMsg.h>
#include <sensor_msgs/CameraInfo.h>

#include <optional>
#include <string>

#include "rovio_sfm/geometry/camera.h"
#include "rovio_sfm/geometry/rigid3.h"
#include "rovio_sfm/scene/frame.h"
#include "rovio_sfm/scene/ids.h"

// The small types of the core as messages and back. What comes from a message is checked: nothing
// is returned for malformed content, and `error` names the field.
namespace rovio_sfm {

ros::Time ToTime(int64_t stamp_ns);  // stamps before 1970 or after 2106 become the nearest of these
int64_t ToNanoseconds(const ros::Time& time);

geometry_msgs::Transform ToTransform(const Rigid3& b_from_a);
geometry_msgs::Pose ToPose(const Rigid3& b_from_a);  // the pose of frame a in frame b

// Refuses numbers that are not finite and quaternions whose norm is off 1 by more than 1e-3.
std::optional<Rigid3> FromTransform(const geometry_msgs::Transform& message, std::string* error);

CameraMsg ToMessage(const Camera& camera);
std::optional<Camera> FromMessage(const CameraMsg& message, std::string* error);

// Refuses uncalibrated cameras (K of zeros), other distortion models than plumb_bob, and binning or
// regions of interest, which the core does not know.
std::optional<Camera> FromCameraInfo(const sensor_msgs::CameraInfo& message, std::string* error);
sensor_msgs::CameraInfo ToCameraInfo(const Camera& camera, int64_t stamp_ns,
                                     const std::string& frame_id);

OdometrySampleMsg ToMessage(const OdometrySample& sample);
std::optional<OdometrySample> FromMessage(const OdometrySampleMsg& message, std::string* error);

// odom_from_base of a planar sample, at height 0.
Rigid3 OdomFromBase(const OdometrySample& sample);

// The planar part of an odometry message: x, y and yaw with their covariance. Refuses numbers that
// are not finite; a negative variance means that the covariance is not known.
std::optional<OdometrySample> FromOdometry(const nav_msgs::Odometry& message, std::string* error);
nav_msgs::Odometry ToOdometry(const OdometrySample& sample, int64_t stamp_ns,
                              const std::string& odom_frame, const std::string& base_frame);

DriveIdMsg ToMessage(const DriveId& id);
std::optional<DriveId> FromMessage(const DriveIdMsg& message, std::string* error);
FrameIdMsg ToMessage(const FrameId& id);
std::optional<FrameId> FromMessage(const FrameIdMsg& message, std::string* error);

}  // namespace rovio_sfm
