#include "plan/eclipse_at_hand.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <mutex>

namespace antumbra {
namespace {

constexpr std::size_t kKept = 8;

// Delta T as the user gave it; nothing where it is the table's, which belongs to each date.
std::optional<Duration> givenDeltaT(const PlacedScene& placed) {
  if (std::fabs((placed.deltaT - DeltaT::standard().at(placed.when)).si) < 1e-6)
    return std::nullopt;
  return placed.deltaT;
}

std::optional<std::string> idNear(const EclipseBasis& basis, Instant when) {
  std::optional<std::string> nearest;
  Duration least = 1.0 * day;
  for (auto const& eclipse : solarEclipses(basis, when - least, when + least)) {
    Duration const off((eclipse.greatest - when).si);
    Duration const apart(std::fabs(off.si));
    if (apart > least) continue;
    least = apart;
    nearest = eclipse.id;
  }
  return nearest;
}

EclipseCurves curvesOf(const SolarEvent& event, const ShadowRadii& radii,
                       const OverlaySettings& wanted) {
  EclipseCurves curves;
  if (wanted.contours())
    curves = eclipseCurves(event, radii);
  else
    curves.curves = centralCurves(event, radii);
  curves.marks.clear();
  if (wanted.timeMarks) curves.marks = timeMarks(event, radii, *wanted.timeMarks);
  return curves;
}

}  // namespace

std::shared_ptr<const EclipseAtHand> eclipseAtHand(const Scene& scene, const PlacedScene& placed) {
  static std::mutex mutex;
  static std::map<std::string, std::shared_ptr<const EclipseAtHand>> kept;
  EclipseBasis basis;
  basis.convention = ShadowConvention::named(scene.shadows.convention, scene.file);
  basis.deltaT = givenDeltaT(placed);
  auto const& wanted = scene.overlays;
  std::optional<std::string> const id =
      wanted.eclipse.empty() ? idNear(basis, placed.when) : std::optional(wanted.eclipse);
  if (!id) return nullptr;
  std::string const key = fmt::format("{} {} {} {} {}", *id, basis.convention.name,
                                      basis.deltaT ? basis.deltaT->si : NAN, wanted.contours(),
                                      wanted.timeMarks ? wanted.timeMarks->si : 0.0);
  std::lock_guard const lock(mutex);
  auto const found = kept.find(key);
  if (found != kept.end()) return found->second;
  SolarEvent event = solarEventOn(basis, *id, wanted.eclipseWhere);
  ShadowRadii const radii = basis.radii();
  EclipseCurves curves = curvesOf(event, radii, wanted);
  auto const made = std::make_shared<const EclipseAtHand>(
      EclipseAtHand{std::move(event), radii, std::move(curves)});
  if (kept.size() >= kKept) kept.clear();
  kept[key] = made;
  return made;
}

}  // namespace antumbra
