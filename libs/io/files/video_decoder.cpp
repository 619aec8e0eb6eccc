#include "video_decoder.h"

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/display.h>
#include <libswscale/swscale.h>
}

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include "flownav/io/errors.h"

namespace flownav::io {
namespace {

struct Free {
    void operator()(AVFormatContext* format) const { avformat_close_input(&format); }
    void operator()(AVCodecContext* codec) const { avcodec_free_context(&codec); }
    void operator()(AVPacket* packet) const { av_packet_free(&packet); }
    void operator()(AVFrame* frame) const { av_frame_free(&frame); }
    void operator()(SwsContext* scaler) const { sws_freeContext(scaler); }
};

template <class Type>
using Owned = std::unique_ptr<Type, Free>;

/// Opens a file and finds its streams; null when it is no video.
Owned<AVFormatContext> open_format(const std::string& file) {
    av_log_set_level(AV_LOG_QUIET);  // the messages are this class's
    AVFormatContext* opened = nullptr;
    if (avformat_open_input(&opened, file.c_str(), nullptr, nullptr) < 0) return nullptr;
    Owned<AVFormatContext> format(opened);
    if (avformat_find_stream_info(format.get(), nullptr) < 0) return nullptr;
    return format;
}

Owned<AVCodecContext> open_codec(const AVStream& stream) {
    const AVCodec* codec = avcodec_find_decoder(stream.codecpar->codec_id);
    if (codec == nullptr) return nullptr;
    Owned<AVCodecContext> context(avcodec_alloc_context3(codec));
    if (!context || avcodec_parameters_to_context(context.get(), stream.codecpar) < 0) return nullptr;
    context->thread_count = 0;  // as many as there are processors
    if (avcodec_open2(context.get(), codec, nullptr) < 0) return nullptr;
    return context;
}

std::optional<double> usual_rate(const AVRational& rate) {
    const double rate_hz = rate.den > 0 ? av_q2d(rate) : 0.0;
    if (!(rate_hz >= 1.0 && rate_hz <= 1000.0)) return std::nullopt;
    return rate_hz;
}

/// Reads the rotation tag.
void read_rotation(const AVStream& stream, VideoFacts& facts) {
    std::size_t size = 0;
    const std::uint8_t* data = av_stream_get_side_data(&stream, AV_PKT_DATA_DISPLAYMATRIX, &size);
    if (data == nullptr || size < 9 * sizeof(std::int32_t)) return;
    const auto* matrix = reinterpret_cast<const std::int32_t*>(data);
    const double clockwise_deg = -av_display_rotation_get(matrix);
    if (!std::isfinite(clockwise_deg)) return;
    const double determinant =
        static_cast<double>(matrix[0]) * matrix[4] - static_cast<double>(matrix[1]) * matrix[3];
    const double quarter = std::round(clockwise_deg / 90.0);
    facts.odd_rotation = determinant < 0 || std::abs(clockwise_deg - 90.0 * quarter) > 1.0;
    if (!facts.odd_rotation) facts.turn_deg = (static_cast<int>(quarter) * 90 + 360) % 360;
}

/// True for a container of this kind.
bool has_name(const AVFormatContext& format, const char* name) {
    return std::string(format.iformat->name).find(name) != std::string::npos;
}

/// Number of compressed images by the header; 0: not told. An mp4 may leave out some of those that its header
/// counts, by its edit list: its index holds the others.
std::uint64_t images_told(const AVFormatContext& format, const AVStream& stream) {
    const std::int64_t count =
        has_name(format, "mp4") ? avformat_index_get_entries_count(&stream) : stream.nb_frames;
    return count > 0 ? static_cast<std::uint64_t>(count) : 0;
}

VideoFacts facts_of(const AVFormatContext& format, const AVStream& stream) {
    VideoFacts facts;
    const AVRational& mean = stream.avg_frame_rate;
    facts.rate_hz = usual_rate(mean.num > 0 && mean.den > 0 ? mean : stream.r_frame_rate);
    facts.has_times = (format.iformat->flags & AVFMT_NOTIMESTAMPS) == 0 && facts.rate_hz;
    if (!facts.has_times) facts.rate_hz.reset();
    facts.images = images_told(format, stream);
    read_rotation(stream, facts);
    return facts;
}

cv::Mat turned(const cv::Mat& image, int turn_deg) {
    if (turn_deg == 0) return image;
    cv::Mat result;
    cv::rotate(image, result,
               turn_deg == 90    ? cv::ROTATE_90_CLOCKWISE
               : turn_deg == 180 ? cv::ROTATE_180
                                 : cv::ROTATE_90_COUNTERCLOCKWISE);
    return result;
}

}  // namespace

struct VideoDecoder::Parts {
    Owned<AVFormatContext> format;
    Owned<AVCodecContext> codec;
    Owned<SwsContext> scaler;
    Owned<AVPacket> packet{av_packet_alloc()};
    Owned<AVFrame> frame{av_frame_alloc()};
    AVStream* stream = nullptr;
    VideoFacts facts;
    std::uint64_t packets = 0;
    std::uint64_t periods = 0;  ///< up to the last packet, where stamps count them
    std::uint64_t damaged = 0;
    bool flushing = false;

