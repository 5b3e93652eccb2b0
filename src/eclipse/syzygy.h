// Which new and full moons may bring an eclipse, from mean elements: Meeus, Astronomical Algorithms
// (2nd edition), chapters 49 and 54. Times within some minutes between -3000 and 3000; gamma within
// 0.01. The exact work starts from here.
//
// Saros and lunation numbers follow from the count of lunations alone: a Saros is 223, an Inex 358
// lunations; van den Bergh, Periodicity and Variation of Solar (and Lunar) Eclipses, 1955.
#pragma once

#include <vector>

#include "time/instant.h"

namespace antumbra {

enum class EclipseKind { Solar, Lunar };

struct Syzygy {
  EclipseKind kind = EclipseKind::Solar;
  long lunation =
      0;  // of the new moon, counted from 2000 January 6; a full moon's is the one before
  Instant greatest;     // of the eclipse, approximately
  double gamma = 0.0;   // approximately
  double margin = 0.0;  // by how much |gamma| stays below the limit for an eclipse
};

// Syzygies of that kind in [from, to) whose margin is at least -0.06, in order.
std::vector<Syzygy> eclipseCandidates(EclipseKind kind, Instant from, Instant to);

// Brown's lunation number: 1 is the new moon of 1923 January 17.
int brownLunation(long lunation);
int sarosNumber(EclipseKind kind, long lunation);

}  // namespace antumbra
