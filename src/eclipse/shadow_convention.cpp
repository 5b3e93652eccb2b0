#include "eclipse/shadow_convention.h"

#include <fmt/format.h>

#include "document/input_error.h"
#include "quantity/constants.h"

namespace antumbra {

ShadowConvention ShadowConvention::named(const std::string& name, const std::string& where) {
  if (name == "iau") return {name, kSolarRadiusIau, kLunarKIau, kLunarKIau};
  if (name == "nasa")
    return {name, sin(kSolarSemidiameterCanon) * astronomicalUnit, kLunarKUmbraNasa,
            kLunarKPenumbraNasa};
  throw InputError(fmt::format("{}: found the convention \"{}\"; allowed: iau, nasa", where, name));
}

ShadowRadii ShadowConvention::radiiOf(const std::string& caster, Length cataloguedRadius) const {
  if (caster != "Moon") return {sunRadius, cataloguedRadius, cataloguedRadius};
  return {sunRadius, lunarKUmbra * kEarthEquatorialRadius, lunarKPenumbra * kEarthEquatorialRadius};
}

}  // namespace antumbra
