#pragma once

#include "solver/lanes/contact_frame.h"

namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES {

void lay_out_contacts(const ContactTable& table, const LayoutInput& input);
void store_contacts(const ContactTable& table, const LayoutInput& input);

}  // namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES
