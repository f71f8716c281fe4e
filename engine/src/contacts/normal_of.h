#pragma once

#include "contacts/contact.h"

namespace impulse::inline IMPULSE_PRECISION {

struct BodySet;

/// Where the normal of a contact comes from, at the poses in which its points were found.
NormalOf owner(const Contact& contact, const BodySet& bodies);

}  // namespace impulse::inline IMPULSE_PRECISION
