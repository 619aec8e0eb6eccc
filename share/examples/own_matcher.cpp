// A matcher of one's own: own_matcher INPUT.rawlog registers the matcher "zero_mean", selects it by the key
// flow.matcher, and prints how many fields of the rawlog gave a motion.
#include <flownav/config/make_state.h>
#include <flownav/flow/block_bounds.h>
#include <flownav/flow/matcher_registry.h>
#include <flownav/io/field_source.h>

#include <cstdio>
#include <cstdlib>
#include <limits>

namespace {

using flownav::ImageView;

/// Sum of absolute differences of two 16x16 blocks (top left pixels `a` and `b`) after their means are
/// removed.
int zero_mean_cost(const ImageView& from, const Eigen::Vector2i& a, const ImageView& to,
                   const Eigen::Vector2i& b) {
    constexpr int n = flownav::flow::block_px;
    int sum = 0;
    for (int i = 0; i < n * n; ++i)
        sum += to.at(b.x() + i % n, b.y() + i / n) - from.at(a.x() + i % n, a.y() + i / n);
    int cost = 0;
    for (int i = 0; i < n * n; ++i)
        cost += std::abs(to.at(b.x() + i % n, b.y() + i / n) - from.at(a.x() + i % n, a.y() + i / n) -
                         sum / (n * n));
    return cost;
}

/// Searches whole pixels up to 8 px about the predicted flow.
flownav::FlowVector match(const ImageView& from, const ImageView& to, const Eigen::Vector2i& corner_px,
                          const Eigen::Vector2d& centre_px, const Eigen::Vector2i& bias_px) {
    using flownav::flow::contains_block;
    constexpr int reach_px = 8;
    flownav::FlowVector vector;
    vector.at_px = centre_px;
    if (!contains_block(from, corner_px)) return vector;
    int best = std::numeric_limits<int>::max();
    double sum = 0.0;
    int tried = 0;
    for (int dv = -reach_px; dv <= reach_px; ++dv) {
        for (int du = -reach_px; du <= reach_px; ++du) {
            const Eigen::Vector2i shift = bias_px + Eigen::Vector2i(du, dv);
            if (!contains_block(to, corner_px, shift)) continue;
            const int cost = zero_mean_cost(from, corner_px, to, corner_px + shift);
            sum += cost;
            ++tried;
            if (cost >= best) continue;
            best = cost;
            vector.flow_px = shift.cast<double>();
        }
    }
    vector.valid = tried > 0;
    if (sum > 0.0) vector.confidence = 1.0 - best * tried / sum;
    return vector;
}

void match_zero_mean(const ImageView& reference, const ImageView& newer,
                     const flownav::flow::BlockLayout& layout,
                     const std::vector<Eigen::Vector2d>& predicted_px,
                     std::vector<flownav::FlowVector>& vectors) {
    vectors.resize(layout.size());
    for (std::size_t i = 0; i < layout.size(); ++i)
        vectors[i] = match(reference, newer, layout.corner_px[i], layout.centre_px[i],
                           flownav::flow::whole_px(predicted_px[i]));
}

}  // namespace

int main(int argc, char** argv) try {
    if (argc != 2) throw std::invalid_argument("usage: own_matcher INPUT.rawlog");
    flownav::flow::register_matcher("zero_mean", [](const auto&, int) { return match_zero_mean; });
    flownav::config::Config config;
    flownav::config::set_config_value(config, "flow.matcher", "zero_mean");
    flownav::io::RawlogReader reader(argv[1]);
    flownav::io::FieldSource source(reader, config.camera);
    flownav::pipeline::State state = flownav::config::make_state(config);
    int fields = 0;
    int measured = 0;
    while (const auto event = source.next()) {
        const auto* field = std::get_if<flownav::Field>(&*event);
        if (field == nullptr) continue;  // a pose
        ++fields;
        measured += flownav::pipeline::step(state, *field).status == flownav::FieldStatus::Ok;
    }
    std::printf("%d of %d fields measured\n", measured, fields);
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
