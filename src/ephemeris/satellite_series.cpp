#include "ephemeris/satellite_series.h"

#include <fmt/format.h>

#include <cmath>
#include <cstring>

namespace antumbra {
namespace {
constexpr double kJ2000 = 2451545.0;
}

Span SatelliteSeries::span() const {
  return {Instant::fromTdb({kJ2000, middleTdbDays - halfSpanDays}),
          Instant::fromTdb({kJ2000, middleTdbDays + halfSpanDays})};
}

bool SatelliteSeries::covers(double tdbDays) const {
  return std::fabs(tdbDays - middleTdbDays) <= halfSpanDays;
}

State SatelliteSeries::state(double tdbDays, bool extrapolate) const {
  if (!extrapolate && !covers(tdbDays))
    throw SpanError("the series of " + body, Instant::fromTdb({kJ2000, tdbDays}), span(), true);
  double const d = tdbDays - middleTdbDays, t = d / halfSpanDays;
  double warp = 0.0, warpRate = 0.0;  // of the drift, per unit of t
  for (int k = 3; k >= 0; --k) {
    warpRate += (k + 2) * drift[k] * std::pow(t, k + 1);
    warp += drift[k] * std::pow(t, k + 2);
  }
  double const tau = d + warp, tauRate = 1.0 + warpRate / halfSpanDays;
  double powers[9] = {1.0};
  for (int k = 1; k < 9; ++k) powers[k] = powers[k - 1] * t;
  glm::dvec3 place(0.0), rate(0.0);
  for (std::size_t i = 0; i < termCount; ++i) {
    const Term& term = terms[i];
    double const angle = term.radiansPerDay * tau;
    double const c = std::cos(angle), s = std::sin(angle);
    glm::dvec3 const a(term.cosineKm[0], term.cosineKm[1], term.cosineKm[2]);
    glm::dvec3 const b(term.sineKm[0], term.sineKm[1], term.sineKm[2]);
    glm::dvec3 const wave = c * a + s * b;
    place += powers[term.power] * wave;
    rate += powers[term.power] * term.radiansPerDay * tauRate * (c * b - s * a);
    if (term.power > 0) rate += term.power * powers[term.power - 1] / halfSpanDays * wave;
  }
  return {{1000.0 * place}, {1000.0 / 86400.0 * rate}};
}

SatelliteCatalogue::SatelliteCatalogue(const std::filesystem::path& path)
    : file_(path, "ANTMOON1", "tools/build_moon_catalogue") {
  struct Entry {
    char body[24], centre[24];
    double first, last, drift[4];
    std::uint32_t terms;
    float residualKm;
    std::uint64_t offset, unused[2];
  };
  static_assert(sizeof(Entry) == 128 && sizeof(SatelliteSeries::Term) == 40);
  for (const auto& e : file_.entries<Entry>()) {
    SatelliteSeries s;
    s.body = nameIn(e.body);
    s.centre = nameIn(e.centre);
    s.middleTdbDays = 0.5 * (e.first + e.last) - kJ2000;
    s.halfSpanDays = 0.5 * (e.last - e.first);
    std::copy(std::begin(e.drift), std::end(e.drift), s.drift);
    s.termCount = e.terms;
    s.residual = double{e.residualKm} * kilometre;
    if (e.offset % 8 != 0 || !(s.halfSpanDays > 0.0))
      throw file_.broken(fmt::format("entry {} is misshapen", s.body));
    s.terms = reinterpret_cast<const SatelliteSeries::Term*>(
        file_.at(e.offset, e.terms * sizeof(SatelliteSeries::Term), s.body));
    for (std::size_t k = 0; k < s.termCount; ++k)
      if (s.terms[k].power > 8) throw file_.broken(fmt::format("{} has a power above 8", s.body));
    series_.push_back(std::move(s));
  }
}

const SatelliteSeries* SatelliteCatalogue::find(const std::string& body) const {
  for (const auto& s : series_)
    if (s.body == body) return &s;
  return nullptr;
}

}  // namespace antumbra
