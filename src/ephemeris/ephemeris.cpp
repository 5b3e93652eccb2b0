#include "ephemeris/ephemeris.h"

#include <fmt/format.h>

#include "document/paths.h"
#include "ephemeris/masses.h"
#include "ephemeris/tiers.h"

namespace antumbra {
namespace {

std::filesystem::path catalogue(const char* name) { return catalogsFolder() / "ephemeris" / name; }

std::optional<Planet> planetOf(BodyId body) {
  switch (body) {
    case BodyId::Mercury:
      return Planet::Mercury;
    case BodyId::Venus:
      return Planet::Venus;
    case BodyId::Mars:
      return Planet::Mars;
    case BodyId::Jupiter:
    case BodyId::JupiterBarycentre:
      return Planet::Jupiter;
    case BodyId::Saturn:
    case BodyId::SaturnBarycentre:
      return Planet::Saturn;
    case BodyId::Uranus:
    case BodyId::UranusBarycentre:
      return Planet::Uranus;
    case BodyId::Neptune:
    case BodyId::NeptuneBarycentre:
      return Planet::Neptune;
    default:
      return std::nullopt;
  }
}

bool isPluto(BodyId body) { return body == BodyId::Pluto || body == BodyId::PlutoBarycentre; }

constexpr double kEarthShare = 1.0 / (1.0 + kEarthOverMoonMass);  // Moon's mass over both

Instant startOfYear(long year) {
  return Instant::fromTt({static_cast<double>(julianDayNumber({year, 1, 1})) - 0.5, 0.0});
}

// Arcseconds by which the full series differ from DE431 as seen from the Earth, at most: measured
// by tests/ephemeris/ephemeris_test.cpp over 1900-2100, and per millennium from -3000 to 3000.
struct Floor {
  BodyId body;
  double present;       // 1900-2100
  double millennia[6];  // -3000..-2000, ... , 2000..3000
};
constexpr Floor kFloors[] = {
#include "ephemeris/series_floor.inc"
};

}  // namespace

struct Ephemeris::Tables {
  TableCatalogue file{catalogue("de431.bin")};
  const ChebyshevBody& sun = file.body("Sun");
  const ChebyshevBody& emb = file.body("EarthMoonBarycentre");
  const ChebyshevBody& moon = file.body("Moon");
  const ChebyshevBody& mercury = file.body("Mercury");
  const ChebyshevBody& venus = file.body("Venus");
  const ChebyshevBody& mars = file.body("Mars");
  const ChebyshevBody& jupiter = file.body("JupiterBarycentre");
  const ChebyshevBody& saturn = file.body("SaturnBarycentre");
  const ChebyshevBody& uranus = file.body("UranusBarycentre");
  const ChebyshevBody& neptune = file.body("NeptuneBarycentre");
  const ChebyshevBody& pluto = file.body("PlutoBarycentre");

  // Relative to the Sun if `heliocentric`, else to the solar-system barycentre.
  const ChebyshevBody* planet(BodyId body, bool* heliocentric) const {
    *heliocentric = false;
    switch (body) {
      case BodyId::Mercury:
        *heliocentric = true;
        return &mercury;
      case BodyId::Venus:
        *heliocentric = true;
        return &venus;
      case BodyId::Mars:
        return &mars;
      case BodyId::Jupiter:
      case BodyId::JupiterBarycentre:
        return &jupiter;
      case BodyId::Saturn:
      case BodyId::SaturnBarycentre:
        return &saturn;
      case BodyId::Uranus:
      case BodyId::UranusBarycentre:
        return &uranus;
      case BodyId::Neptune:
      case BodyId::NeptuneBarycentre:
        return &neptune;
      case BodyId::Pluto:
      case BodyId::PlutoBarycentre:
        return &pluto;
      default:
        return nullptr;
    }
  }
};

namespace {

// Places relative to the Sun out of the table, each piece evaluated at most once.
class TableInstant {
 public:
  template <class Tables>
  TableInstant(const Tables& tables, double days)
      : days_(days), sun_(&tables.sun), emb_(&tables.emb), moon_(&tables.moon) {}
  const State& sun() { return once(sunState_, *sun_); }     // from the solar-system barycentre
  const State& moon() { return once(moonState_, *moon_); }  // from the Earth
  const State& emb() { return once(embState_, *emb_); }     // from the Sun
  State earth() { return emb() - kEarthShare * moon(); }

