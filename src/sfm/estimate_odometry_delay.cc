#include "rovio_sfm/sfm/estimate_odometry_delay.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "rovio_sfm/util/median.h"

namespace rovio_sfm {
namespace {

constexpr double kMaxDelayS = 0.4;  // longer ones are not looked for
constexpr double kScanStepS = 0.01;
constexpr double kWindowS = 0.3;          // least time over which a rate is measured
constexpr double kMaxGapS = 1.0;          // and the longest: turns within it would cancel
constexpr double kMinTurnRad = 1.0;       // all turns together; less is noise of the vision
constexpr double kMinCorrelation = 0.8;   // of the rates; below, the wheels tell something else
constexpr double kMaxSigmaS = 0.05;       // a less certain delay is none
constexpr int kMinRates = 20;             // for a correlation that is not chance
constexpr double kLeastCurvature = 1e-4;  // of the correlation's peak: flatter ones tell nothing

// Mean turn rates between two frames, at the middle of their stamps.
struct TurnRate {
  double time_s = 0.0;
  double duration_s = 0.0;
  double visual_rad_s = 0.0;
  double odometry_rad_s = 0.0;
};

// The rates of wheels and vision at moments where both are known, vision's delayed.
struct Paired {
  double sum_squared_odometry = 0.0, sum_squared_visual = 0.0, sum_product = 0.0;
  int count = 0;

