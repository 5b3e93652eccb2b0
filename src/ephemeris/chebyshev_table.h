// Tabulated bodies: JPL DE431, 1800-2400, as quantised Chebyshev segments in a mapped catalogue
// (layout and accuracy: tools/build_table_catalogue). One evaluation reads one segment.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ephemeris/mapped_catalogue.h"
#include "ephemeris/state.h"

namespace antumbra {

// One body's segments, relative to its centre, along Icrs.
struct ChebyshevBody {
  std::string body, centre;
  double firstJulianDate = 0.0;  // TDB
  double daysPerSegment = 1.0;
  double unitMetres = 1.0;
  std::uint32_t segments = 0, n32 = 0, n16 = 0, n8 = 0;
  const std::byte* data = nullptr;
  std::size_t bytesPerSegment = 0;

  bool covers(double tdbDays) const;  // days of TDB since J2000
  // Requires covers(tdbDays).
  State state(double tdbDays) const;
};

class TableCatalogue {
 public:
  // Throws InputError if the file is missing or its directory is inconsistent.
  explicit TableCatalogue(const std::filesystem::path& file);
  // Throws InputError if the catalogue lacks the body.
  const ChebyshevBody& body(const std::string& name) const;

 private:
  MappedCatalogue file_;
  std::vector<ChebyshevBody> bodies_;
};

// Sum of c[k] T_k(x) and its derivative for three axes at once, by Clenshaw's recurrence; c holds
// x, y, z and one unused number per order.
struct ChebyshevSum {
  glm::dvec3 value, derivative;
};
ChebyshevSum chebyshevSum(const double* c, std::size_t orders, double x);

}  // namespace antumbra
