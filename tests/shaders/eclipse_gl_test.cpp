// The shared eclipse functions on the graphics device, in floats, against the same in doubles.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "eclipse/limb_darkening.h"
#include "eclipse/shadow_pair.h"
#include "gl/buffer.h"
#include "gl/program.h"
#include "quantity/constants.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/larger.h"

namespace antumbra {
namespace {

struct Probe {
  glm::vec4 discs;
  glm::vec4 point;
};
struct Answer {
  glm::vec4 light;
  glm::vec4 atPoint;
  glm::vec4 other;
};

constexpr Length kMoon = kLunarKIau * kEarthEquatorialRadius;
const glm::dvec3 kRay(0.6, 0.64, 0.48);

class EclipseOnDevice : public testsupport::GlTest {
 protected:
  std::vector<Answer> evaluate(const std::vector<Probe>& probes, const glsl::ShadowPair& pair,
                               const glsl::LimbDarkening& law) {
    gl::Program program = gl::Program::compute("bench/eclipse_probe.comp");
    gl::Buffer in, out, shadow, limb;
    in.write(std::span<const Probe>(probes));
    std::vector<Answer> answers(probes.size());
    out.write(std::span<const Answer>(answers));
    auto packedPair = packedForShader(pair);
    auto packedLaw = packedForShader(law);
    shadow.write(std::span<const float>(packedPair));
    limb.write(std::span<const float>(packedLaw));
    in.bindStorage(0);
    out.bindStorage(1);
    shadow.bindUniform(0);
    limb.bindUniform(1);
    program.use();
    glDispatchCompute(static_cast<GLuint>((probes.size() + 63) / 64), 1, 1);
    glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    glGetNamedBufferSubData(out.id(), 0, static_cast<GLsizeiptr>(answers.size() * sizeof(Answer)),
                            answers.data());
    return answers;
  }
  glsl::ShadowPair pair_ =
      shadowPairMetres({1.496e11, 0.0, 0.0}, {3.7e8, 1e6, 2e5}, {kSolarRadiusIau, kMoon, kMoon});
  glsl::LimbDarkening law_ =
      limbDarkening(LimbDarkeningLaw::Hestroffer,
                    {440.0 * nanometre, 550.0 * nanometre, 680.0 * nanometre, 800.0 * nanometre});
};

TEST_F(EclipseOnDevice, VisibleFractionsKeepRelativePrecision) {
  // 1e-3 relative down to a visible fraction of 1e-6.
  std::vector<Probe> probes;
  float sun = 4.65e-3f;
  for (double excess : {-0.5, -0.05, -0.01, -1e-4, 0.0, 1e-4, 0.003, 0.02, 0.06, 0.5, 2.7, 340.0}) {
    for (int i = 0; i <= 400; ++i) {
      double gap = std::pow(10.0, -5.0 + 5.3 * i / 400.0);
      if (gap + excess < 0.0) continue;
      probes.push_back(
          {{sun, static_cast<float>(excess) * sun, static_cast<float>(gap) * sun, 0.0f},
           {0.0f, 0.0f, 0.0f, 0.0f}});
    }
  }
  std::vector<Answer> answers = evaluate(probes, pair_, law_);
  double worstUniform = 0.0, worstLimb = 0.0;
  int compared = 0;
  for (std::size_t k = 0; k < probes.size(); ++k) {
    glsl::DiscPair discs;
    discs.sun = probes[k].discs.x;
    discs.excess = probes[k].discs.y;
    discs.gap = probes[k].discs.z;
    double uniform = glsl::visibleFractionUniform(discs);
    if (uniform < 1e-6) continue;
    ++compared;
    worstUniform = testsupport::larger(worstUniform, std::fabs(answers[k].other.x / uniform - 1.0));
    glm::dvec4 light = glsl::visibleFraction(discs, law_);
    for (int c = 0; c < 4; ++c) {
      worstLimb = testsupport::larger(worstLimb, std::fabs(answers[k].light[c] / light[c] - 1.0));
    }
    EXPECT_LT(std::fabs(answers[k].other.x / uniform - 1.0), 1e-3)
        << discs.excess / discs.sun << " " << discs.gap / discs.sun << " " << uniform;
    EXPECT_LT(std::fabs(answers[k].light.x / light.x - 1.0), 1e-3)
        << discs.excess / discs.sun << " " << discs.gap / discs.sun << " " << light.x;
  }
  EXPECT_GT(compared, 3000);
  std::printf("relative error on the device: uniform %.1e, limb-darkened %.1e, %d discs\n",
              worstUniform, worstLimb, compared);
}

TEST_F(EclipseOnDevice, LightAtPointsNearTheOriginIsPrecise) {
  std::mt19937 random(11);
  std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
  for (float reach : {6.4e6f, 3e5f}) {
    // The wide one from the centre of the planet, the narrow one from a place in the umbra.
    glm::dvec3 origin = reach > 1e6f ? glm::dvec3(0.0) : glm::dvec3(6.3e6, 1e6, 2e5);
    glsl::ShadowPair pair =
        shadowPairMetres(glm::dvec3{1.496e11, 0.0, 0.0} - origin,
                         glm::dvec3{3.7e8, 1e6, 2e5} - origin, {kSolarRadiusIau, kMoon, kMoon});
    std::vector<Probe> probes;
    for (int i = 0; i < 20000; ++i) {
      probes.push_back({{4.65e-3f, 0.0f, 1e-3f, 0.0f},
                        {reach * unit(random), reach * unit(random), reach * unit(random), 0.0f}});
    }
    std::vector<Answer> answers = evaluate(probes, pair, law_);
    double worstGapMetres = 0.0, worstCrossing = 0.0, worstLight = 0.0;
    int partial = 0;
    for (std::size_t k = 0; k < probes.size(); ++k) {
      glm::dvec3 point(probes[k].point);
      glsl::ShadowPlace place = glsl::placeInShadow(pair, point);
      glsl::DiscPair discs = glsl::discsAt(pair, place.along, place.distance);
      double light = glsl::visibleSunlight(pair, law_, point).y;
      worstLight = testsupport::larger(worstLight, std::fabs(answers[k].atPoint.y - light));
      if (discs.gap < 2.0 * discs.sun) {
        worstGapMetres =
            testsupport::larger(worstGapMetres, std::fabs(answers[k].other.y - discs.gap) * 3.7e8);
        partial += light > 0.0;
      }
      glsl::ConeCrossing crossing = glsl::crossPenumbra(pair, point - 1e9 * kRay, kRay);
      if (crossing.count == 2) {
        // A grazing ray's crossings move far for little: compare the middle and the larger ones.
        double half = 0.5 * (crossing.second - crossing.first);
        double found = 0.5 * (answers[k].other.z + answers[k].other.w);
        worstCrossing = testsupport::larger(
            worstCrossing, std::fabs(found - 0.5 * (crossing.first + crossing.second)));
        if (half > 1e6) {
          EXPECT_NEAR(answers[k].other.z, crossing.first, 700.0);
          EXPECT_NEAR(answers[k].other.w, crossing.second, 700.0);
        }
      }
    }
    std::printf("reach %.0e m: gap %.2f m at the Moon's distance, light %.1e, crossings %.0f m\n",
                static_cast<double>(reach), worstGapMetres, worstLight, worstCrossing);
    EXPECT_GT(partial, 100);
    // A float's place: 0.5 m at 6e6 m, 0.03 m at 3e5 m, twice or thrice through the projection;
    // in wide gaps the float's own 6e-8 of 3e6 m.
    EXPECT_LT(worstGapMetres, 3.0);
    EXPECT_LT(worstLight, 1e-4);
    // The float direction of a ray of 1e9 m puts it 60 m aside; flanks and floats do the rest.
    EXPECT_LT(worstCrossing, 700.0);
  }
}

}  // namespace
}  // namespace antumbra
