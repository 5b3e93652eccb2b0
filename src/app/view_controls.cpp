#include "app/view_controls.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace antumbra {
namespace {

constexpr double kRates[] = {1, 5, 10, 30, 60, 300, 600, 3600, 6 * 3600, 86400, 10 * 86400};
constexpr int kFastest = static_cast<int>(std::size(kRates));

}  // namespace

ViewControls::ViewControls(const Scene& scene) : scene_(scene.atFrame(0)) {}

void ViewControls::togglePause() { paused_ = !paused_; }

double ViewControls::rate() const {
  double const magnitude = kRates[std::abs(rateStep_) - 1];
  return rateStep_ < 0 ? -magnitude : magnitude;
}

void ViewControls::step(int direction) { offset_ += Duration(direction * std::fabs(rate())); }

void ViewControls::changeRate(int direction) {
  int next = rateStep_ + direction;
  if (next == 0) next += direction;  // from forwards to backwards
  rateStep_ = std::clamp(next, -kFastest, kFastest);
}

void ViewControls::lookFrom(Angle azimuth, Angle altitude) {
  scene_.camera.target.clear();
  scene_.camera.azimuth = azimuth;
  scene_.camera.altitude = altitude;
}

void ViewControls::drag(double dx, double dy) {
  Angle const pixel = scene_.picture.pixelAngle();
  CameraPlacement& c = scene_.camera;
  Angle const limit = 89.9 * degree;
  double const foreshortening = std::max(cos(c.altitude), 0.05);
  c.azimuth =
      Angle(std::remainder((c.azimuth - (dx / foreshortening) * pixel).si, (360.0 * degree).si));
  c.altitude = std::clamp(c.altitude + dy * pixel, -limit, limit);
}

void ViewControls::zoom(double steps) {
  Projection& p = scene_.picture;
  if (p.kind == ProjectionKind::Equirectangular) return;
  Angle const widest = p.kind == ProjectionKind::Fisheye ? 360.0 * degree : 150.0 * degree;
  p.field = std::clamp(p.field * std::pow(0.9, steps), 0.01 * degree, widest);
}

void ViewControls::resize(int width, int height) {
  scene_.picture.width = width;
  scene_.picture.height = height;
}

void ViewControls::advance(Duration wall) {
  if (!paused_) offset_ += rate() * wall;
}

Scene ViewControls::scene() const { return scene_; }

std::string ViewControls::status() const {
  return fmt::format("{} {:g} s/s, field {:.2f} deg", paused_ ? "paused," : "", rate(),
                     scene_.picture.field / degree);
}

}  // namespace antumbra
