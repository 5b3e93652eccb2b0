// Saturn's rings in whole pictures: their shadow on the globe against rays to the points of the
// Sun, the globe's shadow on them against rays past the spheroid, and what lies before what.
#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "document/paths.h"
#include "eclipse/rays_to_sun.h"
#include "picture/picture_renderer.h"
#include "quantity/constants.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/larger.h"

namespace antumbra {
namespace {

DecodedImage greyMap(const std::string&, const std::string&) {
  return {4, 2, 3, std::vector<unsigned char>(4 * 2 * 3, 200)};
}

constexpr int kWidth = 640, kHeight = 360;

class RingsInPictures : public testsupport::GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    look(-28.0 * degree, 60.0 * degree, 18.0 * degree);
  }
  // From above a latitude and a longitude toward the globe's centre, or as `aimed_`.
  void look(Angle latitude, Angle longitude, Angle field) {
    auto const aim = scene_.camera;
    scene_ = readScene(configsFolder() / "scenes" / "saturn.toml");
    if (aimed_) scene_.camera = aim;
    scene_.bodies = {"Sun", "Saturn"};
    scene_.picture.width = kWidth;
    scene_.picture.height = kHeight;
    scene_.camera.latitude = latitude;
    scene_.camera.longitude = longitude;
    scene_.picture.field = field;
    scene_.quality = "draft";
    scene_.shadows.limbDarkening = "hestroffer";
    scene_.display.limitingMagnitude = -10.0;
    placed_ = placeScene(scene_, parseInstant(scene_.time, "test"), BodyCatalogue::standard(),
                         Ephemeris::standard(), DeltaT::standard());
    plan_ = makeRenderPlan(scene_, placed_);
    for (auto& body : plan_.bodies)
      if (body.name == "Saturn") saturn_ = &body;
    ASSERT_TRUE(saturn_ && saturn_->rings);
    system_ = saturn_->rings->system;
    toBody_ = saturn_->bodyFromCamera.matrix;
    camera_ = toBody_ * -saturn_->centre.m;
    flat_ = saturn_->polarRadius / saturn_->equatorialRadius;
  }
  std::vector<float> luminances() {
    auto const picture = renderer_.finish(scene_, placed_, plan_);
    std::vector<float> y;
    for (int row = picture.height - 1; row >= 0; --row)
      for (int x = 0; x < picture.width; ++x)
        y.push_back(picture.linear[static_cast<std::size_t>(row * picture.width + x) * 3 + 1]);
    return y;
  }
  glm::dvec3 rayOf(double x, double y) const {
    return toBody_ * scene_.picture.directionAt(x + 0.5, y + 0.5)->u;
  }
  // Where a ray meets the globe, and the plane of the rings.
  std::optional<double> toGlobe(const glm::dvec3& ray) const {
    glm::dvec3 const stretch(1.0, 1.0, 1.0 / flat_), o = camera_ * stretch, d = ray * stretch;
    double const a = dot(d, d), b = dot(o, d);
    double const c = dot(o, o) - std::pow(saturn_->equatorialRadius.si, 2.0);
    if (b * b < a * c) return std::nullopt;
    return (-b - std::sqrt(b * b - a * c)) / a;
  }
  double toPlane(const glm::dvec3& ray) const { return -camera_.z / ray.z; }
  double depthAt(const glm::dvec3& point) const {
    return system_.opticalDepthAt(Length(std::hypot(point.x, point.y)));
  }
  // Depth is the same within two pixels of the plane's point.
  bool evenAround(int x, int y) const {
    glm::dvec3 const ray = rayOf(x, y);
    double const depth = depthAt(camera_ + ray * toPlane(ray));
    for (int dx : {-2, 2})
      for (double dy = -2.0; dy <= 2.0; dy += 0.125) {
        glm::dvec3 const r = rayOf(x + dx, y + dy);
        if (!(toPlane(r) > 0.0) || depthAt(camera_ + r * toPlane(r)) != depth) return false;
      }
    return true;
  }

  Scene scene_;
  bool aimed_ = false;  // scene_.camera's azimuth and altitude stay
  PlacedScene placed_;
  RenderPlan plan_;
  PlannedBody* saturn_ = nullptr;
  RingSystem system_;
  glm::dmat3 toBody_;
  glm::dvec3 camera_;
  double flat_ = 1.0;
  PictureRenderer renderer_{greyMap};
};

