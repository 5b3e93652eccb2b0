// Which radii of Sun and Moon cast shadows: conventions differ, and totality lasts longer or
// shorter with them, so that every output names its own.
//   iau   Sun 695 700 km (IAU 2015 Resolution B3), Moon k = 0.2725076 (IAU 1982)
//   nasa  Sun 959.63" at 1 au; Moon k = 0.272281 for the umbra, 0.272488 for the penumbra (Espenak
//   &
//         Meeus, NASA/TP-2006-214141)
// The Moon is a smooth sphere in both: its real limb shifts contacts by up to 3 s.
#pragma once

#include <string>

#include "eclipse/shadow_pair.h"
#include "quantity/quantity.h"

namespace antumbra {

struct ShadowConvention {
  std::string name;
  Length sunRadius;
  double lunarKUmbra = 0.0;  // in equatorial radii of the Earth
  double lunarKPenumbra = 0.0;

  // "iau" or "nasa". Throws InputError that opens with `where` and lists what is allowed.
  static ShadowConvention named(const std::string& name, const std::string& where);
  // The Moon by k; any other caster by its catalogued radius.
  ShadowRadii radiiOf(const std::string& caster, Length cataloguedRadius) const;
};

}  // namespace antumbra
