#include "plan/render_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "eclipse/shadow_convention.h"
#include "eclipse/shadow_pair.h"
#include "geodesy/site.h"
#include "photometry/magnitude.h"
#include "photometry/standard_spectra.h"
#include "plan/planned_passes.h"

namespace antumbra {
namespace {

// Air reaches no higher than this above any catalogued body's spheroid in units of its radius; only
// used to enlarge rectangles and cones, so generous. The highest, Titan's, ends at 0.195.
constexpr double kAirReach = 0.2;

Angle angularRadius(Length radius, Length distance) {
  if (distance <= radius) return Angle(std::numbers::pi);
  return Angle(std::asin(radius / distance));
}

bool overlapsPicture(const Projection& picture, Direction<CameraAxes> direction, Angle radius) {
  return !boundsOfCap(picture, direction, radius).empty();
}

// Phase angle at the body between Sun and observer.
Angle phaseAngle(const PlacedBody& b) { return angleBetween(b.sunFromBody, -b.fromCamera); }

// The body's medium, empty for none: the scene's choice, or its own.
const std::string& airOf(const Scene& scene, const Body& body) {
  auto const chosen = scene.air.find(body.name);
  return chosen == scene.air.end() ? body.atmosphere : chosen->second;
}

// What the corona sends past a caster: at the camera where it stands on the receiver, else on the
// shadow's axis.
std::string coronaPast(const CoronaLight& corona, const glsl::ShadowPair& pair,
                       const PlacedBody& receiver, bool camera) {
  glm::dvec3 const place = camera ? -receiver.bodyFromIcrs(receiver.fromCamera).m
                                  : glsl::fromCasterSpace(pair, pair.foot);
  double const share = corona.past(glsl::discsAt(pair, glsl::placeInShadow(pair, place)));
  double const au = astronomicalUnit / norm(receiver.sunFromBody);
  static double const solarLux = xyzOfRelativeRadiance([](Length) { return 1.0; }).y;
  return fmt::format("; past it the corona sends {:.2g} lx ({:.2g} of sunlight) to {}, without air",
                     share * solarLux * au * au, share, camera ? "the camera" : "the axis");
}

// Shadows that touch the receiver or its air.
std::vector<PlannedBody::Caster> liveCasters(const Scene& scene, const PlacedBody& receiver,
                                             const ShadowConvention& convention, bool camera,
                                             Instant when, RenderPlan& plan) {
  std::vector<PlannedBody::Caster> casters;
  Length const reach = (1.0 + kAirReach) * receiver.body->equatorialRadius;
  auto const sun = receiver.bodyFromIcrs(receiver.sunFromBody);
  for (auto const& neighbour : receiver.neighbours) {
    auto const centre = receiver.bodyFromIcrs(neighbour.fromBody);
    ShadowRadii const radii =
        convention.radiiOf(neighbour.body->name, neighbour.body->equatorialRadius);
    CasterFigure const figure{receiver.bodyFromIcrs(neighbour.pole).u,
                              neighbour.body->polarRadius / neighbour.body->equatorialRadius};
    auto const pair = shadowPair(sun, centre, radii, figure);
    if (!glsl::mayBeShaded(pair, glm::dvec3(0.0), reach.si)) continue;
    std::string const& air = airOf(scene, *neighbour.body);
    casters.push_back({neighbour.body->name, centre, radii, figure, air});
    if (!air.empty())
      plan.tables.push_back({air + ", light refracted",
                             fmt::format("the air of {} bends sunlight into its shadow on {}",
                                         neighbour.body->name, receiver.body->name)});
    // The illustrative look marks shadows in flat colours instead of lighting them.
    if (scene.sun.coronaLight && !scene.display.illustrative && !plan.coronaLight)
      plan.coronaLight = std::make_shared<CoronaLight>(
          scene.sun.activity.value_or(solarActivity(when)),
          parseLimbDarkeningLaw(scene.shadows.limbDarkening, scene.file + ": [shadows]"));
    plan.shadows.push_back(
        {fmt::format("{} on {}", neighbour.body->name, receiver.body->name),
         fmt::format(
             "its axis passes {:.0f} km from the centre, penumbra {:.0f} km wide{}",
             glm::length(pair.foot) / 1e3, 2.0 * pair.penumbraRadius / 1e3,
             plan.coronaLight ? coronaPast(*plan.coronaLight, pair, receiver, camera) : "")});
  }
  return casters;
}

// Geometric mean of the planetocentric latitudes of Sun and observer, 0 where their signs differ:
// what the magnitude of a ringed planet depends on.
Angle ringTilt(const PlacedBody& b) {
  double const sun = b.bodyFromIcrs(directionOf(b.sunFromBody)).u.z;
  double const eye = -b.bodyFromIcrs(directionOf(b.fromCamera)).u.z;
  if (sun * eye <= 0.0) return Angle();
  return Angle(std::sqrt(std::asin(std::fabs(sun)) * std::asin(std::fabs(eye))));
}

// Rings that are in the picture, or whose shadow on a globe in the picture is.
std::optional<PlannedBody::Rings> planRings(const PlacedBody& b, const PlannedBody& globe,
                                            Direction<CameraAxes> direction, Length distance,
                                            const ShadowConvention& convention, RenderPlan& plan) {
  RingSystem const& system = *b.body->rings;
  std::string const what = "rings of " + b.body->name;
  double const sun = directionOf(globe.sun).u.z;
  if (std::fabs(sun) < 1e-5) {
    plan.leftOut.push_back({what, "the Sun stands in their plane"});
    return std::nullopt;
  }
  PlannedBody::Rings rings;
  rings.system = system;
  rings.bounds = boundsOfCap(plan.picture, direction,
                             angularRadius(system.outer(), distance) + plan.picture.pixelAngle());
  rings.shadeGlobe = !globe.bounds.empty();
  rings.globe = convention.radiiOf(b.body->name, b.body->equatorialRadius);
  double const eye = -b.bodyFromIcrs(directionOf(b.fromCamera)).u.z;
  std::string const height =
      fmt::format("the Sun stands {:.1f} deg {} of their plane",
                  std::asin(std::fabs(sun)) / degree.si, sun > 0.0 ? "north" : "south");
  if (rings.bounds.empty()) {
    plan.leftOut.push_back({what, "outside the picture"});
  } else {
    plan.drawn.push_back(
        {what, fmt::format("{:.0f} to {:.0f} km in {} parts, the {} side is seen",
                           system.inner() / kilometre, system.outer() / kilometre,
                           system.parts.size(), sun * eye > 0.0 ? "lit" : "unlit")});
    plan.shadows.push_back({b.body->name + " on its rings", height + "; they are in the picture"});
  }
  if (rings.shadeGlobe)
    plan.shadows.push_back({"rings on " + b.body->name, height + "; the globe is in the picture"});
  if (rings.bounds.empty() && !rings.shadeGlobe) return std::nullopt;
  return rings;
}

// Whether a body smaller than the pixels must be drawn all the same: it stands before the Sun and
// takes more than a ten-thousandth of its light, which would dazzle in its stead.
bool coversSun(const PlacedScene& placed, const PlacedBody& body, const PlacedBody& sun) {
  Length const distance = norm(body.fromCamera), toSun = norm(sun.fromCamera);
  if (distance >= toSun) return false;
  Angle const disc = angularRadius(body.body->equatorialRadius, distance);
  Angle const sunDisc = angularRadius(sun.body->equatorialRadius, toSun);
  return disc > 0.01 * sunDisc &&
         angleBetween(directionOf(placed.cameraFromIcrs(body.fromCamera)),
                      directionOf(placed.cameraFromIcrs(sun.fromCamera))) < disc + sunDisc;
}

// Light of a body at a phase angle over that at full phase; beyond the span of its law as at the
// span's end.
double phaseLight(const Body& body, Angle phase) {
  Length const au = astronomicalUnit;
  if (body.magnitude.intervals.empty()) return 1.0;
  Angle const known = std::min(phase, body.magnitude.intervals.back().to);
  auto const full = body.magnitude.apparent(Angle(0.0), au, au);
  auto const here = body.magnitude.apparent(known, au, au);
  return full && here ? std::pow(10.0, -0.4 * (*here - *full)) : 1.0;
}

// The body whose reflected sunlight is brightest on another, where it reaches a millilux.
// To be honest: one source, a point, of the brightness it has toward the receiver's centre without
// shadows on it; bodies with air get none (their air would scatter it too).
void addPlanetshine(const PlacedScene& placed, const PlacedBody& receiver, PlannedBody& planned) {
  if (!planned.atmosphere.empty()) return;
  for (auto const& source : placed.bodies) {
    if (&source == &receiver || source.body->kind == "star") continue;
    auto const to = source.fromAnchor - receiver.fromAnchor;
    Angle const phase = angleBetween(source.sunFromBody, -to);
    auto const magnitude =
        source.body->magnitude.apparent(phase, norm(source.sunFromBody), norm(to));
    if (!magnitude) continue;
    double const lux = illuminanceLuxOfMagnitude(*magnitude);
    if (lux < 1e-3 || lux <= planned.shineLux) continue;
    planned.shineLux = lux;
    planned.shineFrom = source.body->name;
    planned.shineDirection = receiver.bodyFromIcrs(directionOf(to));
  }
}

// The options with which `antumbra sky` gives the light of the camera's own body and its air.
void addSkyOptions(const Scene& scene, const PlacedScene& placed, RenderPlan& plan) {
  PlacedBody const& anchor = placed.bodies[placed.anchor];
  std::string const& medium = airOf(scene, *anchor.body);
  if (medium.empty()) return;
  auto const sun = horizontalFromEnu(placed.enuFromIcrs(directionOf(anchor.sunFromBody)));
  plan.sky.push_back(
      {"antumbra sky",
       fmt::format(
           "--medium catalogs/atmospheres/{}.toml --body {} --latitude {:.9g} "
           "--altitude-km {:.9g} --sun-zenith {:.7f} --sun-azimuth {:.7f} "
           "--sun-distance-au {:.9f} --sun disc --limb-darkening {} --method {} --luminance",
           medium, anchor.body->name, scene.camera.latitude / degree,
           scene.camera.height / kilometre, 90.0 - sun.altitude / degree, sun.azimuth / degree,
           norm(anchor.sunFromBody) / astronomicalUnit, scene.shadows.limbDarkening,
           scene.quality)});
  for (auto const& body : plan.bodies)
    if (body.name == anchor.body->name && !body.casters.empty())
      plan.sky.push_back(
          {"", fmt::format("without {}, which eclipses the Sun", body.casters.front().name)});
}

}  // namespace

RenderPlan makeRenderPlan(const Scene& scene, const PlacedScene& placed) {
  RenderPlan plan;
  plan.picture = scene.picture;
  const Projection& picture = scene.picture;
  ShadowConvention const convention = ShadowConvention::named(scene.shadows.convention, scene.file);
  const PlacedBody* sun = nullptr;
  for (auto const& b : placed.bodies)
    if (b.body->kind == "star") sun = &b;

  std::vector<std::pair<Length, PlannedBody>> discs;
  for (std::size_t i = 0; i < placed.bodies.size(); ++i) {
    const PlacedBody& b = placed.bodies[i];
    auto const inCamera = placed.cameraFromIcrs(b.fromCamera);
    Length const distance = norm(inCamera);
    auto const direction = directionOf(inCamera);
    Angle const radius = angularRadius(b.body->equatorialRadius, distance);
    double const diameter = 2.0 * (radius / picture.pixelAngle());
    if (&b == sun) {
      plan.sun.direction = direction;
      plan.sun.angularRadius = angularRadius(convention.sunRadius, distance);
      plan.sun.distance = distance;
      plan.sun.radius = convention.sunRadius;
      plan.sun.north =
          (placed.cameraFromIcrs * b.bodyFromIcrs.inverse())(Direction<BodyFixed>{{0, 0, 1}});
      plan.sun.bounds = boundsOfCap(picture, direction, radius);
      plan.sun.inPicture = !plan.sun.bounds.empty();
      continue;
    }
    bool const isAnchor = i == placed.anchor;
    bool const beforeSun = sun && coversSun(placed, b, *sun);
    if (beforeSun) {
      ShadowRadii const radii = convention.radiiOf(b.body->name, b.body->equatorialRadius);
      plan.sunCoverers.push_back(
          {inCamera,
           (placed.cameraFromIcrs * b.bodyFromIcrs.inverse())(Direction<BodyFixed>{{0, 0, 1}}),
           radii.casterUmbra,
           b.body->polarRadius * (radii.casterUmbra / b.body->equatorialRadius)});
    }
    if (diameter < kPointPixels && !isAnchor && !beforeSun) {
      if (!overlapsPicture(picture, direction, picture.pixelAngle())) {
        plan.leftOut.push_back({b.body->name, "outside the picture"});
        continue;
      }
      auto const magnitude =
          b.body->magnitude.apparent(phaseAngle(b), norm(b.sunFromBody), distance, ringTilt(b));
      if (!magnitude) {
        plan.leftOut.push_back(
            {b.body->name,
             fmt::format("a point ({}), and no magnitude is published at a phase angle "
                         "of {:.1f} deg",
                         sizeInPixels(diameter), phaseAngle(b) / degree)});
        continue;
      }
      plan.points.push_back(
          {b.body->name, direction, illuminanceLuxOfMagnitude(*magnitude), b.body->colorIndexBv});
      plan.drawn.push_back(
          {b.body->name, fmt::format("a point of V {:.2f}: its disc is {}, below {} px", *magnitude,
                                     sizeInPixels(diameter), kPointPixels)});
      continue;
    }
    PlannedBody p;
    p.name = b.body->name;
    p.centre = inCamera;
    p.bodyFromCamera = b.bodyFromIcrs * placed.cameraFromIcrs.inverse();
    // The silhouette that hides the Sun is the one whose shadow is predicted; the camera's own
    // body keeps the radius above which its height counts.
    ShadowRadii const silhouette = convention.radiiOf(b.body->name, b.body->equatorialRadius);
    double const drawn = isAnchor ? 1.0 : silhouette.casterUmbra / b.body->equatorialRadius;
    p.equatorialRadius = b.body->equatorialRadius * drawn;
    p.polarRadius = b.body->polarRadius * drawn;
    p.sun = b.bodyFromIcrs(b.sunFromBody);
    p.angularRadius = radius;
    p.diameterPixels = diameter;
    p.atmosphere = airOf(scene, *b.body);
    Length const reach = (p.atmosphere.empty() ? 1.0 : 1.0 + kAirReach) * b.body->equatorialRadius;
    Angle const capRadius = angularRadius(reach, distance);
    // Half a pixel more, for the antialiased limb.
    p.bounds = boundsOfCap(picture, direction, capRadius + picture.pixelAngle());
    if (b.body->rings) p.rings = planRings(b, p, direction, distance, convention, plan);
    if (p.bounds.empty() && !p.rings) {
      plan.leftOut.push_back({b.body->name, "outside the picture"});
      continue;
    }
    // The camera in the space in which the body is a sphere: axes stretched along the pole.
    glm::dvec3 const offset = -b.bodyFromIcrs(b.fromCamera).m;
    double const a = b.body->equatorialRadius.si, c = b.body->polarRadius.si;
    glm::dvec3 const scaled{offset.x, offset.y, offset.z * (a / c)};
    p.cameraHeight = Length(glm::length(scaled) - a);
    p.cameraInAir = !p.atmosphere.empty() && p.cameraHeight.si < kAirReach * a;
    p.map = b.body->surface.map;
    p.albedo = b.body->surface.reflectance;
    p.waterMask = b.body->surface.waterMask;
    p.nightMap = b.body->surface.nightMap;
    p.nightLuminance = b.body->surface.nightLuminance;
    if (b.body->surface.mapMean) p.mapFactor = p.albedo / *b.body->surface.mapMean;
    p.lommelSeeliger = b.body->surface.scattering == Surface::Scattering::LommelSeeliger;
    if (auto const plain = scene.surface.find(b.body->name); plain != scene.surface.end()) {
      p.map = p.waterMask = p.nightMap = "";
      p.albedo = glm::vec3(static_cast<float>(plain->second));
      p.mapFactor = glm::vec3(1.0f);
      p.nightLuminance = 0.0;
      p.lommelSeeliger = false;
    }
    p.casters = liveCasters(scene, b, convention, isAnchor, placed.when, plan);
    p.phaseLight = phaseLight(*b.body, phaseAngle(b));
    addPlanetshine(placed, b, p);
    if (p.shineLux > 0.0)
      plan.drawn.push_back({b.body->name, fmt::format("also lit by {}, {:.3g} lx at most",
                                                      p.shineFrom, p.shineLux)});
    plan.drawn.push_back(
        {b.body->name,
         isAnchor ? fmt::format("the camera is {:.3f} km above it", p.cameraHeight / kilometre)
                  : fmt::format("a disc of {}", sizeInPixels(diameter))});
    discs.emplace_back(distance, p);
  }
  std::sort(discs.begin(), discs.end(),
            [](auto const& x, auto const& y) { return x.first > y.first; });
  for (auto& [distance, p] : discs) plan.bodies.push_back(std::move(p));

  // The Sun is wholly hidden only where it and its corona lie behind one body's spheroid (its polar
  // radius is the safe one).
  for (auto const& b : plan.bodies) {
    Length const distance = norm(b.centre);
    if (distance >= plan.sun.distance) continue;
    Angle const disc = angularRadius(b.polarRadius, distance);
    if (angleBetween(directionOf(b.centre), plan.sun.direction) +
            glsl::kCoronaEnd * plan.sun.angularRadius <
        disc) {
      plan.sun.hiddenByBody = true;
      plan.sun.hiddenBy = b.name;
    }
  }
  bool const nearPicture =
      overlapsPicture(picture, plan.sun.direction, glsl::kCoronaEnd * plan.sun.angularRadius);
  bool const shown = scene.sun.drawn;
  plan.drawSun = shown && nearPicture && !plan.sun.hiddenByBody;
  if (plan.drawSun)
    plan.drawn.push_back({sun->body->name, plan.sun.inPicture
                                               ? "its disc is in the picture"
                                               : "its corona reaches into the picture"});
  plan.queryOcclusion = plan.drawSun && plan.sun.inPicture && !scene.display.illustrative;
  plan.glareFromOutside =
      shown && !plan.sun.inPicture && !plan.sun.hiddenByBody && !scene.display.illustrative &&
      angleBetween(plan.sun.direction, Direction<CameraAxes>{{0, 0, -1}}) < 90.0 * degree;

  addSkyOptions(scene, placed, plan);

  std::set<std::string> media;
  for (auto const& b : plan.bodies) {
    if (b.atmosphere.empty() || !media.insert(b.atmosphere).second) continue;
    plan.tables.push_back({b.atmosphere, b.cameraInAir
                                             ? "the camera is inside the air of " + b.name
                                             : "the air of " + b.name + " is seen from outside"});
  }
  if (plan.tables.empty())
    plan.leftOut.push_back({"atmosphere tables", "no body drawn as a disc has air"});

  planPasses(scene, placed.when, plan);
  plan.overlays = planOverlays(scene, placed, plan.bodies);
  plan.passes.insert(plan.passes.end(), plan.overlays.passes.begin(), plan.overlays.passes.end());
  plan.leftOut.insert(plan.leftOut.end(), plan.overlays.leftOut.begin(),
                      plan.overlays.leftOut.end());
  if (plan.shadows.empty())
    plan.leftOut.push_back({"shadow pairs", "no body's penumbra reaches a body drawn as a disc"});
  bool const anyCaster = std::any_of(plan.bodies.begin(), plan.bodies.end(),
                                     [](const PlannedBody& b) { return !b.casters.empty(); });
  if (anyCaster && !plan.coronaLight)
    plan.leftOut.push_back({"corona's light", scene.display.illustrative
                                                  ? "the illustrative look has none"
                                                  : "the scene says corona_light = false"});
  return plan;
}

void RenderPlan::rescaleBounds(const Projection& before) {
  double const factor = double(picture.width) / before.width;
  auto const rescale = [&](PixelBounds& b) {
    b = {std::max(0, static_cast<int>(std::floor(b.x0 * factor)) - 1),
         std::max(0, static_cast<int>(std::floor(b.y0 * factor)) - 1),
         std::min(picture.width, static_cast<int>(std::ceil(b.x1 * factor)) + 1),
         std::min(picture.height, static_cast<int>(std::ceil(b.y1 * factor)) + 1)};
  };
  rescale(sun.bounds);
  for (auto& body : bodies) {
    rescale(body.bounds);
    if (body.rings && !body.rings->bounds.empty()) rescale(body.rings->bounds);
    body.diameterPixels *= factor;
  }
}

}  // namespace antumbra
