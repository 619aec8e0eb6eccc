#include "mestimate.h"

#include <cstring>
#include <stdexcept>

extern "C" {
#include <libavfilter/avfilter.h>
#include <libavfilter/buffersink.h>
#include <libavfilter/buffersrc.h>
#include <libavutil/frame.h>
#include <libavutil/motion_vector.h>
}

#include "flownav/flow/kernel.h"

namespace flownav::bench {
namespace {

struct FreeFrame {
    void operator()(AVFrame* frame) const { av_frame_free(&frame); }
};
struct FreeGraph {
    void operator()(AVFilterGraph* graph) const { avfilter_graph_free(&graph); }
};
using Frame = std::unique_ptr<AVFrame, FreeFrame>;

void check(bool fine, const char* what) {
    if (!fine) throw std::runtime_error(std::string("mestimate: FFmpeg cannot ") + what);
}

AVFilterContext* add_filter(AVFilterGraph* graph, const char* filter, const std::string& options) {
    AVFilterContext* context = nullptr;
    const int status = avfilter_graph_create_filter(&context, avfilter_get_by_name(filter), filter,
                                                    options.c_str(), nullptr, graph);
    check(status >= 0, filter);
    return context;
}

Frame frame_of(const ImageView& image, std::int64_t number) {
    Frame frame(av_frame_alloc());
    frame->width = image.width_px;
    frame->height = image.height_px;
    frame->format = AV_PIX_FMT_GRAY8;
    frame->pts = number;
    check(av_frame_get_buffer(frame.get(), 0) >= 0, "allocate a frame");
    for (int v = 0; v < image.height_px; ++v)
        std::memcpy(frame->data[0] + static_cast<std::ptrdiff_t>(v) * frame->linesize[0], image.row(v),
                    static_cast<std::size_t>(image.width_px));
    return frame;
}

}  // namespace

struct Mestimate::Impl {
    std::unique_ptr<AVFilterGraph, FreeGraph> graph;
    AVFilterContext* source = nullptr;
    AVFilterContext* sink = nullptr;
    std::int64_t pushed = 0;
};

Mestimate::Mestimate(int width_px, int height_px, const std::string& method)
    : impl_(std::make_unique<Impl>()) {
    impl_->graph.reset(avfilter_graph_alloc());
    AVFilterGraph* graph = impl_->graph.get();
    graph->nb_threads = 1;
    impl_->source = add_filter(graph, "buffer",
                               "width=" + std::to_string(width_px) + ":height=" + std::to_string(height_px) +
                                   ":pix_fmt=gray:time_base=1/50");
    AVFilterContext* estimate =
        add_filter(graph, "mestimate",
                   "method=" + method + ":mb_size=16:search_param=" + std::to_string(-flow::search_min));
    impl_->sink = add_filter(graph, "buffersink", "");
    check(avfilter_link(impl_->source, 0, estimate, 0) == 0, "link filters");
    check(avfilter_link(estimate, 0, impl_->sink, 0) == 0, "link filters");
    check(avfilter_graph_config(graph, nullptr) >= 0, "configure the filters");
}

Mestimate::~Mestimate() = default;

std::size_t Mestimate::push(const ImageView& image) {
    vectors_.clear();
    const Frame in = frame_of(image, impl_->pushed++);
    check(av_buffersrc_add_frame(impl_->source, in.get()) >= 0, "take a frame");
    const Frame out(av_frame_alloc());
    if (av_buffersink_get_frame(impl_->sink, out.get()) < 0) return 0;  // the filter needs more images
    const AVFrameSideData* side = av_frame_get_side_data(out.get(), AV_FRAME_DATA_MOTION_VECTORS);
    check(side != nullptr, "give motion vectors");
    const std::size_t count = side->size / sizeof(AVMotionVector);
    for (std::size_t i = 0; i < count; ++i) {
        AVMotionVector v;
        std::memcpy(&v, side->data + i * sizeof v, sizeof v);
        if (v.source < 0) continue;
        const Eigen::Vector2d at(v.dst_x - 0.5, v.dst_y - 0.5);  // FFmpeg's centre is the pixel after it
        vectors_.push_back({at, Eigen::Vector2d(v.src_x - v.dst_x, v.src_y - v.dst_y)});
    }
    return count;
}

}  // namespace flownav::bench
