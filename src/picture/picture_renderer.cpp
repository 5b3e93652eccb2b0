#include "picture/picture_renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "document/input_error.h"
#include "document/paths.h"
#include "eclipse/limb_darkening.h"
#include "gl/buffer.h"
#include "gl/context.h"
#include "gl/framebuffer.h"
#include "gl/texture.h"
#include "gl/view_block.h"
#include "passes/bodies.h"
#include "passes/cone_pass.h"
#include "passes/corona.h"
#include "passes/drawing_pass.h"
#include "passes/glare.h"
#include "passes/stars.h"
#include "passes/sun.h"
#include "passes/sun_occlusion.h"
#include "photometry/colour.h"
#include "photometry/naked_eye.h"
#include "picture/sunlight.h"
#include "scene/apparent_stars.h"
#include "scene/star_catalogue.h"
#include "tonemap/tone_map.h"

namespace antumbra {
namespace {

constexpr double kMostPixels = 268435456.0;  // 2^28: 16384 x 16384
constexpr int kLargestTile = 4096;           // 256 MiB of 32-bit floats
constexpr int kMeteredWidth = 1024;          // of a tiled picture's small copy

glm::vec3 colouredLux(double lux, double colorIndexBv) {
  return glm::vec3(starColour(std::clamp(colorIndexBv, -0.4, 4.0)) * lux);
}

SunInView sunInView(const RenderPlan& plan, LimbDarkeningLaw law) {
  SunInView sun;
  sun.centre = plan.sun.distance * plan.sun.direction;
  sun.radius = plan.sun.radius;
  sun.north = plan.sun.north;
  double const au = astronomicalUnit / plan.sun.distance;
  sun.illuminanceLux = solarIlluminanceAtOneAu() * au * au;
  sun.law = limbDarkening(law, kSolarChannels);
  return sun;
}

SpheroidInView spheroidOf(const PlannedBody& body) {
  return {body.centre, body.bodyFromCamera.inverse()(Direction<BodyFixed>{{0, 0, 1}}),
          body.equatorialRadius, body.polarRadius};
}

// Where limbs stand before Sun or corona: the discs of bodies without air that may.
std::vector<PixelBounds> limbsBeforeSun(const RenderPlan& plan) {
  std::vector<PixelBounds> limbs;
  if (!plan.drawSun) return limbs;
  PixelBounds const sun =
      boundsOfCap(plan.picture, plan.sun.direction, glsl::kCoronaEnd * plan.sun.angularRadius);
  for (auto const& body : plan.bodies) {
    if (body.coversSunItself() || norm(body.centre) > plan.sun.distance) continue;
    PixelBounds const& b = body.bounds;
    PixelBounds const both{std::max(b.x0, sun.x0), std::max(b.y0, sun.y0), std::min(b.x1, sun.x1),
                           std::min(b.y1, sun.y1)};
    if (!both.empty()) limbs.push_back(both);
  }
  return limbs;
}

// Copies a tile, first row at the bottom, into its place of a picture whose first row is at the
// top.
template <class Value>
void placeTile(const std::vector<Value>& tile, glm::ivec2 origin, glm::ivec2 size,
               const FinishedPicture& picture, std::vector<Value>& into) {
  auto const count = static_cast<std::ptrdiff_t>(size.x) * 3;
  for (int row = 0; row < size.y; ++row) {
    auto const to =
        (static_cast<std::ptrdiff_t>(picture.height - 1 - (origin.y + row)) * picture.width +
         origin.x) *
        3;
    std::copy_n(tile.begin() + row * count, count, into.begin() + to);
  }
}

}  // namespace

// What is compiled once for each projection.
struct ProjectionPasses {
  explicit ProjectionPasses(ProjectionKind kind)
      : stars(kind), sun(kind), corona(kind), glare(kind), toneMap(kind) {}
  StarsPass stars;
  SunPass sun;
  CoronaPass corona;
  GlarePass glare;
  ToneMap toneMap;
};

struct PictureRenderer::State {
  State(ImageSource source, Mode chosen) : images(std::move(source)), mode(chosen) {}

