#include "eclipse/contact_instant.h"

#include <fmt/format.h>

#include <cctype>
#include <sstream>

#include "document/input_error.h"
#include "eclipse/local_circumstances.h"

namespace antumbra {

bool looksLikeContact(std::string_view text) {
  return !text.empty() && std::isalpha(static_cast<unsigned char>(text.front())) != 0 &&
         text.substr(0, 3) != "JD ";
}

Instant contactInstant(std::string_view text, const EclipseBasis& basis, const std::string& where) {
  std::istringstream words{std::string(text)};
  std::string name, date, place, more;
  words >> name >> date >> place >> more;
  bool const local = name == "C1" || name == "C2" || name == "max" || name == "C3" || name == "C4";
  bool const global =
      name == "greatest" || name == "P1" || name == "U1" || name == "U4" || name == "P4";
  if ((!local && !global) || date.empty() || !more.empty() || local == place.empty() ||
      (local && place[0] != '@'))
    throw InputError(fmt::format(
        "{}: found \"{}\"; a contact is written \"C2 2027-08-02 @LAT,LON,HEIGHT\" with "
        "C1, C2, max, C3 or C4, or \"greatest 2027-08-02\" with greatest, P1, U1, U4 or P4",
        where, text));
  SolarEvent const event = solarEventOn(basis, date, where);
  std::optional<Instant> found;
  if (local) {
    Site const site = parseSite(std::string_view(place).substr(1), where);
    auto const seen = localCircumstances(event, basis.radii(), site);
    auto const& contact = name == "C1"    ? seen.c1
                          : name == "C2"  ? seen.c2
                          : name == "max" ? seen.maximum
                          : name == "C3"  ? seen.c3
                                          : seen.c4;
    if (contact) found = contact->instant;
    if (!found)
      throw InputError(fmt::format("{}: {} does not occur at {}: the eclipse of {} is {} there",
                                   where, name, place.substr(1), date,
                                   seen.type == "P" ? "partial" : "not seen"));
  } else {
    auto const& e = event.eclipse;
    found = name == "greatest" ? std::optional(e.greatest)
            : name == "P1"     ? e.p1
            : name == "U1"     ? e.u1
            : name == "U4"     ? e.u4
                               : e.p4;
    if (!found)
      throw InputError(fmt::format("{}: {} does not occur: the eclipse of {} is partial everywhere",
                                   where, name, date));
  }
  return *found;
}

}  // namespace antumbra
