#include "rovio_sfm/mapping/drive_mapper.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rovio_sfm/mapping/grow_map.h"
#include "rovio_sfm/mapping/link_tracks.h"
#include "rovio_sfm/mapping/make_keyframe.h"
#include "rovio_sfm/mapping/register_frame.h"
#include "rovio_sfm/mapping/seed_session.h"
#include "rovio_sfm/mapping/start_session.h"
#include "rovio_sfm/mapping/update_scale.h"
#include "rovio_sfm/mapping/weak_pose.h"
#include "rovio_sfm/util/degrees.h"

namespace rovio_sfm {
DriveMapper::DriveMapper(const MapperContext& context, DriveId drive, Camera camera)
    : context_(context),
      drive_(std::move(drive)),
      camera_(camera),
      global_(context.options, context.executor, context.timing) {
  OpenSession();
}

DriveMapper::DriveMapper(const MapperContext& context, const DriveRecord& record,
                         const std::function<FrameEvent(uint32_t)>& read_event)
    : context_(context),
      drive_(record.id),
      camera_(record.camera),
      global_(context.options, context.executor, context.timing),
      num_waited_(record.state.num_waited),
      num_weak_in_row_(record.state.num_weak_in_row),
      pending_links_(record.state.pending_links),
      next_index_(record.state.next_index),
      counters_(record.state.counters) {
  current_ = context_.sessions->FindNewest(drive_);
  if (current_ == nullptr) OpenSession();
  for (const uint32_t index : record.state.held) held_.push_back(read_event(index));
  for (const auto& weak : record.state.weak) {
    weak_.push_back({read_event(weak.index), weak.num_tries});
  }
  for (const uint32_t index : record.state.unposed) {
    unposed_.emplace(index, MakeLightFrame(read_event(index)));
  }
  if (current().state() == SessionState::kMapping && !current().keyframes().empty()) {
    last_pose_ = current().keyframes().rbegin()->second.cam_from_session;
  }
  settled_revision_ = current().revision();
}

DriveState DriveMapper::State() const {
  DriveState state;
  state.next_index = next_index_;
  for (const FrameEvent& event : held_) state.held.push_back(event.id.index);
  for (const WeakFrame& weak : weak_) state.weak.push_back({weak.event.id.index, weak.num_tries});
  for (const auto& [index, frame] : unposed_) state.unposed.push_back(index);
  state.pending_links = pending_links_;
  state.num_waited = num_waited_;
  state.num_weak_in_row = num_weak_in_row_;
  state.counters = counters_;
  return state;
}

MapperReport DriveMapper::Add(const FrameEvent& event) {
  Settle();
  MapperReport report;
  const auto reason = RefusalOf(event);
  if (!reason && current().state() == SessionState::kFinished) OpenSession();
  if (reason) {
    ++counters_.refused_events;
    report.outcome = MapperOutcome::kRefused;
    report.reason = *reason;
  } else if (event.kind == FrameKind::kLight) {
    context_.store->Put(event);
    report.outcome = AddLight(event);
  } else {
    context_.store->Put(event);
    pending_links_.insert(pending_links_.end(), event.links.begin(), event.links.end());
    if (current().state() == SessionState::kBootstrapping) {
      Hold(event, &report);
    } else {
      AddKeyframe(event, &report);
    }
  }
  report.session = current().id();
  settled_revision_ = current().revision();
  return report;
}

// What is being computed of the session is begun again where it was changed from outside (merged,
// undone).
void DriveMapper::Settle() {
  if (current().revision() == settled_revision_ || current().keyframes().empty()) return;
  global_.Restart(current());
  if (last_pose_) last_pose_ = current().keyframes().rbegin()->second.cam_from_session;
}

std::optional<std::string> DriveMapper::RefusalOf(const FrameEvent& event) {
  if (!(event.camera == camera_)) return "camera: expected that of the drive's first frame";
  if (next_index_ && event.id.index < *next_index_) {
    return "index " + std::to_string(event.id.index) + ": expected " +
           std::to_string(*next_index_) + " or more";
  }
  counters_.missing_events += next_index_ ? event.id.index - *next_index_ : 0;
  next_index_ = event.id.index + 1;
  return std::nullopt;
}

void DriveMapper::Hold(const FrameEvent& event, MapperReport* report) {
  const auto scope = MeasureStage(context_.times, "bootstrap");
  LinkTracks(context_.options.f2, &pending_links_, &current());
  held_.push_back(event);
  if (held_.size() > static_cast<size_t>(context_.options.bootstrap.max_held_frames)) {
    held_.pop_front();
  }
  BootstrapOptions bootstrap = context_.options.bootstrap;
  if (held_.size() >= static_cast<size_t>(bootstrap.hurry_after)) {
    bootstrap.min_angle_deg = bootstrap.hurried_angle_deg;
  }
  const auto pair = FindBootstrapPair(held_, current(), bootstrap, context_.options.seed);
  if (!pair) return;
  const double wished = Radians(context_.options.bootstrap.wished_angle_deg);
  const bool waits =
      pair->angle_rad < wished && ++num_waited_ < context_.options.bootstrap.patience;
  if (!waits && Start(*pair)) report->outcome = MapperOutcome::kKeyframe;
}

bool DriveMapper::Start(const BootstrapPair& pair) {
  const uint32_t first = held_[pair.first].id.index;
  if (!StartSession(pair, held_, context_.options, &current())) return false;
  EnterMap(first);
  return true;
}

bool DriveMapper::Seed(const std::vector<PlaceMatch>& matches) {
  if (current().state() != SessionState::kBootstrapping) return false;
  if (!SeedSession(held_, matches, *context_.sessions, context_.options, &current())) return false;
  EnterMap(current().keyframes().begin()->first);
  settled_revision_ = current().revision();
  return true;
}

// The session has its first frames: the other held ones follow, forward from the first, then back.
void DriveMapper::EnterMap(uint32_t first_index) {
  current().set_state(SessionState::kMapping);
  counters_.keyframes += current().keyframes().size();
  const std::deque<FrameEvent> held = std::exchange(held_, {});
  for (const FrameEvent& event : held) {
    if (event.id.index > first_index) InsertHeld(event);
  }
  for (auto event = held.rbegin(); event != held.rend(); ++event) {
    if (event->id.index < first_index) InsertHeld(*event);
  }
  AdjustFinally(context_.options, &current());
  last_pose_ = current().keyframes().rbegin()->second.cam_from_session;
  PoseWaitingLightFrames();
}

void DriveMapper::HoldAll(const std::vector<FrameEvent>& events) {
  for (const FrameEvent& event : events) {
    if (RefusalOf(event)) {
      ++counters_.refused_events;
    } else if (event.kind == FrameKind::kLight) {
      context_.store->Put(event);
      AddLight(event);
    } else {
      context_.store->Put(event);
      pending_links_.insert(pending_links_.end(), event.links.begin(), event.links.end());
      held_.push_back(event);
    }
  }
  LinkTracks(context_.options.f2, &pending_links_, &current());
}

bool DriveMapper::HoldsFrames(int min_count) const {
  return current_->state() == SessionState::kBootstrapping &&
         held_.size() >= static_cast<size_t>(min_count);
}

void DriveMapper::InsertHeld(const FrameEvent& event) {
  if (current().keyframes().count(event.id.index) != 0) return;
  const auto registration = RegisterKeyframe(event, context_.options, current());
  if (!registration) return;
  current().AddKeyframe(event.id.index,
                        MakeKeyframe(event, registration->cam_from_session, context_.options));
  GrowMap(event.id.index);
}

void DriveMapper::AddKeyframe(const FrameEvent& event, MapperReport* report) {
  const bool is_linked = IsLinked();
  if (is_linked) global_.Abandon();
  if (global_.Advance(&current(), context_.times)) ++counters_.global_adjustments;
  LinkTracks(context_.options.f2, &pending_links_, &current());
  const auto registration = Resect(event, report);
  if (!registration) return AddWeak(event, report);
  report->outcome = MapperOutcome::kKeyframe;
  current().AddKeyframe(event.id.index,
                        MakeKeyframe(event, registration->cam_from_session, context_.options));
  report->growth = GrowMap(event.id.index);
  RetryWeakFrames(context_.options.max_weak_tries);
  last_pose_ = current().keyframe(event.id.index).cam_from_session;
  UpdateScale(context_.options.scale, false, &current());
  if (!is_linked) global_.MaybeStart(current());
}

std::optional<Registration> DriveMapper::Resect(const FrameEvent& event, MapperReport* report) {
  const auto scope = MeasureStage(context_.times, "resect");
  const auto registration = RegisterKeyframe(event, context_.options, current());
  if (!registration) return std::nullopt;
  report->num_matches = registration->num_matches;
  report->num_inliers = registration->num_inliers;
  return registration;
}

MapGrowth DriveMapper::GrowMap(uint32_t frame) {
  ++counters_.keyframes;
  return rovio_sfm::GrowMap(frame, context_.options, *context_.store, context_.times, &current());
}

void DriveMapper::AddWeak(const FrameEvent& event, MapperReport* report) {
  ++counters_.weak_frames;
  weak_.push_back({event});
  const auto pose = PredictWeakPose(event, current());
  if (++num_weak_in_row_ > context_.options.max_weak_frames || !pose) return LoseSession(report);
  Keyframe frame = MakeKeyframe(event, *pose, context_.options);
  frame.weak = true;
  current().AddKeyframe(event.id.index, std::move(frame));
  report->outcome = MapperOutcome::kWeak;
}

// After a keyframe that is not weak: those that stay weak after max_tries of them are dropped.
void DriveMapper::RetryWeakFrames(int max_tries) {
  num_weak_in_row_ = 0;
  for (WeakFrame& weak : std::exchange(weak_, {})) {
    const uint32_t index = weak.event.id.index;
    if (ResectWeakFrame(index, context_.options, &current())) {
      GrowMap(index);
    } else if (++weak.num_tries < max_tries) {
      weak_.push_back(std::move(weak));
    } else {
      DropKeyframe(index);
    }
  }
}

void DriveMapper::DropKeyframe(uint32_t index) {
  if (current().keyframes().count(index) != 0) current().RemoveKeyframe(index);
}

// The weak frames at its end are the first of the next session.
void DriveMapper::LoseSession(MapperReport* report) {
  ++counters_.lost_sessions;
  std::vector<WeakFrame> weak = std::exchange(weak_, {});
  for (const WeakFrame& frame : weak) DropKeyframe(frame.event.id.index);
  weak.erase(weak.begin(), weak.end() - std::exchange(num_weak_in_row_, 0));
  CloseSession(SessionState::kLost);
  OpenSession();
  for (const WeakFrame& frame : weak) Hold(frame.event, report);
}

MapperOutcome DriveMapper::AddLight(const FrameEvent& event) {
  const auto scope = MeasureStage(context_.times, "light");
  ++counters_.light_frames;
  LightFrame frame = MakeLightFrame(event);
  const bool posed =
      current().state() == SessionState::kMapping &&
      PoseLightFrame(event.id.index, last_pose_, context_.options, &frame, current());
  if (!posed) {
    unposed_.emplace(event.id.index, std::move(frame));
    return MapperOutcome::kUnposed;
  }
  last_pose_ = frame.cam_from_reference * current().keyframe(frame.reference).cam_from_session;
  current().AddLightFrame(event.id.index, std::move(frame));
  return MapperOutcome::kLight;
}

void DriveMapper::PoseWaitingLightFrames() {
  for (auto it = unposed_.begin(); it != unposed_.end();) {
    const bool posed = PoseLightFrame(it->first, {}, context_.options, &it->second, current());
    if (posed) current().AddLightFrame(it->first, std::move(it->second));
    it = posed ? unposed_.erase(it) : std::next(it);
  }
}

void DriveMapper::OpenSession() {
  num_waited_ = 0;
  current_ = &context_.sessions->Open(drive_, camera_);
  global_ = GlobalAdjustment(context_.options, context_.executor, context_.timing);
}

void DriveMapper::CloseSession(SessionState state) {
  const auto scope = MeasureStage(context_.times, "adjust_finally");
  global_.Abandon();
  if (current().state() == SessionState::kMapping) {
    if (!IsLinked()) {
      AdjustWithCamera(context_.options, &current());
      RefineLightFrames(context_.options, &current());
    }
    PoseWaitingLightFrames();
    UpdateScale(context_.options.scale, true, &current());
    context_.on_session_closed(&current());
  }
  current().set_state(state);
  unposed_.clear();
  last_pose_.reset();
}

void DriveMapper::Finish() {
  Settle();
  if (current().state() == SessionState::kBootstrapping && !held_.empty()) {
    BootstrapOptions bootstrap = context_.options.bootstrap;
    bootstrap.min_angle_deg = bootstrap.hurried_angle_deg;
    const auto pair = FindBestBootstrapPair(held_, current(), bootstrap, context_.options.seed);
    if (pair) Start(*pair);
  }
  if (current().state() == SessionState::kMapping) RetryWeakFrames(0);
  CloseSession(SessionState::kFinished);
  held_.clear();
  settled_revision_ = current().revision();
}

}  // namespace rovio_sfm