 private:
  const State& once(std::optional<State>& kept, const ChebyshevBody& body) {
    if (!kept) kept = body.state(days_);
    return *kept;
  }
  double days_;
  const ChebyshevBody *sun_, *emb_, *moon_;
  std::optional<State> sunState_, moonState_, embState_;
};

template <class Tables>
State tableHeliocentric(const Tables& tables, TableInstant& at, BodyId body, double days) {
  bool heliocentric = false;
  if (const auto* planet = tables.planet(body, &heliocentric))
    return heliocentric ? planet->state(days) : planet->state(days) - at.sun();
  switch (body) {
    case BodyId::Earth:
      return at.earth();
    case BodyId::Moon:
      return at.earth() + at.moon();
    case BodyId::EarthMoonBarycentre:
      return at.emb();
    case BodyId::SolarSystemBarycentre:
      return -1.0 * at.sun();
    default:
      return {};
  }
}

// Earth, Moon and their barycentre among themselves, so that no digits are lost to the Sun's
// distance.
std::optional<double> shareOfMoonVector(BodyId body) {
  if (body == BodyId::Earth) return 0.0;
  if (body == BodyId::Moon) return 1.0;
  if (body == BodyId::EarthMoonBarycentre) return kEarthShare;
  return std::nullopt;
}

}  // namespace

const Ephemeris& Ephemeris::standard() {
  static const Ephemeris ephemeris{Options{}};
  return ephemeris;
}

Ephemeris::~Ephemeris() = default;

Ephemeris::Ephemeris(Options options) : options_(options) {
  if (options.theory != Theory::Table) {
    planetCatalogue_ = std::make_shared<SeriesCatalogue>(catalogue("vsop87b.bin"));
    moonCatalogue_ = std::make_shared<SeriesCatalogue>(catalogue("elpmpp02.bin"));
    moon_ = moonSeries(*moonCatalogue_);
    for (int i = 0; i < kPlanets; ++i)
      planets_[static_cast<std::size_t>(i)] =
          planetSeries(*planetCatalogue_, static_cast<Planet>(i));
    if (options.error) truncate(*options.error);
  }
  if (options.theory != Theory::Series) tables_ = std::make_shared<Tables>();
  satellites_ = std::make_shared<SatelliteCatalogue>(catalogue("moons.bin"));
  for (BodyId body : allBodies())
    if (systemOf(body) != body)
      satelliteOf_.at(static_cast<std::size_t>(body)) = satellites_->find(nameOf(body));
}

void Ephemeris::truncate(Angle error) {
  if (!(error.si > 0.0))
    throw InputError(
        fmt::format("error: found {} arcsec; allowed: a positive angle", error / arcsecond));
  for (TierSpan span : {TierSpan::NearPresent, TierSpan::Whole}) {
    auto& sets = truncated_[static_cast<std::size_t>(span)];
    for (int i = 0; i <= kPlanets; ++i) {
      // The Earth's row is the Sun's: the same vector seen from the other end.
      std::string const name = i == kPlanets ? "Moon"
                               : i == static_cast<int>(Planet::Earth)
                                   ? "Sun"
                                   : nameOf(static_cast<Planet>(i));
      auto const tier = tierFor(name, span, error);
      TruncatedSeries set{
          planets_, moon_, tier.thresholdRadians, tier.maxErrorArcseconds * arcsecond, {}};
      for (int k = 0; k < kPlanets; ++k) {
        auto const dropped =
            antumbra::truncate(set.planets[static_cast<std::size_t>(k)], static_cast<Planet>(k),
                               tier.thresholdRadians, span);
        if (k == i) set.droppedSum = dropped;
      }
      auto const moonTier = i == kPlanets ? tier : tierFor("Moon", span, error);
      auto const dropped = antumbra::truncate(set.moon, moonTier.thresholdRadians, span);
      if (i == kPlanets) set.droppedSum = dropped;
      sets.push_back(std::move(set));
    }
  }
}

const TruncatedSeries* Ephemeris::truncated(BodyId target, Instant t) const {
  if (!options_.error || truncated_[0].empty()) return nullptr;
  auto const& sets = truncated_[std::fabs(t.ttCenturiesSinceJ2000()) <= 1.0 ? 0 : 1];
  if (target == BodyId::Moon) return &sets[kPlanets];
  if (auto const planet = planetOf(target)) return &sets[static_cast<std::size_t>(*planet)];
  return &sets[static_cast<std::size_t>(Planet::Earth)];
}

Span Ephemeris::tableSpan() {
  static const Span span{startOfYear(1800), startOfYear(2400)};
  return span;
}

Span Ephemeris::span() const {
  if (options_.theory == Theory::Table) return tableSpan();
  return {startOfYear(-3000), startOfYear(3001)};
}

std::string Ephemeris::nameOfTheory(Theory theory) {
  return theory == Theory::Table    ? "de431-table"
         : theory == Theory::Series ? "vsop87+elpmpp02"
                                    : "auto";
}

Theory Ephemeris::theoryAt(Instant t) const {
  if (tables_ && tableSpan().covers(t)) return Theory::Table;
  if (options_.theory == Theory::Table) throw SpanError("the DE431 table", t, tableSpan());
  if (!options_.extrapolate && !span().covers(t))
    throw SpanError("VSOP87 and ELP/MPP02", t, span(), true);
  return Theory::Series;
}

std::string Ephemeris::theoryName(BodyId target, BodyId centre, Instant t) const {
  Theory const theory = theoryAt(t);
  bool fitted = false, outside = theory == Theory::Series && !span().covers(t);
  for (BodyId body : {target, centre}) {
    const auto* series = satelliteOf_[static_cast<std::size_t>(body)];
    if (!series) continue;
    bool const covered = series->covers(t.tdbDaysSinceJ2000());
    fitted = fitted || covered || isSatellite(body);
    outside = outside || (isSatellite(body) && !covered);
  }
  return nameOfTheory(theory) + (fitted ? "+moons-fit" : "") + (outside ? "+extrapolated" : "");
}

Angle Ephemeris::errorBound(BodyId target, BodyId centre, Instant t) const {
  Angle bound = untruncatedErrorBound(target, centre, t);
  if (theoryAt(t) != Theory::Table)
    if (const auto* cut = truncated(target, t)) bound += kTierMargin * cut->measuredError;
  return bound;
}

Angle Ephemeris::untruncatedErrorBound(BodyId target, BodyId centre, Instant t) const {
  Angle largest;
  bool const table = theoryAt(t) == Theory::Table;
  for (BodyId body : {systemOf(target), systemOf(centre)}) {
    if (table) {
      bool const far = isPluto(body) || body == BodyId::Uranus ||
                       body == BodyId::UranusBarycentre || body == BodyId::Neptune ||
                       body == BodyId::NeptuneBarycentre;
      largest = std::max(largest, (far ? 0.02 : 0.005) * arcsecond);
      continue;
    }
    double const year = t.julianYear();
    for (const auto& floor : kFloors) {
      bool const sameBody =
          floor.body == body || (planetOf(body) && planetOf(body) == planetOf(floor.body));
      if (!sameBody) continue;
      auto const millennium =
          static_cast<std::size_t>(std::clamp((year + 3000.0) / 1000.0, 0.0, 5.0));
      double const value =
          year >= 1900.0 && year <= 2100.0 ? floor.present : floor.millennia[millennium];
      largest = std::max(largest, value * arcsecond);
    }
  }
  for (BodyId body : {target, centre}) {
    const auto* series = satelliteOf_[static_cast<std::size_t>(body)];
    if (!series || target == centre) continue;
    double const distance = glm::length(state(target, centre, t).position.m);
    bool const covered = series->covers(t.tdbDaysSinceJ2000());
    // Outside its series a planet's centre may lie this far from the barycentre.
    double const metres =
        covered ? series->residual / metre
        : isSatellite(body)
            ? 2.0 * glm::length(withinSystem(body, t.tdbDaysSinceJ2000()).position.m)
        : body == BodyId::Pluto  ? 2.2e6
        : body == BodyId::Saturn ? 3.1e5
                                 : 2.3e5;
    largest += metres / distance * radian;
  }
  return largest;
}

State Ephemeris::sunFromBarycentre(double tdbDays,
                                   const std::array<PlanetSeries, kPlanets>& planets,
                                   const MoonSeries& moon) const {
  // Pluto and the asteroids are left out: 50 km, and 1e-7 m/s in the velocity.
  State sum;
  double mass = 1.0;
  for (std::size_t i = 0; i < kPlanets; ++i) {
    double const m = 1.0 / kSunOverSystemMass[i];
    State s = planets[i].state(tdbDays);
    if (i == static_cast<std::size_t>(Planet::Earth)) s = s + kEarthShare * moon.state(tdbDays);
    sum = sum + m * s;
    mass += m;
  }
  return -1.0 / mass * sum;
}

State Ephemeris::heliocentric(BodyId body, double tdbDays,
                              const std::array<PlanetSeries, kPlanets>& planets,
                              const MoonSeries& moon) const {
  if (auto const planet = planetOf(body))
    return planets[static_cast<std::size_t>(*planet)].state(tdbDays);
  auto const earth = [&] {
    return planets[static_cast<std::size_t>(Planet::Earth)].state(tdbDays);
  };
  switch (body) {
    case BodyId::Earth:
      return earth();
    case BodyId::Moon:
      return earth() + moon.state(tdbDays);
    case BodyId::EarthMoonBarycentre:
      return earth() + kEarthShare * moon.state(tdbDays);
    case BodyId::SolarSystemBarycentre:
      return -1.0 * sunFromBarycentre(tdbDays, planets, moon);
    default:
      return {};  // the Sun
  }
}

State Ephemeris::fromSeries(BodyId target, BodyId centre, Instant t) const {
  if (isPluto(target) || isPluto(centre))
    throw SpanError("Pluto (DE431 table only)", t, tableSpan());
  double const days = t.tdbDaysSinceJ2000();
  const auto* cut = truncated(target == BodyId::Sun ? centre : target, t);
  auto const& planets = cut ? cut->planets : planets_;
  auto const& moon = cut ? cut->moon : moon_;
  return heliocentric(target, days, planets, moon) - heliocentric(centre, days, planets, moon);
}

State Ephemeris::state(BodyId target, BodyId centre, Instant t) const {
  State out;
  // Not the virtual one: a cache asks its source through this function.
  Ephemeris::states(std::span(&target, 1), centre, t, std::span(&out, 1));
  return out;
}

State Ephemeris::withinSystem(BodyId body, double tdbDays) const {
  const auto* series = satelliteOf_[static_cast<std::size_t>(body)];
  if (!series) return {};
  if (!isSatellite(body)) return series->covers(tdbDays) ? series->state(tdbDays, false) : State{};
  // The moons' series are relative to the planet's centre, that to the barycentre.
  State const moon = series->state(tdbDays, options_.extrapolate);
  auto const planet = bodyFromName(series->centre);
  return planet && *planet != systemOf(body) ? moon + withinSystem(*planet, tdbDays) : moon;
}

void Ephemeris::states(std::span<const BodyId> targets, BodyId centre, Instant t,
                       std::span<State> out) const {
  bool const plain =
      systemOf(centre) == centre && std::all_of(targets.begin(), targets.end(),
                                                [](BodyId body) { return systemOf(body) == body; });
  if (plain) return systemStates(targets, centre, t, out);
  double const days = t.tdbDaysSinceJ2000();
  State const origin = withinSystem(centre, days);
  for (std::size_t i = 0; i < targets.size(); ++i) {
    out[i] = {};
    if (targets[i] == centre) continue;
    // Within one system the long way over the Sun is never taken: no digits are lost.
    BodyId const system = systemOf(targets[i]);
    if (system != systemOf(centre))
      systemStates(std::span(&system, 1), systemOf(centre), t, out.subspan(i, 1));
    out[i] = out[i] + withinSystem(targets[i], days) - origin;
  }
}

void Ephemeris::systemStates(std::span<const BodyId> targets, BodyId centre, Instant t,
                             std::span<State> out) const {
  bool const table = theoryAt(t) == Theory::Table;
  double const days = t.tdbDaysSinceJ2000();
  auto const centreShare = shareOfMoonVector(centre);
  std::optional<State> centreState;
  if (table) {
    TableInstant at(*tables_, days);
    for (std::size_t i = 0; i < targets.size(); ++i) {
      auto const share = shareOfMoonVector(targets[i]);
      if (targets[i] == centre) {
        out[i] = {};
      } else if (share && centreShare) {
        out[i] = (*share - *centreShare) * at.moon();
      } else {
        if (!centreState) centreState = tableHeliocentric(*tables_, at, centre, days);
        out[i] = tableHeliocentric(*tables_, at, targets[i], days) - *centreState;
      }
    }
    return;
  }
  for (std::size_t i = 0; i < targets.size(); ++i) {
    auto const share = shareOfMoonVector(targets[i]);
    if (targets[i] == centre) {
      out[i] = {};
    } else if (share && centreShare) {
      const auto* cut = truncated(BodyId::Moon, t);
      out[i] = (*share - *centreShare) * (cut ? cut->moon : moon_).state(days);
    } else if (options_.error) {
      out[i] = fromSeries(targets[i], centre, t);
    } else {
      if (isPluto(targets[i]) || isPluto(centre))
        throw SpanError("Pluto (DE431 table only)", t, tableSpan());
      if (!centreState) centreState = heliocentric(centre, days, planets_, moon_);
      out[i] = heliocentric(targets[i], days, planets_, moon_) - *centreState;
    }
  }
}

}  // namespace antumbra
