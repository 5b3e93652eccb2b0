// Contacts as instants: "C2 2027-08-02 @25.687,32.640" is the second contact there, so that a
// picture can be asked for the predicted moment.
#pragma once

#include <string>
#include <string_view>

#include "eclipse/eclipse_search.h"

namespace antumbra {

// Whether a text is meant as a contact, not as a date: it begins with a letter.
bool looksLikeContact(std::string_view text);

// "NAME DATE @LAT,LON[,HEIGHT]" with NAME one of C1, C2, max, C3, C4; or, without a place, "NAME
// DATE" with NAME one of greatest, P1, U1, U4, P4. DATE is that of greatest eclipse in TT. Throws
// InputError that opens with `where` if the text is not of this form, no eclipse has that date, or
// the contact does not occur there.
Instant contactInstant(std::string_view text, const EclipseBasis& basis, const std::string& where);

}  // namespace antumbra
