// Stars: places, motions, brightness and colour, from catalogs/stars (Hipparcos, V < 8).
//
// Positions err by up to 0.25" (the catalogue's steps) beside Hipparcos' own milliarcseconds,
// proper motions by 0.5 mas a year. Motion is uniform along a straight line on the sky's tangent
// plane at J2000.0; radial velocities are not in the catalogue. Annual parallax (under 0.8") is
// left to the caller, who knows where the observer is.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "frame/frames.h"
#include "quantity/vector.h"
#include "time/instant.h"

namespace antumbra {

struct Star {
  int hipparcosNumber = 0;
  Direction<Icrs> directionAtJ2000;  // from the barycentre of the solar system
  AngularRate motionEast;            // proper motion in right ascension, times cos(declination)
  AngularRate motionNorth;
  Angle parallax;
  double magnitudeV = 0.0;
  std::optional<double> colorBv;  // Johnson B-V; a few dozen stars have none
};

// As seen from the barycentre, proper motion applied.
Direction<Icrs> directionAt(const Star& star, Instant t);

struct StarName {
  std::string properName;   // "Sirius"; may be empty
  std::string designation;  // Bayer letter and constellation, "α CMa"; may be empty
};

struct StarCatalogue {
  std::vector<Star> stars;                        // by rising V
  std::map<int, StarName> nameByHipparcosNumber;  // of the stars that have one

  // How many of `stars`, from the start, are of that magnitude or brighter.
  size_t countBrighterThan(double magnitudeV) const;
  // By Hipparcos number or by proper name; throws InputError if there is none.
  const Star& byNumber(int hipparcosNumber) const;
  const Star& byName(const std::string& properName) const;

  // Reads hipparcos_v8.bin and names.csv of a folder (layout: tools/build_stars). Throws
  // InputError, naming the file, if either is missing or malformed.
  static StarCatalogue load(const std::filesystem::path& folder);
};

}  // namespace antumbra
