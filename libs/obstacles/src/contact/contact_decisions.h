#pragma once
#include "flownav/obstacles/contact_scanner.h"

namespace flownav::obstacles {

/// Votes and walls become obstacles when an earlier scan saw them too, or when the votes are many. Forgets
/// the places that are too old to confirm others.
void decide_obstacles(ContactMemory& memory, const ContactParams& params, ContactScan& out);

/// The inside of a surface of one colour has no votes: a strip between two contacts of one surface is one as
/// well.
void fill_holes(ContactScan& out);

/// Floor is free up to its end, and not beyond the contacts of this strip and its neighbours.
void decide_floor(const ContactMemory& memory, ContactScan& out);

}  // namespace flownav::obstacles
