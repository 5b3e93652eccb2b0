// Constants of nature and of convention, each with its source.
#pragma once

#include "quantity/quantity.h"

namespace antumbra {

// SI definition: exact.
inline constexpr Speed kSpeedOfLight{299792458.0};
// IAU 2015 Resolution B3, nominal solar radius.
inline constexpr Length kSolarRadiusIau{695700e3};
// Auwers' 959.63" at 1 au, the value of the published eclipse canons (Espenak & Meeus,
// NASA/TP-2006-214141).
inline constexpr Angle kSolarSemidiameterCanon{959.63 * arcsecond.si};
// Moon's radius in Earth's equatorial radii: IAU 1982; Espenak & Meeus penumbra and umbra.
inline constexpr double kLunarKIau = 0.2725076;
inline constexpr double kLunarKPenumbraNasa = 0.272488;
inline constexpr double kLunarKUmbraNasa = 0.272281;
// WGS84 (NGA.STND.0036 1.0.0): equatorial radius and flattening.
inline constexpr Length kEarthEquatorialRadius{6378137.0};
inline constexpr double kEarthFlattening = 1.0 / 298.257223563;

}  // namespace antumbra
