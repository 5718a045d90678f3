#include "rovio_sfm/sim/world/ray_scene.h"

#include <embree3/rtcore.h>

#include <limits>

#include "rovio_sfm/util/check.h"

namespace rovio_sfm::sim {
namespace {

constexpr float kSkip_m = 1e-3f;  // a ray leaves its own surface behind

void CopyCorners(const std::vector<Surface>& surfaces, RTCGeometry geometry) {
  const size_t count = surfaces.size();
  auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), 4 * count));
  auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
      geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT4, 4 * sizeof(unsigned), count));
  ROVIO_CHECK(vertices != nullptr && indices != nullptr);
  for (size_t i = 0; i < 4 * count; ++i) {
    const Eigen::Vector3f& corner = surfaces[i / 4].corners[i % 4];
    for (int axis = 0; axis < 3; ++axis) vertices[3 * i + static_cast<size_t>(axis)] = corner[axis];
    indices[i] = static_cast<unsigned>(i);
  }
}

RTCRay MakeRay(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction, float near,
               float far) {
  RTCRay ray{};
  ray.org_x = origin.x();
  ray.org_y = origin.y();
  ray.org_z = origin.z();
  ray.dir_x = direction.x();
  ray.dir_y = direction.y();
  ray.dir_z = direction.z();
  ray.tnear = near;
  ray.tfar = far;
  ray.mask = ~0u;
  return ray;
}

void FillPacket(const RayPacket& rays, RTCRayHit8* packet) {
  for (int i = 0; i < RayPacket::kSize; ++i) {
    packet->ray.org_x[i] = rays.origins[i].x();
    packet->ray.org_y[i] = rays.origins[i].y();
    packet->ray.org_z[i] = rays.origins[i].z();
    packet->ray.dir_x[i] = rays.directions[i].x();
    packet->ray.dir_y[i] = rays.directions[i].y();
    packet->ray.dir_z[i] = rays.directions[i].z();
    packet->ray.tnear[i] = kSkip_m;
    packet->ray.tfar[i] = std::numeric_limits<float>::infinity();
    packet->ray.time[i] = 0.0f;
    packet->ray.mask[i] = ~0u;
    packet->ray.flags[i] = 0;
    packet->hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
    packet->hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
  }
}

}  // namespace

struct RayScene::Handles {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  ~Handles() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

RayScene::RayScene(const std::vector<Surface>& surfaces) : handles_(new Handles) {
  handles_->device = rtcNewDevice("threads=1");  // building only; tracing is the caller's thread
  ROVIO_CHECK(handles_->device != nullptr);
  handles_->scene = rtcNewScene(handles_->device);
  RTCGeometry geometry = rtcNewGeometry(handles_->device, RTC_GEOMETRY_TYPE_QUAD);
  CopyCorners(surfaces, geometry);
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(handles_->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcSetSceneFlags(handles_->scene, RTC_SCENE_FLAG_ROBUST);
  rtcSetSceneBuildQuality(handles_->scene, RTC_BUILD_QUALITY_HIGH);
  rtcCommitScene(handles_->scene);
}

RayScene::~RayScene() = default;

RayHit RayScene::Trace(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction) const {
  RTCRayHit query{};
  query.ray = MakeRay(origin, direction, kSkip_m, std::numeric_limits<float>::infinity());
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(handles_->scene, &context, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
  return {static_cast<int>(query.hit.primID), query.ray.tfar, query.hit.u, query.hit.v};
}

void RayScene::Trace(const RayPacket& rays, RayHit* hits) const {
  alignas(32) const int valid[RayPacket::kSize] = {-1, -1, -1, -1, -1, -1, -1, -1};
  RTCRayHit8 packet;
  FillPacket(rays, &packet);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  rtcIntersect8(valid, handles_->scene, &context, &packet);
  for (int i = 0; i < RayPacket::kSize; ++i) {
    hits[i] = {};
    if (packet.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID) continue;
    hits[i] = {static_cast<int>(packet.hit.primID[i]), packet.ray.tfar[i], packet.hit.u[i],
               packet.hit.v[i]};
  }
}

bool RayScene::IsBlocked(const Eigen::Vector3f& from, const Eigen::Vector3f& to) const {
  const Eigen::Vector3f way = to - from;
  const float distance = way.norm();
  return distance > 2 * kSkip_m && IsBlocked(from, way / distance, distance - kSkip_m);
}

bool RayScene::IsBlocked(const Eigen::Vector3f& from, const Eigen::Vector3f& direction,
                         float reach_m) const {
  RTCRay ray = MakeRay(from, direction, kSkip_m, reach_m);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded1(handles_->scene, &context, &ray);
  return ray.tfar < 0.0f;
}

}  // namespace rovio_sfm::sim
