#include "flownav/io/live_fields.h"

#include "field_feed.h"

namespace flownav::io {
namespace {

constexpr std::uint64_t rejected_images_max = 100;  ///< limit of rejected images without a field

}  // namespace

struct LiveFields::Impl {
    explicit Impl(const ProducerSettings& of)
        : settings(of),
          maker(of.config.camera, of.config.input,
                of.grabber_type == "rawlog" ? EventTimes::Mode::Recording : EventTimes::Mode::Live),
          feed(of.grabber_type == "rawlog" ? open_rawlog(of) : open_camera(of)) {}

    /// Reads one more observation, or the end.
    void advance() {
        const auto observation = feed->next();
        maker.count_objects(feed->objects());
        if (observation) {
            maker.consume(observation, feed->images_directory());
            end_when_all_images_are_rejected();
        } else {
            maker.finish();
            end(feed->error());
        }
    }

    void end_when_all_images_are_rejected() {
        const InputCounts& counts = maker.counts();
        const std::uint64_t rejected = counts.images - counts.fields;
        if (settings.grabber_type != "rawlog" && counts.fields == 0 && rejected > rejected_images_max)
            end("");
    }

    void end(const std::string& why) {
        ended = true;
        error = why;
    }

    ProducerSettings settings;
    EventMaker maker;
    std::unique_ptr<FieldFeed> feed;
    bool ended = false;  ///< the feed has ended
    bool told = false;   ///< next() has returned the end
    std::string error;
};

LiveFields::LiveFields(const ProducerSettings& settings) : impl_(std::make_unique<Impl>(settings)) {}
LiveFields::~LiveFields() = default;
LiveFields::LiveFields(LiveFields&&) noexcept = default;
LiveFields& LiveFields::operator=(LiveFields&&) noexcept = default;

std::optional<SensorEvent> LiveFields::next() {
    auto event = impl_->maker.next();
    while (!event && !impl_->ended) {
        try {
            impl_->advance();
        } catch (const config::ConfigError& error) {
            impl_->maker.finish();
            impl_->end(std::string(error.what()) +
                       " (in the section of the sensor: camera.KEY = VALUE, or flownav_config = FILE)");
        }
        event = impl_->maker.next();
    }
    impl_->told = !event;
    const bool ended_without_field = impl_->told && impl_->error.empty() && counts().fields == 0;
    if (ended_without_field)
        impl_->error = why_no_field(counts(), settings().source, settings().config.camera.camera_label);
    return event;
}

bool LiveFields::ended() const {
    return impl_->told;
}

const std::string& LiveFields::error() const {
    return impl_->error;
}

std::vector<std::string> LiveFields::notes() const {
    return impl_->feed->notes();
}

const ProducerSettings& LiveFields::settings() const {
    return impl_->settings;
}

const InputCounts& LiveFields::counts() const {
    return impl_->maker.counts();
}

}  // namespace flownav::io
