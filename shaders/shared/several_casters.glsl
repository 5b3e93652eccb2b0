// Several bodies before the Sun at once: what the union of their discs leaves visible.
//
// By Green's theorem the hidden light is an integral along the boundary of the union inside the Sun:
// the free arcs of each limb, and the covered arcs of the Sun's own. For a uniform disc every arc is a
// closed form, exact for any number of circles; limb darkening adds the difference between the light
// and the area inside a ring, which is small and smooth, by Gauss-Legendre nodes along the arcs.
// Measured against rays for two to six discs (tests/eclipse/several_casters_test.cpp): within 3e-4 of
// the whole Sun, which is the rays' own error; in floats within 5e-5 of doubles. The least of the
// single lights errs by up to 0.55, their product by up to 0.28. Relative precision near totality is
// not kept: a crescent that one caster leaves alone is visibleFraction's.
#ifndef SHARED_SEVERAL_CASTERS_GLSL
#define SHARED_SEVERAL_CASTERS_GLSL
#include "shared/eclipse.glsl"

SunCover noCover() {
  SunCover cover;
  cover.count = 0;
  for (Index i = 0; i < kMostDiscs; i = i + 1) {
    cover.radius[i] = 0.0;
    cover.away[i] = 0.0;
    cover.turn[i] = 0.0;
  }
  return cover;
}

// With one more disc, unless it leaves the Sun free or there are kMostDiscs already. A limb a
// thousand times as wide as the Sun is as good as straight.
SunCover withDisc(SunCover cover, DiscPair discs, Angle turn) {
  Number excess = min(discs.excess / discs.sun, 1000.0);
  Number gap = discs.gap / discs.sun;
  if (gap >= 2.0 || excess <= -1.0 || cover.count >= kMostDiscs) {
    return cover;
  }
  SunCover more = cover;
  more.radius[cover.count] = 1.0 + excess;
  more.away[cover.count] = max(gap + excess, 0.0);
  more.turn[cover.count] = turn;
  more.count = cover.count + 1;
  return more;
}

// Direction in which the caster's limb stands from the Sun's centre, in the receiver's space: across
// the line to the Sun, not of unit length.
Direction limbDirection(ShadowPair pair, ShadowPlace place) {
  return inCasterSpace(pair, place.away);
}

// Angle about the line of sight from `first` to `second`.
Angle turnBetween(ShadowPair pair, Direction first, Direction second) {
  Direction sight = normalize(fromCasterSpace(pair, pair.axis));
  return atan(dot(cross(first, second), sight), dot(first, second));
}

// Half of the angle, about its centre, of the part of a circle that lies inside another one whose
// centre is `distance` away: 0 none, pi all.
Angle halfArcInside(Number radius, Number other, Number distance) {
  Number above = (other - radius + distance) * (other + radius - distance);
  Number below = (radius + distance - other) * (radius + distance + other);
  if (below <= 0.0) {
    return kPi;
  }
  return 2.0 * atan(sqrt(max(above, 0.0)), sqrt(below));
}

Angle withinHalfTurn(Angle angle) { return angle - 2.0 * kPi * floor(angle / (2.0 * kPi) + 0.5); }

