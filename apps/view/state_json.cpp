#include "state_json.h"

#include <nlohmann/json.hpp>

#include "flownav/core/strip_counts.h"

namespace flownav::view {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Eigen::Vector2d& v) {
    return {v.x(), v.y()};
}

Json json_of(const pipeline::BlockRecord& block, const std::optional<SadWindow>& window) {
    Json json = {{"fate", to_string(block.label)},
                 {"at_px", json_of(block.vector.at_px)},
                 {"flow_px", json_of(block.vector.flow_px)},
                 {"predicted_px", json_of(block.predicted_px)},
                 {"confidence", block.vector.confidence},
                 {"excess_px", block.excess_px},
                 {"fresh", block.fresh}};
    if (window) {
        json["sad"] = {{"minimum", window->match.minimum},
                       {"second", window->match.second},
                       {"at", {window->match.mu, window->match.nu}},
                       {"bias_px", {window->bias_px.x(), window->bias_px.y()}}};
    }
    return json;
}

Json json_of(const ContactScan& scan) {
    const StripCounts counts = counts_of(scan);
    return {{"gate", to_string(scan.gate)},
            {"free", counts.free},
            {"obstacle", counts.obstacle},
            {"unknown", counts.unknown}};
}

Json json_of(const config::Config& config) {
    return {{"confidence_min", config.pipeline.flow.confidence_min},
            {"blocks", config.pipeline.flow.blocks},
            {"focus_exclusion", config.pipeline.flow.focus_exclusion},
            {"tau_px", config.pipeline.obstacles.tau_px},
            {"lambda_px", config.pipeline.obstacles.lambda_px},
            {"neighbours", config.pipeline.obstacles.neighbours},
            {"cycle_images", config.pipeline.rate.cycle_images}};
}

}  // namespace

std::string state_json(const ViewModel& model) {
    const Frame& frame = model.frame();
    const pipeline::Step& step = frame.step;
    Json json = {{"field", frame.index},
                 {"timestamp_s", step.timestamp_s},
                 {"status", to_string(step.status)},
                 {"preview", frame.preview},
                 {"omega_radps", step.omega_radps},
                 {"v_mps", step.v_mps},
                 {"image_of_cycle", step.image_of_cycle},
                 {"confident", step.counts.confident},
                 {"obstacle_blocks", step.counts.obstacle},
                 {"obstacle_points", step.obstacles.size()},
                 {"contacts", json_of(frame.contacts.scan())},
                 {"pose", {step.T_start_robot.x_m, step.T_start_robot.y_m, step.T_start_robot.yaw_rad}},
                 {"playing", model.playing()},
                 {"speed", model.speed()},
                 {"fields_known", model.timeline().rows.size()},
                 {"fields_current", model.timeline().current},
                 {"complete", model.timeline().complete},
                 {"end", model.timeline().end_text()},
                 {"parameters", json_of(model.config())}};
    if (const auto block = model.hovered_block()) {
        json["hovered"] = json_of(step.blocks[*block], model.hovered_window());
        json["hovered"]["block"] = *block;
    }
    return json.dump();
}

}  // namespace flownav::view
