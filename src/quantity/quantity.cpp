#include "quantity/quantity.h"

#include "quantity/constants.h"
#include "quantity/vector.h"

namespace antumbra {
// Quantities are plain doubles at run time.
static_assert(sizeof(Length) == sizeof(double));
}  // namespace antumbra