  ImageSource images;
  Mode mode;
  std::map<ProjectionKind, ProjectionPasses> byProjection;
  std::unique_ptr<BodiesPass> bodies;
  std::string quality;
  std::optional<StarCatalogue> catalogue;
  gl::Buffer viewBlock;
  gl::Texture linear, display;
  gl::Framebuffer linearTarget, displayTarget;
  PictureCounters counters;
  PassObserver observer;
  std::optional<Exposure> liveExposure;
  std::optional<EyeState> liveEye;
  MeterReading liveReading;  // the eye's last
  Duration liveElapsed;      // since then
  CoronaLook corona;
  std::unique_ptr<SunOcclusion> occlusion;
  std::optional<VisibleSun> visibleSun;
  SunlightThroughAir throughAir;
  glm::dvec3 airBeforeSun{1.0};
  std::vector<StarPoint> stars;  // of the picture in hand
  // Faintest point, lux, that its observer sees; a camera has no such limit.
  std::optional<double> faintestPoint;
  std::map<ProjectionKind, ConePass> conePasses;
  std::optional<DrawingPass> curves, clock;

  ProjectionPasses& passesFor(ProjectionKind kind) {
    return byProjection.try_emplace(kind, kind).first->second;
  }

  void run(const std::string& name, const std::function<void()>& draw) {
    draw();
    if (observer) observer(name, draw);
  }

  void resize(int width, int height) {
    if (linear && linear.width() == width && linear.height() == height) return;
    linear = gl::Texture::plane(GL_RGBA32F, width, height, gl::Filter::Nearest);
    linearTarget = gl::Framebuffer({&linear});
    display = gl::Texture::plane(GL_RGBA8, width, height, gl::Filter::Nearest);
    displayTarget = gl::Framebuffer({&display});
  }

  std::vector<StarPoint> starPoints(const Scene& scene, const PlacedScene& placed) {
    if (!catalogue) catalogue = StarCatalogue::load(catalogsFolder() / "stars");
    std::vector<StarPoint> points;
    for (auto const& star :
         apparentStars(*catalogue, placed.when, placed.velocity, scene.display.limitingMagnitude))
      points.push_back({placed.cameraFromIcrs(star.direction).u,
                        colouredLux(seenLux(star.illuminance), star.colorIndexBv)});
    return points;
  }

  // A point's light as the observer sees it: below an eye's threshold it goes within a magnitude.
  double seenLux(double lux) const {
    if (!faintestPoint) return lux;
    double const over = lux / *faintestPoint, fourth = over * over * over * over;
    return lux * fourth / (1.0 + fourth);
  }
  void observeWith(const EyeState* eye) {
    faintestPoint.reset();
    if (eye) faintestPoint = faintestPointLux(eye->adaptedLuminance);
  }

  // How much of the Sun the device finds uncovered: of this very picture off line, of the newest
  // that has arrived live.
  void askForSun(const RenderPlan& plan, LimbDarkeningLaw law) {
    if (!occlusion) occlusion = std::make_unique<SunOcclusion>();
    SunInView const sun = sunInView(plan, law);
    SunPlane const plane(sun);
    std::vector<SpheroidInView> bodiesInView;
    for (auto const& body : plan.bodies) bodiesInView.push_back(spheroidOf(body));
    auto const silhouettes = plane.silhouettes(bodiesInView);
    auto const ask = [&] { occlusion->ask(sun, plane, silhouettes); };
    ask();
    visibleSun = mode == Mode::OffLine ? std::optional(occlusion->wait()) : occlusion->newest();
    airBeforeSun = throughAir.share(plan);
    counters.occlusionQueries = occlusion->queriesIssued();
    if (observer)
      observer("occlusion query", [&] {
        ask();
        occlusion->wait();
      });
  }

  // The Sun beside the picture: its visible part from the outlines alone. The eye's own field ends
  // 90 degrees from where it looks; from 60 degrees on its light fades.
  void sunBesidePicture(const RenderPlan& plan, LimbDarkeningLaw law) {
    SunInView const sun = sunInView(plan, law);
    SunPlane const plane(sun);
    std::vector<SpheroidInView> coverers;
    for (auto const& c : plan.sunCoverers)
      coverers.push_back({c.centre, c.pole, c.equatorialRadius, c.polarRadius});
    visibleSun = analyticVisibleSun(plane, sun.law, plane.silhouettes(coverers));
    double const cosine = -plan.sun.direction.u.z;
    visibleSun->light *= glm::smoothstep(0.0, 0.5, cosine);
    airBeforeSun = throughAir.share(plan);
  }