    /// Gives the decoder one more packet of the video; after the last one asks it for all that it holds.
    void feed() {
        const int status = av_read_frame(format.get(), packet.get());
        if (status < 0) {
            flushing = true;
            avcodec_send_packet(codec.get(), nullptr);
            return;
        }
        if (packet->stream_index == stream->index) send();
        av_packet_unref(packet.get());
    }

    /// Gives the packet to the decoder, unless it is incomplete or repeats an image.
    void send() {
        const bool whole = (packet->flags & AV_PKT_FLAG_CORRUPT) == 0;
        if (!whole) ++damaged;
        if (!whole || packet->size == 0) return;
        ++packets;
        if (packet->dts >= 0) periods = static_cast<std::uint64_t>(packet->dts) + 1;
        if (avcodec_send_packet(codec.get(), packet.get()) < 0) ++damaged;
    }

    /// Decodes the next image into `frame`; false at the end.
    bool decode() {
        while (true) {
            const int status = avcodec_receive_frame(codec.get(), frame.get());
            if (status == 0) return true;
            if (status == AVERROR_EOF) return false;
            if (status != AVERROR(EAGAIN)) {
                ++damaged;
                if (flushing) return false;
            }
            if (flushing) continue;
            feed();
        }
    }

    cv::Mat grey() {
        const int width = frame->width;
        const int height = frame->height;
        const auto pixels = static_cast<AVPixelFormat>(frame->format);
        scaler.reset(sws_getCachedContext(scaler.release(), width, height, pixels, width, height,
                                          AV_PIX_FMT_BGR24, SWS_BICUBIC, nullptr, nullptr, nullptr));
        if (!scaler) return {};
        cv::Mat colour(height, width, CV_8UC3);
        std::uint8_t* lines[4] = {colour.data, nullptr, nullptr, nullptr};
        const int strides[4] = {static_cast<int>(colour.step), 0, 0, 0};
        sws_scale(scaler.get(), frame->data, frame->linesize, 0, height, lines, strides);
        cv::Mat result;
        cv::cvtColor(colour, result, cv::COLOR_BGR2GRAY);
        return turned(result, facts.turn_deg);
    }
};

VideoDecoder::VideoDecoder(const std::filesystem::path& file) : parts_(std::make_unique<Parts>()) {
    if (!std::filesystem::exists(file)) throw InputError(file.string() + ": no such file");
    if (!std::filesystem::is_regular_file(file)) throw InputError(file.string() + ": is not a file");
    Parts& p = *parts_;
    p.format = open_format("file:" + file.string());
    const int index =
        p.format ? av_find_best_stream(p.format.get(), AVMEDIA_TYPE_VIDEO, -1, -1, nullptr, 0) : -1;
    if (index >= 0) {
        p.stream = p.format->streams[index];
        p.codec = open_codec(*p.stream);
    }
    if (!p.codec || !p.packet || !p.frame) throw InputError(file.string() + ": cannot be read as a video");
    p.facts = facts_of(*p.format, *p.stream);
}

VideoDecoder::~VideoDecoder() = default;

std::optional<VideoImage> VideoDecoder::next() {
    Parts& p = *parts_;
    while (p.decode()) {
        VideoImage image;
        const bool whole = p.frame->decode_error_flags == 0 && (p.frame->flags & AV_FRAME_FLAG_CORRUPT) == 0;
        if (whole) image.grey = p.grey();
        if (image.grey.empty()) {
            ++p.damaged;
            continue;
        }
        const std::int64_t stamp = p.frame->best_effort_timestamp;
        if (p.facts.has_times && stamp != AV_NOPTS_VALUE)
            image.time_s = static_cast<double>(stamp) * av_q2d(p.stream->time_base);
        image.interlaced = p.frame->interlaced_frame != 0;
        image.top_field_first = p.frame->top_field_first != 0;
        av_frame_unref(p.frame.get());
        return image;
    }
    return std::nullopt;
}

const VideoFacts& VideoDecoder::facts() const {
    return parts_->facts;
}

std::string VideoDecoder::cut_short() const {
    const Parts& p = *parts_;
    const std::uint64_t told = p.facts.images;
    if (told == 0) return "";
    // An AVI counts periods of its rate; those without an image hold no packet.
    const std::uint64_t seen = has_name(*p.format, "avi") ? p.periods : p.packets;
    const std::uint64_t tolerance = has_name(*p.format, "mp4") ? 0 : std::max<std::uint64_t>(1, told / 50);
    if (seen + tolerance >= told) return "";
    return "is cut short or damaged, it should hold " + std::to_string(told) + " images and ends after " +
           std::to_string(seen);
}

std::uint64_t VideoDecoder::damaged() const {
    return parts_->damaged;
}

}  // namespace flownav::io