TEST_F(RingsInPictures, ShadeTheGlobeAsRaysToTheSunSay) {
  // Pixels of 15 km, for the shadow is averaged over them.
  look(38.0 * degree, 126.0 * degree, 0.6 * degree);
  saturn_->rings->bounds = {};
  auto const with = luminances();
  saturn_->rings->shadeGlobe = false;
  auto const without = luminances();
  LimbProfile const law = limbProfile(LimbDarkeningLaw::Hestroffer, 550.0 * nanometre);
  glm::dvec3 const sun = saturn_->sun.m;
  double const distance = glm::length(sun), sine = kSolarRadiusIau.si / distance;
  glm::dvec3 const z = sun / distance, x = glm::normalize(glm::cross(z, glm::dvec3(0.1, 0.2, 1.0)));
  glm::dvec3 const y = glm::cross(z, x);
  double worst = 0.0, sum = 0.0;
  int compared = 0, shaded = 0;
  for (int py = 0; py < kHeight; py += 7)
    for (int px = 0; px < kWidth; px += 5) {
      auto const t = toGlobe(rayOf(px, py));
      std::size_t const i = static_cast<std::size_t>(py * kWidth + px);
      if (!t || without[i] < 1.0f) continue;
      glm::dvec3 const point = camera_ + rayOf(px, py) * *t;
      double light = 0.0, all = 0.0;
      for (int ring = 0; ring < 48; ++ring)
        for (int turn = 0; turn < 96; ++turn) {
          double const r = std::sqrt((ring + 0.5) / 48.0), a = 2.0 * M_PI * (turn + 0.5) / 96.0;
          double const weight = std::pow(1.0 - r * r, 0.5 * law.exponent);
          glm::dvec3 const ray = z + sine * r * (x * std::cos(a) + y * std::sin(a));
          double const way = -point.z / ray.z;
          light +=
              weight * (way > 0.0 ? std::exp(-depthAt(point + ray * way) / std::fabs(z.z)) : 1.0);
          all += weight;
        }
      double const expected = light / all, found = with[i] / without[i];
      worst = testsupport::larger(worst, std::fabs(found - expected));
      sum += std::fabs(found - expected);
      shaded += expected < 0.5;
      ++compared;
    }
  std::printf(
      "ring shadow on the globe: mean %.1e, largest %.3f of sunlight over %d pixels (%d dark)\n",
      sum / compared, worst, compared, shaded);
  EXPECT_GT(shaded, 10);
  EXPECT_LT(sum / compared, 1e-3);
  // A float's place on the globe moves a sharp edge by tens of metres; the test's disc has 24
  // rings.
  EXPECT_LT(worst, 0.03);
}

// Seen from afar the shadow is full or none, from 6 km a pixel its penumbra is 10 to 20 pixels
// wide.
TEST_F(RingsInPictures, LieInTheShadowOfTheSpheroid) {
  auto const compare = [&](int every) {
    saturn_->rings->shadeGlobe = false;
    auto const with = luminances();
    auto const radii = saturn_->rings->globe;
    saturn_->rings->globe.casterUmbra = saturn_->rings->globe.casterPenumbra = 1.0 * metre;
    auto const without = luminances();
    OpaqueSpheroid const globe{
        {0, 0, 0}, {0, 0, 1}, radii.casterUmbra.si, radii.casterUmbra.si * flat_};
    LimbProfile const law = limbProfile(LimbDarkeningLaw::Hestroffer, 550.0 * nanometre);
    double worst = 0.0;
    int dark = 0, compared = 0, partial = 0;
    for (int py = 2; py < kHeight - 2; ++py)
      for (int px = 2; px < kWidth - 2; ++px) {
        glm::dvec3 const ray = rayOf(px, py);
        double const t = toPlane(ray);
        if ((px + py) % every || !(t > 0.0) || toGlobe(ray) || !evenAround(px, py)) continue;
        glm::dvec3 const point = camera_ + ray * t;
        std::size_t const i = static_cast<std::size_t>(py * kWidth + px);
        if (depthAt(point) == 0.0 || without[i] <= 0.0f) continue;
        double const expected = visibleLightByRays(point, saturn_->sun.m, radii.sun.si,
                                                   std::span(&globe, 1), law, 1e-4, 60);
        double const found = with[i] / without[i];
        EXPECT_NEAR(found, expected, 2e-3) << px << " " << py;
        worst = testsupport::larger(worst, std::fabs(found - expected));
        dark += expected < 1e-6;
        partial += expected > 0.01 && expected < 0.99;
        ++compared;
      }
    std::printf(
        "globe's shadow on the rings: within %.1e of sunlight over %d pixels (%d dark, %d "
        "partial)\n",
        worst, compared, dark, partial);
    return glm::ivec2(dark, partial);
  };
  // Where the shadow's edge crosses the B ring in the camera's view.
  auto const edge = [&] {
    OpaqueSpheroid const globe{
        {0, 0, 0}, {0, 0, 1}, saturn_->equatorialRadius.si, saturn_->equatorialRadius.si * flat_};
    auto const at = [](double turn) {
      return 1.1e8 * glm::dvec3(std::cos(turn), std::sin(turn), 0.0);
    };
    auto const shaded = [&](double turn) { return meets(globe, at(turn), saturn_->sun.m); };
    for (int i = 0; i < 360; ++i) {
      double low = i * degree.si, high = (i + 1) * degree.si;
      if (shaded(low) == shaded(high)) continue;
      bool const first = shaded(low);
      for (int k = 0; k < 40; ++k) {
        double const middle = 0.5 * (low + high);
        (shaded(middle) == first ? low : high) = middle;
      }
      glm::dvec3 const ray = glm::normalize(at(low) - camera_);
      if (!toGlobe(ray)) return ray;
    }
    ADD_FAILURE() << "no edge of the shadow is seen";
    return glm::dvec3(0.0, 0.0, 1.0);
  };
  EXPECT_GT(compare(9).x, 100);
  look(-28.0 * degree, 60.0 * degree, 18.0 * degree);
  glm::dvec3 const toEdge = placed_
                                .enuFromIcrs(placed_.cameraFromIcrs.inverse()(
                                    Direction<CameraAxes>{glm::transpose(toBody_) * edge()}))
                                .u;
  aimed_ = true;
  scene_.camera.target = "";
  scene_.camera.azimuth = arcTangent(toEdge.x, toEdge.y);
  scene_.camera.altitude = arcTangent(toEdge.z, std::hypot(toEdge.x, toEdge.y));
  look(-28.0 * degree, 60.0 * degree, 0.25 * degree);
  EXPECT_GT(compare(29).y, 100);
}