  // Makes resident what a picture needs, and what belongs to its instant alone.
  void prepare(const Scene& scene, const PlacedScene& placed, const RenderPlan& plan) {
    stars = starPoints(scene, placed);
    if (!bodies || quality != scene.quality) {
      bodies = std::make_unique<BodiesPass>(images, AirQuality::preset(scene.quality),
                                            mode == Mode::OffLine);
      quality = scene.quality;
    }
    BodiesPass::Look const look{
        scene.display.illustrative,
        parseLimbDarkeningLaw(scene.shadows.limbDarkening, scene.file + ": [shadows]"),
        plan.coronaLight};
    for (auto const& body : plan.bodies) {
      bodies->prepare(body, plan.picture, look);
      if (observer) observer("sky table " + body.name, [&] { bodies->repeatSky(body); });
    }
    visibleSun.reset();
    if (plan.queryOcclusion) askForSun(plan, look.law);
    if (plan.glareFromOutside) sunBesidePicture(plan, look.law);
    corona = {scene.sun.activity.value_or(solarActivity(placed.when)), scene.sun.streamers,
              scene.sun.prominences};
    counters.tablesBuilt = bodies->tablesBuilt();
    counters.shadowPairs = bodies->shadowPairs();
  }

  // Draws all light of a tile of the picture into `linear`.
  void drawTile(const Scene& scene, const RenderPlan& plan, glm::ivec2 origin) {
    ProjectionPasses& passes = passesFor(plan.picture.kind);
    viewBlock.write(gl::viewBlockOf(plan.picture, origin));
    viewBlock.bindUniform(0);
    linearTarget.bind();
    glDisable(GL_SCISSOR_TEST);
    glClearColor(0.0f, 0.0f, 0.0f, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);

    Eye eye;
    eye.magnification = magnificationOf(plan.picture);
    run("stars", [&] {
      passes.stars.draw(stars);
      passes.stars.drawHalos(plan.picture, stars, eye);
    });
    if (!plan.points.empty()) {
      std::vector<StarPoint> points;
      for (auto const& p : plan.points)
        points.push_back({p.direction.u, colouredLux(seenLux(p.illuminance), p.colorIndexBv)});
      run("points", [&] {
        passes.stars.draw(points);
        passes.stars.drawHalos(plan.picture, points, eye);
      });
    }
    // What is farther than any air comes before the Sun, whose passes leave out what it covers: the
    // pixels of a limb before the corona then hold each light once.
    glm::ivec2 const size{linear.width(), linear.height()};
    auto const firstAir =
        std::find_if(plan.bodies.begin(), plan.bodies.end(),
                     [](const PlannedBody& body) { return body.coversSunItself(); });
    auto const drawBodies = [&](auto from, auto to) {
      for (auto body = from; body != to; ++body) {
        bool const rings = body->rings && !body->rings->bounds.empty();
        if (rings)
          run("rings beyond " + body->name,
              [&] { bodies->drawRings(*body, RingsHalf::BeyondGlobe, origin, size); });
        run("body " + body->name, [&] { bodies->draw(*body, plan.picture, origin, size); });
        if (rings)
          run("rings before " + body->name,
              [&] { bodies->drawRings(*body, RingsHalf::BeforeGlobe, origin, size); });
      }
    };
    drawBodies(plan.bodies.begin(), firstAir);
    LimbDarkeningLaw const law =
        parseLimbDarkeningLaw(scene.shadows.limbDarkening, scene.file + ": [shadows]");
    SunInView const sun = sunInView(plan, law);
    SunPlane const plane(sun);
    if (plan.drawSun) {
      // Bodies with air or rings cover the Sun themselves, for these dim it first.
      std::vector<SpheroidInView> airless;
      for (auto const& body : plan.bodies)
        if (!body.coversSunItself()) airless.push_back(spheroidOf(body));
      auto const discs = plane.silhouettes(airless);
      auto const wide = plane.silhouettes(airless, glsl::kCoronaEnd);
      run("sun", [&] { passes.sun.draw(plan.picture, sun, plane, discs, origin); });
      run("corona", [&] { passes.corona.draw(plan.picture, sun, plane, wide, corona, origin); });
    }
    drawBodies(firstAir, plan.bodies.end());
    if (visibleSun) {
      glm::dvec3 const sunlight = sun.illuminanceLux * airBeforeSun;
      linearTarget.bind();
      run("glare", [&] { passes.glare.draw(plan.picture, plane, *visibleSun, sunlight, eye); });
    }
  }

