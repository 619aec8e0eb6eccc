#include "methods.h"

#include <memory>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/video/tracking.hpp>

#include "benchmarks.h"
#include "flownav/flow/match_blocks.h"
#include "flownav/flow/matcher.h"

namespace flownav::bench {
namespace {

using Eigen::Vector2d;

/// OpenCV has no read-only images; the methods do not write to this one.
cv::Mat mat_of(const testing::GreyImage& image) {
    return {image.height_px, image.width_px, CV_8UC1, const_cast<std::uint8_t*>(image.pixels.data())};
}

void take(const std::vector<FlowVector>& vectors, MeasuredFlow& measured) {
    const double confidence_min = flow::FlowParams().confidence_min;
    measured.flow_px.resize(vectors.size());
    measured.kept.resize(vectors.size());
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        measured.flow_px[i] = vectors[i].flow_px;
        measured.kept[i] = vectors[i].valid && vectors[i].confidence >= confidence_min ? 1 : 0;
    }
}

/// Matching alone, without brightness compensation.
MeasureFlow blocks(const flow::KernelEntry& kernel, flow::Subpixel subpixel) {
    flow::MatchSettings settings;
    settings.kernel = &kernel;
    settings.subpixel = subpixel;
    return [settings, bias_px = std::vector<Eigen::Vector2i>(), vectors = std::vector<FlowVector>()](
               const FlowPair& pair, MeasuredFlow& measured) mutable {
        bias_px.assign(pair.layout.size(), Eigen::Vector2i::Zero());
        flow::match_blocks(pair.reference.view(), pair.newer.view(), pair.layout, bias_px, settings, vectors);
        take(vectors, measured);
    };
}

/// The sensor's measurement with default settings.
MeasureFlow sensor_default() {
    return [matcher = flow::BlockMatcher(flow::FlowParams(), 1), predicted_px = std::vector<Vector2d>(),
            vectors = std::vector<FlowVector>()](const FlowPair& pair, MeasuredFlow& measured) mutable {
        predicted_px.assign(pair.layout.size(), Vector2d::Zero());
        matcher(pair.reference.view(), pair.newer.view(), pair.layout, predicted_px, vectors);
        take(vectors, measured);
    };
}

std::vector<cv::Point2f> points_of(const flow::BlockLayout& layout) {
    std::vector<cv::Point2f> points;
    for (const Vector2d& centre : layout.centre_px)
        points.emplace_back(static_cast<float>(centre.x()), static_cast<float>(centre.y()));
    return points;
}

/// Defaults of OpenCV: three levels above the image, 30 iterations or 0.01 px.
MeasureFlow pyr_lk(int window_px) {
    return [window_px, to = std::vector<cv::Point2f>(), found = std::vector<std::uint8_t>(),
            residual = std::vector<float>()](const FlowPair& pair, MeasuredFlow& measured) mutable {
        const auto at = points_of(pair.layout);
        cv::calcOpticalFlowPyrLK(mat_of(pair.reference), mat_of(pair.newer), at, to, found, residual,
                                 {window_px, window_px});
        measured.flow_px.resize(at.size());
        measured.kept.assign(found.begin(), found.end());
        for (std::size_t i = 0; i < at.size(); ++i)
            measured.flow_px[i] = Vector2d(to[i].x - at[i].x, to[i].y - at[i].y);
    };
}

/// pyr_lk() without the time for the reference's pyramid, which a tracker keeps from the previous image.
MeasureFlow pyr_lk_with_pyramid(int window_px) {
    struct Ready {
        const FlowPair* pair = nullptr;
        std::vector<cv::Mat> pyramid;
    };
    return [window_px, ready = std::vector<Ready>()](const FlowPair& pair, MeasuredFlow& measured) mutable {
        constexpr int levels = 3;
        const cv::Size window(window_px, window_px);
        const Ready* known = nullptr;
        for (const Ready& one : ready)
            if (one.pair == &pair) known = &one;
        if (known == nullptr) {  // first call, which is not timed
            ready.push_back({&pair, {}});
            cv::buildOpticalFlowPyramid(mat_of(pair.reference), ready.back().pyramid, window, levels);
            known = &ready.back();
        }
        const auto at = points_of(pair.layout);
        std::vector<cv::Point2f> to;
        std::vector<std::uint8_t> found;
        cv::calcOpticalFlowPyrLK(known->pyramid, mat_of(pair.newer), at, to, found, cv::noArray(), window,
                                 levels);
        measured.flow_px.resize(at.size());
        measured.kept.assign(found.begin(), found.end());
        for (std::size_t i = 0; i < at.size(); ++i)
            measured.flow_px[i] = Vector2d(to[i].x - at[i].x, to[i].y - at[i].y);
    };
}

/// Dense flow, averaged at each centre over its four pixels.
MeasureFlow dis() {
    return [method = cv::DISOpticalFlow::create(cv::DISOpticalFlow::PRESET_ULTRAFAST), flow = cv::Mat2f()](
               const FlowPair& pair, MeasuredFlow& measured) mutable {
        flow.release();  // otherwise it would start from the last result
        method->calc(mat_of(pair.reference), mat_of(pair.newer), flow);
        measured.flow_px.clear();
        for (const Eigen::Vector2i& corner : pair.layout.corner_px) {
            const int u = corner.x() + flow::block_px / 2 - 1;
            const int v = corner.y() + flow::block_px / 2 - 1;
            const cv::Vec2f sum = flow(v, u) + flow(v, u + 1) + flow(v + 1, u) + flow(v + 1, u + 1);
            measured.flow_px.emplace_back(sum[0] / 4, sum[1] / 4);
        }
        measured.kept.assign(pair.layout.size(), 1);
    };
}

/// The smallest sum of squared differences over the same window, in whole pixels.
MeasureFlow match_template() {
    return [cost = cv::Mat()](const FlowPair& pair, MeasuredFlow& measured) mutable {
        const cv::Mat from = mat_of(pair.reference);
        const cv::Mat to = mat_of(pair.newer);
        measured.flow_px.clear();
        for (const Eigen::Vector2i& corner : pair.layout.corner_px) {
            const cv::Rect block(corner.x(), corner.y(), flow::block_px, flow::block_px);
            const cv::Rect window =
                cv::Rect(block.x + flow::search_min, block.y + flow::search_min,
                         flow::block_px + flow::search_px - 1, flow::block_px + flow::search_px - 1) &
                cv::Rect({}, to.size());
            cv::matchTemplate(to(window), from(block), cost, cv::TM_SQDIFF);
            cv::Point best;
            cv::minMaxLoc(cost, nullptr, nullptr, &best);
            measured.flow_px.emplace_back(window.x + best.x - block.x, window.y + best.y - block.y);
        }
        measured.kept.assign(pair.layout.size(), 1);
    };
}

}  // namespace

std::vector<FlowMethod> all_methods() {
    std::vector<FlowMethod> methods;
    for_each_kernel([&](const flow::KernelEntry& kernel) {
        methods.push_back({std::string("flownav-integer-") + kernel.name,
                           [&kernel] { return blocks(kernel, flow::Subpixel::None); }});
    });
    methods.push_back({"flownav-V", [] { return blocks(flow::select_kernel(), flow::Subpixel::V); }});
    methods.push_back({"flownav-default", sensor_default});
    for (const int window_px : {16, 21}) {
        const std::string size = std::to_string(window_px);
        methods.push_back({"PyrLK-" + size, [window_px] { return pyr_lk(window_px); }});
        methods.push_back(
            {"PyrLK-" + size + "-pyramid", [window_px] { return pyr_lk_with_pyramid(window_px); }});
    }
    methods.push_back({"DIS-ultrafast", dis});
    methods.push_back({"matchTemplate", match_template});
    return methods;
}

}  // namespace flownav::bench