TEST_F(RingsInPictures, CoverWhatLiesBehindAndAreCoveredByTheGlobe) {
  saturn_->rings->shadeGlobe = false;
  auto const both = luminances();
  auto const factor = saturn_->mapFactor;
  saturn_->mapFactor = glm::vec3(0.0f);
  auto const black = luminances();  // rings about a black globe
  saturn_->mapFactor = factor;
  saturn_->rings.reset();
  auto const globe = luminances();
  int before = 0, beyond = 0;
  for (int py = 2; py < kHeight - 2; ++py)
    for (int px = 2; px < kWidth - 2; ++px) {
      glm::dvec3 const ray = rayOf(px, py);
      auto const t = toGlobe(ray);
      std::size_t const i = static_cast<std::size_t>(py * kWidth + px);
      // Well inside the limb, and on the day side.
      if (!t || !toGlobe(rayOf(px - 2, py)) || !toGlobe(rayOf(px + 2, py)) ||
          !toGlobe(rayOf(px, py - 2)) || !toGlobe(rayOf(px, py + 2)) || globe[i] < 20.0f)
        continue;
      double const plane = -camera_.z / ray.z;
      auto const outside = [&](int x, int y) {
        glm::dvec3 const r = rayOf(x, y), at = camera_ + r * (-camera_.z / r.z);
        double const radius = std::hypot(at.x, at.y);
        return radius < system_.inner().si || radius > system_.outer().si;
      };
      double const radius = std::hypot(camera_.x + ray.x * plane, camera_.y + ray.y * plane);
      if (plane > *t || (outside(px, py - 2) && outside(px, py) && outside(px, py + 2))) {
        EXPECT_NEAR(both[i], globe[i], 1e-3f * globe[i]) << px << " " << py;
        EXPECT_LT(black[i], 1e-3f * globe[i]);
        beyond += plane > *t;
        continue;
      }
      double const depth = system_.opticalDepthAt(Length(radius));
      if (!evenAround(px, py)) continue;
      double const passed = std::exp(-depth / std::fabs(ray.z));
      EXPECT_NEAR(both[i] - black[i], passed * globe[i], 2e-3 * globe[i]) << px << " " << py;
      ++before;
    }
  std::printf("%d pixels of rings before the globe, %d beyond it\n", before, beyond);
  EXPECT_GT(before, 50);
  EXPECT_GT(beyond, 50);
}

TEST_F(RingsInPictures, ArePlannedOnlyWhereTheyAreSeen) {
  EXPECT_EQ(plan_.shadows.size(), 2u);
  (void)luminances();
  EXPECT_EQ(renderer_.counters().shadowPairs, 2);
  Scene away = scene_;
  away.camera.target = "zenith";
  auto const placed = placeScene(away, placed_.when, BodyCatalogue::standard(),
                                 Ephemeris::standard(), DeltaT::standard());
  auto const plan = makeRenderPlan(away, placed);
  EXPECT_TRUE(plan.shadows.empty());
  bool said = false;
  for (auto const& line : plan.leftOut) said = said || line.what == "rings of Saturn";
  EXPECT_TRUE(said);
}

}  // namespace
}  // namespace antumbra