  // Over the bound target, which holds a tile of the picture as displayed.
  void drawOverlays(const RenderPlan& plan, glm::ivec2 origin) {
    auto const& overlays = plan.overlays;
    if (!overlays.cones.empty()) {
      ConePass& cones = conePasses.try_emplace(plan.picture.kind, plan.picture.kind).first->second;
      cones.prepare(overlays.cones, overlays.solids);
      run("overlay cones", [&] { cones.draw(); });
    }
    glm::ivec2 const size{linear.width(), linear.height()};
    auto const drawDrawing = [&](const char* name, const Drawing& drawing,
                                 std::optional<DrawingPass>& pass) {
      if (drawing.shapes.empty() && drawing.words.empty()) return;
      if (!pass) pass.emplace();
      pass->prepare(drawing);
      run(name, [&] { pass->draw(origin, size); });
    };
    drawDrawing("overlay curves", overlays.curves, curves);
    drawDrawing("overlay clock", overlays.clock, clock);
  }

  // What the tone map has drawn, first row at the bottom.
  std::vector<std::uint8_t> displayed(int w, int h) const {
    std::vector<std::uint8_t> srgb(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * 3);
    glGetTextureImage(display.id(), 0, GL_RGB, GL_UNSIGNED_BYTE, static_cast<GLsizei>(srgb.size()),
                      srgb.data());
    return srgb;
  }

