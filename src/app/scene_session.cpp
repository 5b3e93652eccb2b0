#include "app/scene_session.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <filesystem>
#include <set>

#include "document/document.h"
#include "document/paths.h"
#include "eclipse/contact_instant.h"

namespace antumbra {
namespace {

Duration givenDeltaT(const std::string& text) {
  double const seconds = parseNumber(text, "--delta-t");
  if (std::fabs(seconds) > 1e6)
    throw InputError(
        fmt::format("--delta-t: found {}; allowed: -1000000 to 1000000 seconds", text));
  return seconds * second;
}

// Presets are the files of configs/quality.
void requireQuality(const std::string& name, const std::string& where) {
  std::set<std::string> presets;
  for (auto const& entry : std::filesystem::directory_iterator(configsFolder() / "quality"))
    if (entry.path().extension() == ".toml") presets.insert(entry.path().stem().string());
  if (!presets.contains(name))
    throw InputError(
        fmt::format("{}: found \"{}\"; allowed: {}", where, name, fmt::join(presets, ", ")));
}

}  // namespace

void applySize(const std::string& text, const std::string& where, Projection& picture) {
  auto const cross = text.find('x');
  if (cross == std::string::npos)
    throw InputError(
        fmt::format("{}: found \"{}\"; allowed: WIDTHxHEIGHT, as 1280x720", where, text));
  long const width = parseInteger(text.substr(0, cross), where);
  long const height = parseInteger(text.substr(cross + 1), where);
  if (width < 1 || height < 1 || width > 65536 || height > 65536)
    throw InputError(
        fmt::format("{}: found {}x{}; allowed: 1x1 to 65536x65536", where, width, height));
  picture.width = static_cast<int>(width);
  picture.height = static_cast<int>(height);
}

SceneSession::SceneSession(const std::string& file, const SceneOverrides& o)
    : scene_(readScene(file)),
      deltaT_(o.deltaT.empty() ? DeltaT::standard() : DeltaT::fixed(givenDeltaT(o.deltaT))) {
  if (!o.time.empty()) {
    scene_.time = o.time;
    scene_.timeWhere = "--time";
  }
  if (!o.size.empty()) applySize(o.size, "--size", scene_.picture);
  if (!o.projection.empty()) {
    Projection& p = scene_.picture;
    ProjectionKind const before = p.kind;
    if (o.projection == "perspective")
      p.kind = ProjectionKind::Perspective;
    else if (o.projection == "fisheye")
      p.kind = ProjectionKind::Fisheye;
    else if (o.projection == "equirectangular")
      p.kind = ProjectionKind::Equirectangular;
    else
      throw InputError(
          fmt::format("--projection: found \"{}\"; allowed: perspective, fisheye, equirectangular",
                      o.projection));
    // A field that was meant for another projection says nothing about this one.
    if (p.kind != before) {
      p.field = p.kind == ProjectionKind::Perspective ? 60.0 * degree
                : p.kind == ProjectionKind::Fisheye   ? 180.0 * degree
                                                      : 360.0 * degree;
      for (auto& keyframe : scene_.keyframes) keyframe.field.reset();
    }
  }
  if (!o.quality.empty()) scene_.quality = o.quality;
  requireQuality(scene_.quality, o.quality.empty() ? scene_.file + ": quality" : "--quality");
  if (!o.look.empty()) {
    if (o.look != "natural" && o.look != "illustrative")
      throw InputError(fmt::format("--look: found \"{}\"; allowed: natural, illustrative", o.look));
    scene_.display.illustrative = o.look == "illustrative";
  }
  scene_.picture.check(o.size.empty() ? scene_.file + ": [picture]" : "--size");
  if (looksLikeContact(scene_.time)) {
    EclipseBasis basis;
    basis.convention = ShadowConvention::named(scene_.shadows.convention, scene_.file);
    if (!o.deltaT.empty()) basis.deltaT = givenDeltaT(o.deltaT);
    start_ = contactInstant(scene_.time, basis, scene_.timeWhere);
  } else {
    start_ = parseInstant(scene_.time, scene_.timeWhere, deltaT_);
  }
}

void SceneSession::follow(Duration offset, double rate) {
  if (!playback_) playback_ = std::make_shared<PlaybackEphemeris>(Ephemeris::standard());
  playback_->follow(start_ + offset, rate);
}

SceneSession::Moment SceneSession::at(int frame) const {
  return at(scene_.atFrame(frame), scene_.offsetAt(frame));
}

SceneSession::Moment SceneSession::at(const Scene& scene, Duration offset) const {
  Moment m;
  m.scene = scene;
  m.placed = placeScene(scene, start_ + offset, BodyCatalogue::standard(),
                        playback_ ? *playback_ : Ephemeris::standard(), deltaT_);
  m.plan = makeRenderPlan(scene, m.placed);
  return m;
}

std::vector<std::pair<std::string, std::string>> SceneSession::metadata(const Moment& m) const {
  const CameraPlacement& c = m.scene.camera;
  std::vector<std::pair<std::string, std::string>> list{
      {"antumbra:title", m.scene.title},
      {"antumbra:version", ANTUMBRA_VERSION},
      {"antumbra:time", formatIso(m.placed.when, TimeScale::Utc, deltaT_)},
      {"antumbra:delta_t",
       fmt::format("{:.3f} s ({})", m.placed.deltaT / second, m.placed.deltaTSource)},
      {"antumbra:site", fmt::format("{} {:.6f} deg {:.6f} deg east {:.3f} m", c.body,
                                    c.latitude / degree, c.longitude / degree, c.height / metre)},
      {"antumbra:projection",
       fmt::format("{} {:.4f} deg", nameOf(m.scene.picture.kind), m.scene.picture.field / degree)},
      {"antumbra:quality", m.scene.quality},
      {"antumbra:convention", fmt::format("{}, limb darkening {}", m.scene.shadows.convention,
                                          m.scene.shadows.limbDarkening)},
      {"antumbra:unit", "cd/m2 in linear sRGB channels (EXR)"},
  };
  if (!m.plan.sky.empty()) list.push_back({"antumbra:sky", m.plan.sky.front().why});
  return list;
}

}  // namespace antumbra
