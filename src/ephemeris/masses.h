// Mass ratios of the solar system: Folkner, Williams, Boggs, Park & Kuchynka 2014, "The planetary
// and lunar ephemerides DE430 and DE431", IPN Progress Report 42-196, table 8.
#pragma once

namespace antumbra {

// Sun over each planetary system, Mercury to Neptune (Earth with its Moon), and Pluto's.
inline constexpr double kSunOverSystemMass[8] = {6023682.155592, 408523.718658,  328900.559708565,
                                                 3098703.590291, 1047.348625463, 3497.901767787,
                                                 22902.981613,   19412.259776};
inline constexpr double kSunOverPlutoMass = 135836683.768617;
// Of DE430/431 (Folkner et al. 2014, IPN Progress Report 42-196), to which the tables belong; DE440
// has 81.30056822, which moves the Earth by 5 cm.
inline constexpr double kEarthOverMoonMass = 81.30056907419062;
// Heliocentric gravitational radius GM/c^2 in metres: IAU 2015 B3, GM = 1.3271244e20 m^3/s^2.
inline constexpr double kSolarGravitationalRadiusMetres =
    1.3271244e20 / (299792458.0 * 299792458.0);

}  // namespace antumbra