  Exposure exposureOf(const Scene& scene, const MeterReading& reading,
                      const EyeState* eye = nullptr) const {
    if (!scene.display.automaticExposure) return {scene.display.whiteLuminance};
    if (scene.display.eye)
      return antumbra::exposureOf(eye ? *eye
                                      : steadyEye(reading, {scene.display.compensationStops}));
    return exposureFor(reading, {scene.display.compensationStops});
  }
};

PictureRenderer::PictureRenderer(ImageSource images, Mode mode)
    : state_(std::make_unique<State>(std::move(images), mode)) {}
PictureRenderer::~PictureRenderer() = default;

MeterReading PictureRenderer::meter(const Scene& scene, const PlacedScene& placed,
                                    const RenderPlan& plan) {
  State& s = *state_;
  s.observeWith(nullptr);
  s.resize(plan.picture.width, plan.picture.height);
  s.prepare(scene, placed, plan);
  s.drawTile(scene, plan, {0, 0});
  return s.passesFor(plan.picture.kind).toneMap.measure(s.linear);
}

FinishedPicture PictureRenderer::finish(const Scene& scene, const PlacedScene& placed,
                                        const RenderPlan& plan, const EyeState* eye) {
  State& s = *state_;
  s.observeWith(scene.display.eye ? eye : nullptr);
  int const width = plan.picture.width, height = plan.picture.height;
  if (double(width) * height > kMostPixels)
    throw InputError(fmt::format("--size: found {}x{}; allowed: at most {:.0f} pixels", width,
                                 height, kMostPixels));
  int const largest = std::min(
      {kLargestTile, gl::describeDevice().maxTextureSize, gl::describeDevice().maxViewport});
  bool const tiled = width > largest || height > largest;
  ToneMap& toneMap = s.passesFor(plan.picture.kind).toneMap;

  Exposure exposure;
  if (tiled) {
    // A small copy of the whole picture is metered.
    RenderPlan copy = plan;
    copy.picture.width = std::min(width, kMeteredWidth);
    copy.picture.height =
        std::max(1, static_cast<int>(std::lround(double(height) * copy.picture.width / width)));
    copy.rescaleBounds(plan.picture);
    s.resize(copy.picture.width, copy.picture.height);
    s.prepare(scene, placed, copy);
    s.drawTile(scene, copy, {0, 0});
    exposure = s.exposureOf(scene, toneMap.measure(s.linear), eye);
  }

  s.prepare(scene, placed, plan);
  auto const edges = limbsBeforeSun(plan);
  FinishedPicture picture;
  picture.width = width;
  picture.height = height;
  auto const pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  picture.linear.resize(pixels * 3);
  picture.srgb.resize(pixels * 3);
  picture.brackets.assign(scene.display.bracketsStops.size(),
                          std::vector<std::uint8_t>(pixels * 3));
  for (int y = 0; y < height; y += largest)
    for (int x = 0; x < width; x += largest) {
      int const w = std::min(largest, width - x), h = std::min(largest, height - y);
      s.resize(w, h);
      s.drawTile(scene, plan, {x, y});
      if (!tiled) exposure = s.exposureOf(scene, toneMap.measure(s.linear), eye);
      s.run("tone map", [&] {
        toneMap.apply(s.linear, exposure, &s.displayTarget, {x, y}, true, edges);
      });
      s.drawOverlays(plan, {x, y});
      std::vector<float> linear(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * 3);
      glGetTextureImage(s.linear.id(), 0, GL_RGB, GL_FLOAT,
                        static_cast<GLsizei>(linear.size() * sizeof(float)), linear.data());
      placeTile(linear, {x, y}, {w, h}, picture, picture.linear);
      placeTile(s.displayed(w, h), {x, y}, {w, h}, picture, picture.srgb);
      for (std::size_t i = 0; i < picture.brackets.size(); ++i) {
        Exposure bracket = exposure;
        bracket.whiteLuminance *= std::exp2(-scene.display.bracketsStops[i]);
        toneMap.apply(s.linear, bracket, &s.displayTarget, {x, y}, true, edges);
        s.drawOverlays(plan, {x, y});
        placeTile(s.displayed(w, h), {x, y}, {w, h}, picture, picture.brackets[i]);
      }
    }
  picture.whiteLuminance = exposure.whiteLuminance;
  return picture;
}

void PictureRenderer::show(const Scene& scene, const PlacedScene& placed, const RenderPlan& plan,
                           unsigned framebuffer, Duration sinceLast) {
  State& s = *state_;
  s.observeWith(scene.display.eye && s.liveEye ? &*s.liveEye : nullptr);
  ToneMap& toneMap = s.passesFor(plan.picture.kind).toneMap;
  s.resize(plan.picture.width, plan.picture.height);
  s.prepare(scene, placed, plan);
  s.drawTile(scene, plan, {0, 0});
  if (!scene.display.automaticExposure) {
    s.liveExposure = Exposure{scene.display.whiteLuminance};
  } else if (scene.display.eye) {
    AutomaticExposure const settings{scene.display.compensationStops};
    s.liveElapsed = s.liveElapsed + sinceLast;
    if (!s.liveEye) {
      s.liveReading = toneMap.measure(s.linear);
      s.liveEye = steadyEye(s.liveReading, settings);
    } else if (auto const reading = toneMap.measureWithoutWaiting(s.linear)) {
      s.liveEye = adaptedEye(*s.liveEye, s.liveReading, *reading, s.liveElapsed, settings);
      s.liveReading = *reading;
      s.liveElapsed = Duration();
    }
    s.liveExposure = exposureOf(*s.liveEye);
  } else if (!s.liveExposure) {
    s.liveExposure = s.exposureOf(scene, toneMap.measure(s.linear));
  } else if (auto const reading = toneMap.measureWithoutWaiting(s.linear)) {
    s.liveExposure = adaptedExposure(*s.liveExposure, s.exposureOf(scene, *reading), sinceLast);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, plan.picture.width, plan.picture.height);
  toneMap.apply(s.linear, *s.liveExposure, nullptr, {0, 0}, true, limbsBeforeSun(plan));
  s.drawOverlays(plan, {0, 0});
}

const PictureCounters& PictureRenderer::counters() const { return state_->counters; }
void PictureRenderer::observePasses(PassObserver observer) {
  state_->observer = std::move(observer);
}
std::vector<std::pair<std::string, std::size_t>> PictureRenderer::residentBytes() const {
  std::vector<std::pair<std::string, std::size_t>> bytes;
  if (state_->bodies) bytes = state_->bodies->residentBytes();
  bytes.emplace_back("picture, 32-bit float", state_->linear.bytes());
  return bytes;
}
std::vector<std::pair<std::string, double>> PictureRenderer::precomputeSeconds() const {
  if (!state_->bodies) return {};
  return state_->bodies->precomputeSeconds();
}

}  // namespace antumbra
