#include "score.h"

namespace flownav::fidelity {

void Score::add(const Score& other) {
    ego.add(other.ego);
    points.add(other.points);
    blocks.add(other.blocks);
    map.add(other.map);
}

Score evaluate(const RenderedScene& drive, const config::Config& config) {
    EgoWatcher ego;
    PointWatcher points;
    BlockWatcher blocks;
    MapWatcher map(config.map);
    run_chain(drive, config, [&](const Moment& moment) {
        ego.see(moment);
        points.see(moment);
        blocks.see(moment);
        map.see(moment);
    });
    return {ego.result(), points.result(), blocks.result(), map.result(drive.scene.world)};
}

}  // namespace flownav::fidelity
