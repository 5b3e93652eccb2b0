// Positions as rows of a table: what `antumbra ephemeris` prints, without the command line.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "ephemeris/apparent.h"
#include "geodesy/refraction.h"

namespace antumbra {

enum class OutputFrame {
  Icrf,
  EquatorJ2000,
  EclipticJ2000,
  Itrf,
  EquatorialOfDate,
  EclipticOfDate,
  Horizontal,
};
enum class CorrectionLevel { Geometric, LightTime, Astrometric, Apparent };

// A body as the command names it: "Jupiter" is the barycentre of the system there.
struct NamedBody {
  std::string name;
  BodyId id = BodyId::Sun;
};
// "Sun,Moon,Jupiter.center"; "all" is Sun, Moon, Mercury to Pluto. Throws InputError.
std::vector<NamedBody> bodiesFromList(const std::string& list, const std::string& where);
NamedBody bodyFromCommandName(const std::string& name, const std::string& where);

// An instant, the text of the Julian date that stands for it in the output, and for errors where
// it was given ("FILE:LINE", "-:LINE" or options) and how ("1e6 UT1").
struct Epoch {
  Instant instant;
  std::string julianDate, source, given;
};
// One Julian date per line, '#' comments; "-" is standard input. Throws InputError with file and
// line; an input without any date is an error.
std::vector<Epoch> epochsFromFile(const std::string& file, TimeScale scale, const DeltaT& deltaT,
                                  const std::string& where);
// From first to last, both included, every `step`.
std::vector<Epoch> epochsFromRange(Instant first, Instant last, Duration step, TimeScale scale,
                                   const DeltaT& deltaT);

struct EphemerisRequest {
  std::vector<NamedBody> bodies;
  NamedBody centre{"Earth", BodyId::Earth};
  std::optional<Site> site;
  OutputFrame frame = OutputFrame::Icrf;
  CorrectionLevel correction = CorrectionLevel::Geometric;
  std::optional<SurfaceAir> refraction;
  DeltaT deltaT = DeltaT::standard();
};

// One body at one epoch. `values` follow valueColumns().
struct EphemerisRow {
  const Epoch* epoch = nullptr;
  const NamedBody* body = nullptr;
  std::vector<double> values;
  std::string theory;
  double errorBoundArcseconds = 0.0;
};

// Names with units, in order; and how many decimals each is printed with.
struct Column {
  std::string name;
  int decimals = 9;
};
std::vector<Column> valueColumns(const EphemerisRequest& request);
// Throws InputError naming the epoch's source where a theory does not reach it.
std::vector<EphemerisRow> ephemerisRows(const Ephemeris& ephemeris, const EphemerisRequest& request,
                                        const std::vector<Epoch>& epochs);

// One line for each body of which a row states a larger error than `requested`: the first such
// date, what its row states and what every term would reach.
std::vector<std::string> unmetErrors(const Ephemeris& ephemeris, const EphemerisRequest& request,
                                     const std::vector<EphemerisRow>& rows, Angle requested);

}  // namespace antumbra
