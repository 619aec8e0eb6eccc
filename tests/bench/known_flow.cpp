#include "known_flow.h"

#include <cstdint>
#include <fstream>
#include <memory>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>

#include "flownav/core/camera_model.h"
#include "flownav/flow/kernel.h"
#include "flownav/math/units.h"
#include "flownav/testing/camera.h"
#include "flownav/testing/presets.h"
#include "flownav/testing/scene.h"
#include "sample.h"

namespace flownav::bench {
namespace {

using Eigen::Vector2d;
namespace fs = std::filesystem;

constexpr int rendered_images = 9;
constexpr int first_image = 30;                  // the drive has reached its speed
constexpr double turn_radps = 8.0 * degree_rad;  // maximum: 0.3 degrees, 4 pixels per image
constexpr double speed_mps = 0.4;

/// Fields of one parity, so that the true flow has no half lines.
testing::Scene scene_of_fields() {
    testing::SceneOptions options = testing::common_preset(1);
    options.camera = testing::field_camera(testing::standard_camera(768, 576), testing::Parity::Top);
    options.images = first_image + rendered_images;
    options.turn_radps = turn_radps;
    options.speed_mps = speed_mps;
    return testing::make_scene(options);
}

FlowCase render() {
    const auto scene = std::make_shared<const testing::Scene>(scene_of_fields());
    const flow::BlockLayout layout = flow::place_blocks(RayMapper(scene->options.camera), flow::FlowParams());
    std::vector<testing::GreyImage> images;
    for (int i = 0; i < rendered_images; ++i)
        images.push_back(testing::render_image(*scene, first_image + i));
    FlowCase rendered{"rendered", {}, true};
    for (int i = 0; i + 1 < rendered_images; ++i) {
        const sim::View from = testing::true_view(*scene, first_image + i);
        const sim::View to = testing::true_view(*scene, first_image + i + 1);
        const TrueFlow truth = [scene, from, to](const Vector2d& at_px) -> std::optional<Vector2d> {
            const auto flow = testing::exact_flow(scene->world, from, to, at_px);
            if (!flow || !flow->inside || flow->occluded) return std::nullopt;
            return flow->flow_px;
        };
        const auto k = static_cast<std::size_t>(i);
        rendered.pairs.push_back({images[k], images[k + 1], layout, truth});
    }
    return rendered;
}

fs::path middlebury_folder() {
    return data_folder() / "middlebury";
}

testing::GreyImage read_image(const fs::path& file) {
    const cv::Mat pixels = cv::imread(file.string(), cv::IMREAD_GRAYSCALE);
    if (pixels.empty()) throw std::runtime_error(file.string() + ": no image");
    testing::GreyImage image(pixels.cols, pixels.rows);
    pixels.copyTo(cv::Mat(pixels.rows, pixels.cols, CV_8UC1, image.pixels.data()));
    return image;
}

/// Reads u and v of every pixel, little endian; values over 1e9 are unknown.
cv::Mat2f read_flow(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::int32_t size[3] = {};                            // magic number, width, height
    in.read(reinterpret_cast<char*>(size), sizeof size);  // NOLINT(*-reinterpret-cast)
    if (!in || size[1] < 1 || size[1] > 10000 || size[2] < 1 || size[2] > 10000)
        throw std::runtime_error(file.string() + ": no flow file");
    cv::Mat2f flow(size[2], size[1]);
    in.read(reinterpret_cast<char*>(flow.data),  // NOLINT(*-reinterpret-cast)
            static_cast<std::streamsize>(flow.total() * flow.elemSize()));
    if (!in) throw std::runtime_error(file.string() + ": ends early");
    return flow;
}

/// Mean flow of the four pixels around a place half-way between them.
TrueFlow truth_of(const cv::Mat2f& flow) {
    return [flow](const Vector2d& at_px) -> std::optional<Vector2d> {
        constexpr double known_max_px = 1e9;
        const Eigen::Vector2i low = at_px.array().floor().cast<int>();
        const Eigen::Vector2i high = at_px.array().ceil().cast<int>();
        cv::Vec2d sum;
        for (const int v : {low.y(), high.y()}) {
            for (const int u : {low.x(), high.x()}) {
                const cv::Vec2d one = flow(v, u);
                if (std::abs(one[0]) > known_max_px || std::abs(one[1]) > known_max_px) return std::nullopt;
                sum += one;
            }
        }
        return Vector2d(sum[0] / 4, sum[1] / 4);
    };
}

/// 350 blocks, evenly spaced over the image without the margin of the search window.
flow::BlockLayout grid_layout(int width_px, int height_px) {
    constexpr int columns = 25;
    constexpr int rows = 14;
    constexpr int margin_px = -flow::search_min;
    flow::BlockLayout layout;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const Eigen::Vector2i corner(
                margin_px + column * (width_px - flow::block_px - 2 * margin_px) / (columns - 1),
                margin_px + row * (height_px - flow::block_px - 2 * margin_px) / (rows - 1));
            layout.corner_px.push_back(corner);
            layout.centre_px.emplace_back(corner.cast<double>().array() + (flow::block_px - 1) / 2.0);
            layout.in_ground_window.push_back(0);
        }
    }
    return layout;
}

}  // namespace

const FlowCase& rendered_case() {
    static const FlowCase rendered = render();
    return rendered;
}

std::vector<std::string> middlebury_names() {
    std::vector<std::string> names;
    for (const char* name : {"RubberWhale", "Urban2", "Grove3"})
        if (fs::exists(middlebury_folder() / name / "flow10.flo")) names.emplace_back(name);
    return names;
}

FlowCase middlebury_case(const std::string& name) {
    const fs::path folder = middlebury_folder() / name;
    FlowPair pair{read_image(folder / "frame10.png"),
                  read_image(folder / "frame11.png"),
                  {},
                  truth_of(read_flow(folder / "flow10.flo"))};
    pair.layout = grid_layout(pair.reference.width_px, pair.reference.height_px);
    return {name, {pair}, false};
}

}  // namespace flownav::bench
