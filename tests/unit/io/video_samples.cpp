#include "video_samples.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/display.h>
}

#include <algorithm>
#include <memory>
#include <string>

namespace flownav::testing {
namespace {

struct Free {
    void operator()(AVFormatContext* format) const {
        if (format->pb != nullptr) avio_closep(&format->pb);
        avformat_free_context(format);
    }
    void operator()(AVCodecContext* codec) const { avcodec_free_context(&codec); }
    void operator()(AVPacket* packet) const { av_packet_free(&packet); }
    void operator()(AVFrame* frame) const { av_frame_free(&frame); }
};

template <class Type>
using Owned = std::unique_ptr<Type, Free>;

Owned<AVCodecContext> encoder(const VideoSample& sample, const cv::Mat& image, bool global_header) {
    const AVCodec* codec = avcodec_find_encoder_by_name(sample.codec);
    if (codec == nullptr) return nullptr;
    Owned<AVCodecContext> context(avcodec_alloc_context3(codec));
    const bool jpeg = std::string(sample.codec) == "mjpeg";
    context->width = image.cols;
    context->height = image.rows;
    context->pix_fmt = jpeg ? AV_PIX_FMT_YUVJ420P : AV_PIX_FMT_YUV420P;
    context->time_base = sample.rate_hz > 0 ? AVRational{1, sample.rate_hz} : AVRational{1, 1000};
    context->framerate = {25, 1};
    context->max_b_frames = sample.b_frames;
    context->bit_rate = 4000000;
    context->strict_std_compliance = FF_COMPLIANCE_UNOFFICIAL;
    if (sample.top_field_first) context->flags |= AV_CODEC_FLAG_INTERLACED_DCT | AV_CODEC_FLAG_INTERLACED_ME;
    if (global_header) context->flags |= AV_CODEC_FLAG_GLOBAL_HEADER;
    return avcodec_open2(context.get(), codec, nullptr) < 0 ? nullptr : std::move(context);
}

Owned<AVFrame> frame_of(const cv::Mat& image, const AVCodecContext& context, std::int64_t pts,
                        bool top_field_first) {
    Owned<AVFrame> frame(av_frame_alloc());
    frame->format = context.pix_fmt;
    frame->width = image.cols;
    frame->height = image.rows;
    av_frame_get_buffer(frame.get(), 0);
    for (int v = 0; v < image.rows; ++v)
        for (int u = 0; u < image.cols; ++u)
            frame->data[0][v * frame->linesize[0] + u] = image.at<std::uint8_t>(v, u);
    for (const int plane : {1, 2})
        for (int v = 0; v < image.rows / 2; ++v)
            for (int u = 0; u < image.cols / 2; ++u) frame->data[plane][v * frame->linesize[plane] + u] = 128;
    frame->pts = pts;
    frame->interlaced_frame = top_field_first ? 1 : 0;
    frame->top_field_first = top_field_first ? 1 : 0;
    return frame;
}

void write_packets(AVCodecContext& codec, AVFormatContext& format, const AVStream& stream) {
    const Owned<AVPacket> packet(av_packet_alloc());
    while (avcodec_receive_packet(&codec, packet.get()) == 0) {
        packet->duration = std::max<std::int64_t>(1, av_rescale_q(40, {1, 1000}, codec.time_base));
        av_packet_rescale_ts(packet.get(), codec.time_base, stream.time_base);
        packet->stream_index = stream.index;
        av_interleaved_write_frame(&format, packet.get());
    }
}

}  // namespace

bool write_timed_video(const std::filesystem::path& file, const std::vector<cv::Mat>& images,
                       const VideoSample& sample) {
    av_log_set_level(AV_LOG_QUIET);
    AVFormatContext* opened = nullptr;
    if (avformat_alloc_output_context2(&opened, nullptr, sample.format, file.c_str()) < 0) return false;
    const Owned<AVFormatContext> format(opened);
    const bool global_header = (format->oformat->flags & AVFMT_GLOBALHEADER) != 0;
    const auto codec = encoder(sample, images.front(), global_header);
    AVStream* stream = codec ? avformat_new_stream(format.get(), nullptr) : nullptr;
    if (stream == nullptr) return false;
    avcodec_parameters_from_context(stream->codecpar, codec.get());
    stream->time_base = codec->time_base;
    if (sample.rotation_deg != 0) {
        auto* matrix = av_stream_new_side_data(stream, AV_PKT_DATA_DISPLAYMATRIX, 9 * sizeof(std::int32_t));
        av_display_rotation_set(reinterpret_cast<std::int32_t*>(matrix), sample.rotation_deg);
    }
    if (avio_open(&format->pb, file.c_str(), AVIO_FLAG_WRITE) < 0) return false;
    if (avformat_write_header(format.get(), nullptr) < 0) return false;
    for (std::size_t i = 0; i < images.size(); ++i) {
        std::int64_t pts = av_rescale_q(sample.stamps_ms.at(i), {1, 1000}, codec->time_base);
        if (i > 0 && sample.stamps_ms.at(i) == sample.stamps_ms.at(i - 1)) pts = static_cast<std::int64_t>(i);
        const auto frame = frame_of(images[i], *codec, pts, sample.top_field_first);
        if (avcodec_send_frame(codec.get(), frame.get()) < 0) return false;
        write_packets(*codec, *format, *stream);
    }
    avcodec_send_frame(codec.get(), nullptr);
    write_packets(*codec, *format, *stream);
    return av_write_trailer(format.get()) == 0;
}

}  // namespace flownav::testing
