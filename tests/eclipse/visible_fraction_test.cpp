// The visible fraction of the Sun against integration over rings of the disc, in extended
// precision.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "document/input_error.h"
#include "eclipse/limb_darkening.h"

namespace antumbra {
namespace {

using Extended = long double;

// Gauss-Legendre nodes and weights on [0, 1], by Newton's method.
struct GaussRule {
  std::vector<Extended> node, weight;
  explicit GaussRule(int n) {
    for (int i = 0; i < n; ++i) {
      Extended z = std::cos(M_PIl * (i + 0.75L) / (n + 0.5L));
      Extended slope = 1.0L;
      for (int step = 0; step < 100; ++step) {
        Extended p = 1.0L, before = 0.0L;
        for (int j = 0; j < n; ++j) {
          Extended next = ((2 * j + 1) * z * p - j * before) / (j + 1);
          before = p;
          p = next;
        }
        slope = n * (z * p - before) / (z * z - 1.0L);
        Extended change = p / slope;
        z -= change;
        if (std::fabs(change) < 1e-19L) break;
      }
      node.push_back((1.0L - z) / 2.0L);
      weight.push_back(1.0L / ((1.0L - z * z) * slope * slope));
    }
  }
};

// Visible light as an integral over rings of the solar disc: the uncovered angle of each ring times
// mu I(mu) dmu, with panels graded towards both ends of the partly covered zone. Sun of radius 1.
Extended visibleByRings(Extended excess, Extended gap, const LimbProfile& law) {
  static const GaussRule rule(20);
  Extended o = 1.0L + excess, d = gap + excess;
  if (gap <= 0.0L) return 0.0L;
  if (gap >= 2.0L) return 1.0L;
  auto alpha = static_cast<Extended>(law.exponent);
  auto intensity = [&](Extended mu) {
    Extended sum = 0.0L;
    for (int k = 5; k >= 0; --k) sum = sum * mu + law.polynomial[static_cast<std::size_t>(k)];
    return std::pow(mu, alpha) * sum;
  };
  auto lightOutside = [&](Extended mu) {  // of the ring, over 2 pi
    Extended sum = 0.0L;
    for (int k = 5; k >= 0; --k) {
      sum = sum * mu + law.polynomial[static_cast<std::size_t>(k)] / (k + 2.0L + alpha);
    }
    return std::pow(mu, 2.0L + alpha) * sum;
  };
  auto uncovered = [&](Extended mu) {  // half-angle of the ring that is uncovered
    Extended depth = mu * mu / (1.0L + std::sqrt(std::max(1.0L - mu * mu, 0.0L)));
    Extended r = 1.0L - depth;
    Extended above = std::max((gap - depth) * (r + d + o), 0.0L);
    Extended below = (excess + depth + d) * (o + r - d);
    if (below <= 0.0L) return M_PIl;
    return 2.0L * std::atan2(std::sqrt(above), std::sqrt(below));
  };
  Extended muOuter = std::sqrt(std::max(gap * (2.0L - gap), 0.0L));
  Extended farthest = o + d;
  Extended muInner = farthest < 1.0L ? std::sqrt(1.0L - farthest * farthest) : 0.0L;
  Extended partly = 0.0L;
  const int kPanels = 24;
  auto graded = [&](Extended u) {
    return u * u * u * (10.0L + u * (-15.0L + 6.0L * u)) * M_PIl / 2;
  };
  for (int panel = 0; panel < kPanels; ++panel) {
    Extended from = graded(static_cast<Extended>(panel) / kPanels);
    Extended to = graded(static_cast<Extended>(panel + 1) / kPanels);
    for (std::size_t i = 0; i < rule.node.size(); ++i) {
      Extended t = from + (to - from) * rule.node[i];
      Extended span = muOuter * muOuter - muInner * muInner;
      Extended mu = std::sqrt(muInner * muInner + span * std::sin(t) * std::sin(t));
      Extended angle = uncovered(mu);
      Extended part = gap < 1.0L ? angle : M_PIl - angle;
      partly +=
          intensity(mu) * part * span * std::sin(t) * std::cos(t) * rule.weight[i] * (to - from);
    }
  }
  Extended whole = M_PIl * lightOutside(1.0L);
  if (gap < 1.0L) return (M_PIl * lightOutside(muInner) + partly) / whole;
  return 1.0L - partly / whole;
}

struct Configuration {
  double excess, gap;  // in radii of the Sun
};

std::vector<Configuration> configurations() {
  std::vector<Configuration> all;
  for (double excess : {-0.9, -0.5, -0.1, -0.03, -0.01, -0.001, -1e-5, 0.0,  1e-6,  0.001, 0.01,
                        0.03, 0.06, 0.1,  0.5,   0.99,  1.01,   2.7,   50.0, 340.0, 1e5}) {
    for (double gap : {1e-6, 1e-5,   1e-4, 3e-4, 1e-3, 0.003, 0.01, 0.02, 0.0201, 0.03,  0.0599,
                       0.06, 0.0605, 0.07, 0.1,  0.13, 0.2,   0.21, 0.25, 0.299,  0.301, 0.45,
                       0.55, 0.7,    0.95, 1.0,  1.05, 1.3,   1.6,  1.9,  1.99,   1.9999}) {
      if (gap + excess >= 0.0) all.push_back({excess, gap});
    }
  }
  return all;
}

glsl::DiscPair discs(const Configuration& c, double sun = 4.65e-3) {
  glsl::DiscPair pair;
  pair.sun = sun;
  pair.excess = c.excess * sun;
  pair.gap = c.gap * sun;
  return pair;
}

constexpr auto kLaws = {LimbDarkeningLaw::Hestroffer, LimbDarkeningLaw::Neckel,
                        LimbDarkeningLaw::None};

TEST(VisibleFraction, UniformDiscAgreesWithIntegrationOverRings) {
  // 1e-6 relative, down to a visible fraction of 1e-8: the bar of the double precision.
  int compared = 0;
  for (const Configuration& c : configurations()) {
    double expected = static_cast<double>(visibleByRings(c.excess, c.gap, {}));
    if (expected < 1e-8) continue;
    double found = glsl::visibleFractionUniform(discs(c));
    EXPECT_NEAR(found / expected, 1.0, 1e-6) << c.excess << " " << c.gap << " " << expected;
    ++compared;
  }
  EXPECT_GT(compared, 400);
}

TEST(VisibleFraction, LimbDarkenedDiscAgreesWithIntegrationOverRings) {
  // Five nodes reach 2e-4 of the visible light; the bar is 1e-3.
  std::array<Length, 4> wavelengths{440.0 * nanometre, 550.0 * nanometre, 680.0 * nanometre,
                                    1000.0 * nanometre};
  for (auto named : kLaws) {
    glsl::LimbDarkening law = limbDarkening(named, wavelengths);
    for (const Configuration& c : configurations()) {
      glm::dvec4 found = glsl::visibleFraction(discs(c), law);
      for (int channel = 0; channel < 4; channel += 3) {
        LimbProfile profile = limbProfile(named, wavelengths[static_cast<std::size_t>(channel)]);
        double expected = static_cast<double>(visibleByRings(c.excess, c.gap, profile));
        EXPECT_NEAR(found[channel] / expected, 1.0, 2e-4)
            << static_cast<int>(named) << " " << c.excess << " " << c.gap << " " << expected;
      }
    }
  }
}

TEST(VisibleFraction, LawsIntegrateToOneOverTheDisc) {
  std::array<Length, 4> wavelengths{360.0 * nanometre, 400.0 * nanometre, 550.0 * nanometre,
                                    1000.0 * nanometre};
  GaussRule rule(60);
  for (auto named : kLaws) {
    glsl::LimbDarkening law = limbDarkening(named, wavelengths);
    glm::dvec4 whole(0.0), half(0.0);
    for (std::size_t i = 0; i < rule.node.size(); ++i) {
      double s = static_cast<double>(rule.node[i]), w = static_cast<double>(rule.weight[i]);
      double mu = s * s;  // d(mu^2) = 4 s^3 ds
      whole += glsl::solarBrightness(law, mu) * (4.0 * s * s * s * w);
      double inner = std::sqrt(0.5) * s * s;
      half += glsl::solarBrightness(law, inner) * (2.0 * s * s * s * w);
    }
    for (int channel = 0; channel < 4; ++channel) {
      EXPECT_NEAR(whole[channel], 1.0, 1e-7);
      EXPECT_NEAR(half[channel], glsl::lightOutsideRing(law, 0.5)[channel], 1e-7);
    }
  }
}

TEST(VisibleFraction, LawsKnowTheirSpan) {
  for (double um : {0.31, 0.36, 0.39, 0.41, 0.43, 0.55, 0.8, 1.1}) {
    double sum = 0.0;
    for (double a : limbProfile(LimbDarkeningLaw::Neckel, um * 1e-6 * metre).polynomial) sum += a;
    EXPECT_NEAR(sum, 1.0, 1e-12) << um;
  }
  EXPECT_THROW(limbProfile(LimbDarkeningLaw::Neckel, 380.0 * nanometre), InputError);
  EXPECT_THROW(limbProfile(LimbDarkeningLaw::Hestroffer, 2000.0 * nanometre), InputError);
  EXPECT_THROW(parseLimbDarkeningLaw("linear", "--limb-darkening"), InputError);
}

TEST(VisibleFraction, IsANumberForTenMillionConfigurations) {
  glsl::LimbDarkening law =
      limbDarkening(LimbDarkeningLaw::Hestroffer,
                    {440.0 * nanometre, 550.0 * nanometre, 680.0 * nanometre, 800.0 * nanometre});
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  long bad = 0;
  for (int i = 0; i < 10000000; ++i) {
    double sun = 1e-5 + 0.02 * unit(random);
    double extreme = sun * std::exp2(60.0 * unit(random) - 40.0);
    double share = unit(random);
    double occulter = extreme, separation = 0.0;
    switch (i % 8) {
      case 0:
        occulter = sun, separation = 2.2 * sun * share;
        break;
      case 1:
        separation = std::fabs(occulter - sun);
        break;
      case 2:
        separation = occulter + sun;
        break;
      case 3:
        separation = 0.0;
        break;
      case 4:
        occulter = 0.0, separation = sun * share;
        break;
      case 5:
        separation = std::max(occulter + sun * (2.0 * share - 1.0), 0.0);
        break;
      case 6:
        occulter = sun * (0.9 + 0.2 * share), separation = extreme;
        break;
      default:
        separation = sun * std::exp2(60.0 * share - 40.0);
        break;
    }
    glsl::DiscPair pair = glsl::discsFromAngles(sun, occulter, separation);
    double uniform = glsl::visibleFractionUniform(pair);
    bad += !(uniform >= 0.0 && uniform <= 1.0 + 1e-9);
    glm::dvec4 light = glsl::visibleFraction(pair, law);
    bad += !(light.x >= 0.0 && light.x <= 1.0 + 1e-9 && light.w >= 0.0 && light.w <= 1.0 + 1e-9);
    if (bad != 0) {
      ADD_FAILURE() << sun << " " << occulter << " " << separation << ": " << uniform << " "
                    << light.x;
      return;
    }
  }
}

TEST(VisibleFraction, FallsAsTheGapCloses) {
  glsl::LimbDarkening law =
      limbDarkening(LimbDarkeningLaw::Hestroffer,
                    {440.0 * nanometre, 550.0 * nanometre, 680.0 * nanometre, 800.0 * nanometre});
  for (double excess : {-0.03, 0.0, 0.03, 2.7}) {
    double before = 1.0;
    for (double gap = 2.0; gap > std::max(0.0, -2.0 * excess); gap -= 1e-3) {
      double light = glsl::visibleFraction(discs({excess, gap}), law).y;
      // Where the two sums join, a step of their error is allowed: 2e-4 of the light.
      EXPECT_LE(light, before * (1.0 + 2e-4)) << excess << " " << gap;
      before = light;
    }
  }
}

}  // namespace
}  // namespace antumbra
