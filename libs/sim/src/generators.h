#pragma once

#include "flownav/sim/random.h"
#include "flownav/sim/world.h"

namespace flownav::sim {

// Each draws one world; whether it can be crossed is another's question.
World draw_corridor(Random& random);
World draw_office(Random& random);
World draw_hall(Random& random);
World draw_forest(Random& random);
World draw_stairs(Random& random);
World draw_ramp(Random& random);

}  // namespace flownav::sim