// Difference of the light inside a ring and the uniform disc's, along an arc of a circle of `radius`
// whose centre is `away` from the Sun's; the angle is 0 toward the Sun's centre.
Spectrum darkeningAlongArc(LimbDarkening law, Number radius, Number away, Angle from, Angle to) {
  Spectrum sum = Spectrum(0.0);
  Index panels = 2;
  if (to - from > 1.5) {
    panels = 4;
  }
  Angle reach = 0.5 * (to - from) / Number(panels);
  for (Index panel = 0; panel < panels; panel = panel + 1) {
    Angle middle = from + reach * (2.0 * Number(panel) + 1.0);
    for (Index i = 0; i < 4; i = i + 1) {
      Number node = 0.861136311594053;
      Number weight = 0.347854845137454;
      if (i == 1 || i == 2) {
        node = 0.339981043584856;
        weight = 0.652145154862546;
      }
      if (i < 2) {
        node = -node;
      }
      Angle t = middle + reach * node;
      Number sine = sin(0.5 * t);
      Number square = (radius - away) * (radius - away) + 4.0 * radius * away * sine * sine;
      Number cosineSquared = clamp(1.0 - square, 0.0, 1.0);
      Number sweep = radius * ((radius - away) + 2.0 * away * sine * sine) / max(square, 1e-6);
      sum = sum + (Spectrum(cosineSquared) - lightOutsideRing(law, cosineSquared)) *
                      (weight * reach * sweep);
    }
  }
  return sum;
}

// Visible light past all discs of a cover.
Spectrum visibleFractionOfUnion(SunCover cover, LimbDarkening law) {
  Number area = 0.0;  // twice the hidden area
  Spectrum darkening = Spectrum(0.0);
  // The last circle is the Sun itself.
  for (Index i = 0; i <= cover.count; i = i + 1) {
    bool sun = i == cover.count;
    Number radius = 1.0;
    Number away = 0.0;
    Angle turn = -kPi;
    Angle inside = kPi;  // half of the arc inside the Sun
    if (!sun) {
      radius = cover.radius[i];
      away = cover.away[i];
      turn = cover.turn[i];
      if (radius >= 1.0 + away) {
        return Spectrum(0.0);
      }
      inside = halfArcInside(radius, 1.0, away);
    }
    // What the other discs cover of this circle, as the middle and half of an arc; and the ends of
    // all arcs in order.
    Angle middle[6];
    Angle reach[6];
    Angle ends[14];
    Index count = 2;
    ends[0] = -inside;
    ends[1] = inside;
    for (Index j = 0; j < cover.count; j = j + 1) {
      middle[j] = 0.0;
      reach[j] = 0.0;
      if (j == i) {
        continue;
      }
      Angle apart = cover.turn[j] - turn;
      Number x = away - cover.away[j] * cos(apart);
      Number y = -cover.away[j] * sin(apart);
      Number distance = sqrt(x * x + y * y);
      bool same = distance == 0.0 && cover.radius[j] == radius;
      if (!same || j < i) {
        reach[j] = halfArcInside(radius, cover.radius[j], distance);
      }
      if (distance > 0.0) {
        middle[j] = atan(y, x);
      }
      if (reach[j] > 0.0 && reach[j] < kPi) {
        ends[count] = clamp(withinHalfTurn(middle[j] - reach[j]), -inside, inside);
        ends[count + 1] = clamp(withinHalfTurn(middle[j] + reach[j]), -inside, inside);
        count = count + 2;
      }
    }
    for (Index a = 1; a < count; a = a + 1) {
      for (Index b = a; b > 0; b = b - 1) {
        Angle low = min(ends[b - 1], ends[b]);
        ends[b] = max(ends[b - 1], ends[b]);
        ends[b - 1] = low;
      }
    }
    for (Index k = 0; k + 1 < count; k = k + 1) {
      Angle from = ends[k];
      Angle to = ends[k + 1];
      bool covered = false;
      for (Index j = 0; j < cover.count; j = j + 1) {
        if (abs(withinHalfTurn(0.5 * (from + to) - middle[j])) < reach[j]) {
          covered = true;
        }
      }
      if (to <= from || covered != sun) {
        continue;
      }
      if (sun) {
        area = area + (to - from);
      } else {
        area = area + radius * (radius * (to - from) - away * (sin(to) - sin(from)));
        darkening = darkening + darkeningAlongArc(law, radius, away, from, to);
      }
    }
  }
  return clamp(Spectrum(1.0 - area / (2.0 * kPi)) - darkening / (2.0 * kPi), 0.0, 1.0);
}
#endif