  void Add(double odometry, double visual) {
    sum_squared_odometry += odometry * odometry;
    sum_squared_visual += visual * visual;
    sum_product += odometry * visual;
    ++count;
  }
  double Correlation() const {
    const double norm = std::sqrt(sum_squared_odometry * sum_squared_visual);
    return norm > 0.0 ? sum_product / norm : 0.0;
  }
  double Gain() const { return sum_squared_visual > 0.0 ? sum_product / sum_squared_visual : 0.0; }
};

double YawOf(const Eigen::Quaterniond& rotation) {
  const Eigen::Vector3d forward = rotation * Eigen::Vector3d::UnitX();
  return std::atan2(forward.y(), forward.x());
}

TurnRate RateBetween(const TurnSample& a, const TurnSample& b, int64_t zero_ns) {
  const double begin_s = 1e-9 * static_cast<double>(a.stamp_ns - zero_ns);
  const double duration_s = 1e-9 * static_cast<double>(b.stamp_ns - a.stamp_ns);
  const double visual_rad = YawOf(a.map_from_base.conjugate() * b.map_from_base);
  const double odometry_rad = std::remainder(b.odom_yaw_rad - a.odom_yaw_rad, 2.0 * M_PI);
  return {begin_s + 0.5 * duration_s, duration_s, visual_rad / duration_s,
          odometry_rad / duration_s};
}

// One rate from each frame on; windows overlap.
std::vector<TurnRate> RatesOf(const std::vector<TurnSample>& samples) {
  const auto gap_s = [&](size_t i, size_t j) {
    return 1e-9 * static_cast<double>(samples[j].stamp_ns - samples[i].stamp_ns);
  };
  std::vector<TurnRate> rates;
  for (size_t i = 0; i + 1 < samples.size(); ++i) {
    size_t j = i + 1;
    while (j + 1 < samples.size() && gap_s(i, j) < kWindowS) ++j;
    if (gap_s(i, j) < kWindowS || gap_s(i, j) > kMaxGapS) continue;
    rates.push_back(RateBetween(samples[i], samples[j], samples[0].stamp_ns));
  }
  return rates;
}

// Vision's rate at a moment, linear between the middles of frames; nothing across a long gap.
std::optional<double> VisualRate(const std::vector<TurnRate>& rates, double time_s) {
  const auto after = std::lower_bound(rates.begin(), rates.end(), time_s,
                                      [](const TurnRate& r, double t) { return r.time_s < t; });
  if (after == rates.begin() || after == rates.end()) return std::nullopt;
  const auto before = std::prev(after);
  const double gap_s = after->time_s - before->time_s;
  if (gap_s > kMaxGapS) return std::nullopt;
  const double share = (time_s - before->time_s) / gap_s;
  return (1.0 - share) * before->visual_rad_s + share * after->visual_rad_s;
}

Paired PairAt(const std::vector<TurnRate>& rates, double delay_s) {
  Paired paired;
  for (const TurnRate& rate : rates) {
    const auto visual = VisualRate(rates, rate.time_s - delay_s);
    if (visual) paired.Add(rate.odometry_rad_s, *visual);
  }
  return paired;
}

double MedianDuration(const std::vector<TurnRate>& rates) {
  std::vector<double> durations;
  for (const TurnRate& rate : rates) durations.push_back(rate.duration_s);
  return Median(std::move(durations));
}

// The scanned delay of the greatest correlation; nothing where it lies at the border.
std::optional<double> ScanDelays(const std::vector<TurnRate>& rates) {
  const int steps = static_cast<int>(kMaxDelayS / kScanStepS);
  int best = -steps;
  double best_correlation = -1.0;
  for (int i = -steps; i <= steps; ++i) {
    const double correlation = PairAt(rates, i * kScanStepS).Correlation();
    if (correlation <= best_correlation) continue;
    best = i;
    best_correlation = correlation;
  }
  if (std::abs(best) == steps) return std::nullopt;
  return best * kScanStepS;
}

// The peak of the parabola through the correlations at the delay and half a frame beside it.
std::optional<double> RefinePeak(const std::vector<TurnRate>& rates, double delay_s) {
  const double step_s = std::max(kScanStepS, 0.5 * MedianDuration(rates));
  const double left = PairAt(rates, delay_s - step_s).Correlation();
  const double middle = PairAt(rates, delay_s).Correlation();
  const double right = PairAt(rates, delay_s + step_s).Correlation();
  const double curvature = left - 2.0 * middle + right;
  if (!(curvature < -kLeastCurvature)) return std::nullopt;
  const double shift = 0.5 * (left - right) / curvature;
  if (std::abs(shift) > 1.0) return std::nullopt;
  return delay_s + shift * step_s;
}

// From the rates' disagreement, and how fast vision's rate changes; rates of windows that overlap
// are not independent.
double SigmaAt(const std::vector<TurnRate>& rates, double delay_s, const Paired& paired) {
  const double step_s = 0.5 * MedianDuration(rates);
  double sum_residuals = 0.0, sum_slopes = 0.0, covered_s = 0.0;
  for (const TurnRate& rate : rates) {
    const auto at = VisualRate(rates, rate.time_s - delay_s);
    const auto before = VisualRate(rates, rate.time_s - delay_s - step_s);
    const auto after = VisualRate(rates, rate.time_s - delay_s + step_s);
    if (!at || !before || !after) continue;
    covered_s += rate.duration_s;
    sum_residuals += std::pow(rate.odometry_rad_s - paired.Gain() * *at, 2);
    sum_slopes += std::pow(paired.Gain() * (*after - *before) / (2.0 * step_s), 2);
  }
  const double overlap = std::max(1.0, covered_s / (rates.back().time_s - rates.front().time_s));
  return std::sqrt(overlap * sum_residuals / (paired.count - 2) / sum_slopes);
}

double TotalTurn(const std::vector<TurnRate>& rates) {
  double turn_rad = 0.0;
  for (const TurnRate& rate : rates) turn_rad += std::abs(rate.visual_rad_s) * rate.duration_s;
  return turn_rad;
}

}  // namespace

std::optional<OdometryDelay> EstimateOdometryDelay(const std::vector<TurnSample>& samples) {
  const std::vector<TurnRate> rates = RatesOf(samples);
  if (rates.size() < static_cast<size_t>(kMinRates)) return std::nullopt;
  if (TotalTurn(rates) < kMinTurnRad) return std::nullopt;
  const auto scanned_s = ScanDelays(rates);
  if (!scanned_s) return std::nullopt;
  const auto delay_s = RefinePeak(rates, *scanned_s);
  if (!delay_s) return std::nullopt;
  const Paired paired = PairAt(rates, *delay_s);
  if (paired.count < kMinRates) return std::nullopt;
  if (paired.Correlation() < kMinCorrelation) return std::nullopt;
  const double sigma_s = SigmaAt(rates, *delay_s, paired);
  if (!(sigma_s <= kMaxSigmaS)) return std::nullopt;
  return OdometryDelay{*delay_s, sigma_s};
}

}  // namespace rovio_sfm
