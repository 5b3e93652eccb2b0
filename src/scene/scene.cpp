#include "scene/scene.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

#include "document/paths.h"
#include "scene/body_catalogue.h"

namespace antumbra {
namespace {

void requireWithin(const Table& table, const char* key, Angle value, double low, double high) {
  double const found = value / degree;
  if (found < low || found > high)
    table.fail(key, fmt::format("found {:.10g} deg; allowed: {} to {} deg", found, low, high));
}

CameraPlacement readCamera(const Table& table) {
  CameraPlacement c;
  c.body = table.text("body", c.body);
  c.bodyWhere = table.where("body");
  c.heightWhere = table.where("height");
  c.targetWhere = table.where("target");
  c.latitude = table.angle("latitude");
  requireWithin(table, "latitude", c.latitude, -90.0, 90.0);
  c.longitude = table.angle("longitude");
  requireWithin(table, "longitude", c.longitude, -360.0, 360.0);
  c.height = table.length("height");
  c.target = table.text("target", "");
  if (!c.target.empty() && (table.has("azimuth") || table.has("altitude")))
    table.fail("target", "found together with azimuth or altitude; allowed: one or the other");
  if (c.target.empty()) {
    c.azimuth = table.angle("azimuth");
    c.altitude = table.angle("altitude");
    requireWithin(table, "altitude", c.altitude, -90.0, 90.0);
  }
  std::string const up =
      table.has("up") ? table.oneOf("up", {"zenith", "north", "azimuth"}) : "zenith";
  c.up = up == "zenith"  ? CameraPlacement::Up::Zenith
         : up == "north" ? CameraPlacement::Up::North
                         : CameraPlacement::Up::Azimuth;
  if (c.up == CameraPlacement::Up::Azimuth) c.upAzimuth = table.angle("up_azimuth");
  c.roll = table.angle("roll", Angle());
  c.tilt = table.angle("tilt", Angle());
  return c;
}

Projection readPicture(const Table& table) {
  Projection p;
  std::string const kind = table.oneOf("projection", {"perspective", "fisheye", "equirectangular"});
  p.kind = kind == "perspective" ? ProjectionKind::Perspective
           : kind == "fisheye"   ? ProjectionKind::Fisheye
                                 : ProjectionKind::Equirectangular;
  p.field = p.kind == ProjectionKind::Equirectangular ? table.angle("field", 360.0 * degree)
                                                      : table.angle("field");
  auto const size = [&](const char* key) {
    long const value = table.integer(key);
    if (value < 1 || value > 65536)
      table.fail(key, fmt::format("found {}; allowed: 1 to 65536 pixels", value));
    return static_cast<int>(value);
  };
  p.width = size("width");
  p.height = size("height");
  p.check(table.where("field"));
  return p;
}

DisplaySettings readDisplay(const Table& table) {
  DisplaySettings d;
  d.automaticExposure =
      !table.has("exposure") || table.oneOf("exposure", {"auto", "fixed"}) == "auto";
  if (!d.automaticExposure || table.has("white")) {
    d.whiteLuminance = table.number("white");
    if (!(d.whiteLuminance > 0.0))
      table.fail("white", "found a luminance that is not positive; allowed: above 0 cd/m2");
  }
  d.compensationStops = table.number("compensation", 0.0);
  d.limitingMagnitude = table.number("limiting_magnitude", d.limitingMagnitude);
  d.illustrative =
      table.has("look") && table.oneOf("look", {"natural", "illustrative"}) == "illustrative";
  d.eye = table.has("observer") && table.oneOf("observer", {"camera", "eye"}) == "eye";
  if (d.eye && !d.automaticExposure)
    table.fail("observer", "found \"eye\" with a fixed exposure; allowed: exposure = \"auto\"");
  if (table.has("brackets")) {
    d.bracketsStops = table.numbers("brackets");
    if (d.eye) table.fail("brackets", "an eye has none; allowed: with observer = \"camera\"");
    if (d.bracketsStops.empty() || d.bracketsStops.size() > 15)
      table.fail("brackets",
                 fmt::format("found {} of them; allowed: 1 to 15", d.bracketsStops.size()));
    for (double stops : d.bracketsStops)
      if (!(std::fabs(stops) <= 30.0))
        table.fail("brackets", fmt::format("found {}; allowed: -30 to 30 stops", stops));
  }
  return d;
}

Keyframe readKeyframe(const Table& table, const CameraPlacement& camera, Projection picture) {
  Keyframe k;
  k.frame = static_cast<int>(table.integer("frame"));
  if (table.has("height")) {
    k.height = table.length("height");
    if (!(k.height->si > 0.0))
      table.fail("height", "heights are interpolated geometrically; allowed: above 0 m");
  }
  auto const angle = [&](const char* key) {
    return table.has(key) ? std::optional(table.angle(key)) : std::nullopt;
  };
  k.latitude = angle("latitude");
  k.longitude = angle("longitude");
  k.azimuth = angle("azimuth");
  k.altitude = angle("altitude");
  k.field = angle("field");
  if (k.latitude) requireWithin(table, "latitude", *k.latitude, -90.0, 90.0);
  if (k.longitude) requireWithin(table, "longitude", *k.longitude, -360.0, 360.0);
  if (k.altitude) requireWithin(table, "altitude", *k.altitude, -90.0, 90.0);
  for (const char* key : {"azimuth", "altitude"})
    if (!camera.target.empty() && table.has(key))
      table.fail(key, "found together with [camera] target; allowed: one or the other");
  if (k.field) {
    picture.field = *k.field;
    picture.check(table.where("field"));
  }
  if (table.has("time_offset")) k.timeOffset = table.duration("time_offset");
  return k;
}

// Media in place of the bodies' own.
std::map<std::string, std::string> readAir(const Table& table) {
  std::set<std::string> media{"none"};
  for (auto const& entry : std::filesystem::directory_iterator(catalogsFolder() / "atmospheres"))
    if (entry.path().extension() == ".toml") media.insert(entry.path().stem().string());
  std::map<std::string, std::string> air;
  for (auto const& key : table.keys()) {
    Body const& body = BodyCatalogue::standard().body(key, table.where(key));
    if (body.kind == "star") table.fail(key, "a star has no such air; allowed: planets and moons");
    std::string const medium = table.oneOf(key, {media.begin(), media.end()});
    if (!air.emplace(body.name, medium == "none" ? "" : medium).second)
      table.fail(key, fmt::format("{} is named twice", body.name));
  }
  return air;
}

// Plain surfaces in place of the bodies' own.
std::map<std::string, double> readSurface(const Table& table) {
  std::map<std::string, double> surface;
  for (auto const& key : table.keys()) {
    Body const& body = BodyCatalogue::standard().body(key, table.where(key));
    if (body.kind == "star")
      table.fail(key, "a star has no lit surface; allowed: planets and moons");
    double const albedo = table.number(key);
    if (!(albedo >= 0.0 && albedo <= 1.0))
      table.fail(key, fmt::format("found {}; allowed: an albedo from 0 to 1", albedo));
    if (!surface.emplace(body.name, albedo).second)
      table.fail(key, fmt::format("{} is named twice", body.name));
  }
  return surface;
}

// Monotone cubic (Fritsch & Carlson 1980) through the keyframes that give a value: smooth, and
// never beyond the values it passes through.
std::optional<double> interpolate(const std::vector<std::pair<int, double>>& points, int frame) {
  std::size_t const n = points.size();
  if (n == 0) return std::nullopt;
  if (n == 1 || frame <= points.front().first) return points.front().second;
  if (frame >= points.back().first) return points.back().second;
  std::vector<double> step(n - 1), slope(n);
  for (std::size_t i = 0; i + 1 < n; ++i)
    step[i] = (points[i + 1].second - points[i].second) / (points[i + 1].first - points[i].first);
  slope.front() = step.front();
  slope.back() = step.back();
  for (std::size_t i = 1; i + 1 < n; ++i)
    slope[i] =
        step[i - 1] * step[i] <= 0.0 ? 0.0 : 2.0 * step[i - 1] * step[i] / (step[i - 1] + step[i]);
  std::size_t i = 0;
  while (points[i + 1].first < frame) ++i;
  double const h = points[i + 1].first - points[i].first;
  double const t = (frame - points[i].first) / h;
  double const a = points[i].second, b = points[i + 1].second;
  return a * (1 + 2 * t) * (1 - t) * (1 - t) + b * t * t * (3 - 2 * t) +
         h * (slope[i] * t * (1 - t) * (1 - t) - slope[i + 1] * t * t * (1 - t));
}

template <class Member, class ToNumber>
std::optional<double> valueAt(const std::vector<Keyframe>& keyframes, Member member, int frame,
                              ToNumber toNumber) {
  std::vector<std::pair<int, double>> points;
  for (const Keyframe& k : keyframes)
    if (k.*member) points.emplace_back(k.frame, toNumber(*(k.*member)));
  return interpolate(points, frame);
}

double siOf(Angle a) { return a.si; }

}  // namespace

Duration Scene::offsetAt(int frame) const {
  return Duration(valueAt(keyframes, &Keyframe::timeOffset, frame, [](Duration d) {
                    return d.si;
                  }).value_or(0.0));
}

Scene Scene::atFrame(int frame) const {
  Scene s = *this;
  s.keyframes.clear();
  s.frames = 1;
  if (auto const v =
          valueAt(keyframes, &Keyframe::height, frame, [](Length h) { return std::log(h.si); }))
    s.camera.height = Length(std::exp(*v));
  if (auto const v = valueAt(keyframes, &Keyframe::latitude, frame, siOf))
    s.camera.latitude = Angle(*v);
  if (auto const v = valueAt(keyframes, &Keyframe::longitude, frame, siOf))
    s.camera.longitude = Angle(*v);
  if (auto const v = valueAt(keyframes, &Keyframe::azimuth, frame, siOf))
    s.camera.azimuth = Angle(*v);
  if (auto const v = valueAt(keyframes, &Keyframe::altitude, frame, siOf))
    s.camera.altitude = Angle(*v);
  if (auto const v = valueAt(keyframes, &Keyframe::field, frame, siOf)) s.picture.field = Angle(*v);
  return s;
}

Scene readScene(const Table& table) {
  Scene s;
  s.file = table.file();
  s.title = table.text("title");
  s.time = table.text("time");
  s.timeWhere = table.where("time");
  if (table.has("bodies")) s.bodies = table.texts("bodies");
  s.quality = table.text("quality", s.quality);
  s.camera = readCamera(table.table("camera"));
  s.picture = readPicture(table.table("picture"));
  if (auto const display = table.tableIfPresent("display")) s.display = readDisplay(*display);
  if (auto const shadows = table.tableIfPresent("shadows")) {
    s.shadows.convention =
        shadows->has("convention") ? shadows->oneOf("convention", {"iau", "nasa"}) : "iau";
    s.shadows.limbDarkening =
        shadows->has("limb_darkening")
            ? shadows->oneOf("limb_darkening", {"hestroffer", "neckel", "none"})
            : "hestroffer";
  }
  if (auto const overlays = table.tableIfPresent("overlays")) s.overlays = readOverlays(*overlays);
  if (auto const air = table.tableIfPresent("air")) s.air = readAir(*air);
  if (auto const surface = table.tableIfPresent("surface")) s.surface = readSurface(*surface);
  if (auto const sun = table.tableIfPresent("sun")) s.sun = readSunSettings(*sun);
  if (auto const animation = table.tableIfPresent("animation")) {
    s.frames = static_cast<int>(animation->integer("frames"));
    if (s.frames < 1)
      animation->fail("frames", fmt::format("found {}; allowed: 1 or more", s.frames));
  }
  for (const Table& k : table.tables("keyframe")) {
    Keyframe const keyframe = readKeyframe(k, s.camera, s.picture);
    if (keyframe.frame < 0 || keyframe.frame >= s.frames)
      k.fail("frame", fmt::format("found {}; allowed: 0 to {}", keyframe.frame, s.frames - 1));
    if (!s.keyframes.empty() && keyframe.frame <= s.keyframes.back().frame)
      k.fail("frame", "keyframes must ascend");
    s.keyframes.push_back(keyframe);
  }
  table.finish();
  return s;
}

Scene readScene(const std::filesystem::path& file) {
  Document const document = Document::load(file);
  return readScene(document.root());
}

}  // namespace antumbra
